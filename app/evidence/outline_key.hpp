// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/model/place.hpp"

namespace planum::app {

/// What the label of a region is made from, as a part of keys of caches. The unit stands there by id, so a new unit in
/// the list moves nothing.
[[nodiscard]] std::string outline_key(const model::Region& region);

} // namespace planum::app
