// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "core/sqlite/database.hpp"
#include "core/store/project_file.hpp"

namespace planum::store {

/// Everything ProjectFile::open promises, in this order: header, interrupted change, write-ahead mode, schema
/// version, tables and triggers against the reference, then (for writing) repairs.
[[nodiscard]] std::unique_ptr<ProjectFile::State> open_project(const std::filesystem::path& file, OpenMode mode,
                                                               const Environment& environment);

/// Settings of a connection that writes: rollback journal, full synchronisation, no spilling.
void prepare_for_writing(const sqlite::Database& database);

} // namespace planum::store
