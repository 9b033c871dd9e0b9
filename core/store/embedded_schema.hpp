// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace planum::store {

/// One migration as it stands in schema/sql, put into the program at build time.
struct EmbeddedMigration {
    std::string name; ///< `0001_project.sql`
    std::string sql;
};

/// All migrations in order.
[[nodiscard]] std::vector<EmbeddedMigration> embedded_migrations();

} // namespace planum::store
