// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/store/project_file.hpp"

namespace planum::test {

/// One change of one to six random steps, each an insert, update or removal of some kind of record. The same
/// seed on the same record does the same. May turn out to change nothing.
void make_random_change(store::ProjectFile& project, std::uint32_t seed);

} // namespace planum::test
