// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/base/progress.hpp"
#include "core/sqlite/database.hpp"

namespace planum::sqlite {

/// Copies a database page by page with SQLite's backup API into a new file, while others may go on reading.
/// The target must not exist. Throws Io, or Cancelled; the caller removes what is left then.
void copy_database(const Database& source, const std::filesystem::path& target, Progress& progress);

} // namespace planum::sqlite
