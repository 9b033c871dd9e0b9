// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "core/model/record.hpp"
#include "core/sqlite/database.hpp"
#include "core/store/removed_records.hpp"

namespace planum::store {

/// The living record, sorted. What refers to a record that was deleted (in QGIS, say) refers to none, and
/// what makes no sense without it is left out; forget_zero_heights() was done. Throws BadInput naming the table for
/// what cannot be read.
[[nodiscard]] model::Record load_record(const sqlite::Database& database);

/// What was deleted since a moment (ISO, or its beginning: a day).
[[nodiscard]] RemovedRecords load_removed(const sqlite::Database& database, std::string_view since);

[[nodiscard]] model::ProjectSettings load_settings(const sqlite::Database& database);

} // namespace planum::store
