// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/sqlite/database.hpp"

namespace planum::store {

inline constexpr std::uint32_t kApplicationId = 0x47504B47; // "GPKG"
inline constexpr std::uint32_t kGeoPackageVersion = 10300;

/// Every table that holds records: audited, soft-deleted, undone. In an order in which no row refers to a
/// later table.
[[nodiscard]] const std::vector<std::string>& record_tables();

/// Those of them that are map layers; their geometry column is `geom`.
inline constexpr std::array<std::string_view, 5> kFeatureTables = {"region", "find", "level", "section", "scan_pose"};

/// Makes all tables in an empty database: every migration in order.
void create_schema(const sqlite::Database& database);

/// Runs the migrations newer than `version`, up to and with `last`. Inside the caller's transaction.
void migrate(const sqlite::Database& database, std::int64_t version, std::int64_t last);

/// Throws BadInput when there is none.
[[nodiscard]] std::int64_t read_schema_version(const sqlite::Database& database);

/// How a file's tables, indexes, triggers and views differ from ours.
struct SchemaFindings {
    std::vector<std::string> import_only_because; ///< sentences; not empty: nothing may be written
    std::vector<std::string> missing_sql;         ///< our triggers and indexes that somebody dropped
    std::vector<std::string> missing_names;
    std::vector<std::string> rtree_tables; ///< R-trees of the standard's form on our layers: layer names
};

/// Compares with a fresh reference of schema `version` in memory. Tables that are not ours are left out of it, as are
/// the exact templates of the GeoPackage standard. Throws BadInput when a table of ours or a column is missing.
[[nodiscard]] SchemaFindings examine_schema(const sqlite::Database& database, std::int64_t version);

/// Drops an R-tree index with its triggers and its entry in gpkg_extensions.
void drop_rtree(const sqlite::Database& database, std::string_view layer);

} // namespace planum::store
