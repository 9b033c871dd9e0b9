// SPDX-License-Identifier: MIT
#include "core/store/schema.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/store/embedded_schema.hpp"
#include "core/store/project_file.hpp"

namespace planum::store {

namespace {

struct SchemaItem {
    std::string type;
    std::string table;
    std::string sql;
};

using SchemaItems = std::map<std::string, SchemaItem, std::less<>>;

SchemaItems read_items(const sqlite::Database& database) {
    SchemaItems items;
    sqlite::Statement rows =
        database.prepare("SELECT name, type, tbl_name, sql FROM sqlite_schema WHERE sql IS NOT NULL");
    while (rows.step()) {
        items.emplace(std::string{rows.text(0)},
                      SchemaItem{std::string{rows.text(1)}, std::string{rows.text(2)}, std::string{rows.text(3)}});
    }
    return items;
}

std::int64_t number_of(const EmbeddedMigration& migration) {
    return text::parse_integer(std::string_view{migration.name}.substr(0, 4)).value_or(0);
}

// Columns added by another program stand together at one place of the text, so what is before and what is
// after that place must together be the whole of ours.
bool is_ours_perhaps_longer(std::string_view ours, std::string_view theirs) {
    if (theirs.size() < ours.size()) return false;
    const auto [our_difference, their_difference] = std::mismatch(ours.begin(), ours.end(), theirs.begin());
    const auto prefix = static_cast<std::size_t>(our_difference - ours.begin());
    std::size_t suffix = 0;
    while (suffix < ours.size() - prefix && ours[ours.size() - 1 - suffix] == theirs[theirs.size() - 1 - suffix]) {
        ++suffix;
    }
    return prefix + suffix >= ours.size();
}

void check_table(const sqlite::Database& database, const sqlite::Database& reference, const std::string& name,
                 const SchemaItem& ours, const SchemaItem* theirs, SchemaFindings& findings) {
    if (theirs == nullptr || theirs->type != "table" || theirs->sql.starts_with("CREATE VIRTUAL")) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("{}: the table {} is missing: not a whole Planum project", database.name(), name));
    }
    if (is_ours_perhaps_longer(ours.sql, theirs->sql)) return;
    const std::vector<std::string> columns = database.columns(name);
    for (const std::string& column : reference.columns(name)) {
        if (std::find(columns.begin(), columns.end(), column) == columns.end()) {
            throw Error(ErrorCode::BadInput, fmt::format("{}: the table {} has no column {}: another program "
                                                         "rebuilt it; restore a backup",
                                                         database.name(), name, column));
        }
    }
    findings.import_only_because.push_back(fmt::format("the table {} was rebuilt by another program", name));
}

std::string rtree_name(std::string_view layer) { return fmt::format("rtree_{}_geom", layer); }

/// Text without regard to blanks, quotes and case, as programs differ in these when they fill in a template.
std::string squeezed(std::string_view sql) {
    std::string out;
    for (const char c : sql) {
        if (c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '"' || c == ';') continue;
        out += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return out;
}

/// The standard's R-tree of a layer (GeoPackage 1.3 and 1.4, annex F.3): name → squeezed SQL.
std::map<std::string, std::set<std::string>> rtree_templates(std::string_view layer) {
    const std::string tree = rtree_name(layer);
    const auto row = [&](std::string_view key) {
        return fmt::format(
            "VALUES (NEW.{0}, ST_MinX(NEW.geom), ST_MaxX(NEW.geom), ST_MinY(NEW.geom), ST_MaxY(NEW.geom))", key);
    };
    const std::string filled = "(NEW.geom NOT NULL AND NOT ST_IsEmpty(NEW.geom))";
    const std::string empty = "(NEW.geom IS NULL OR ST_IsEmpty(NEW.geom))";
    const std::string put = fmt::format("INSERT OR REPLACE INTO {} {};", tree, row("fid"));
    const std::string drop_old = fmt::format("DELETE FROM {} WHERE id = OLD.fid;", tree);
    const std::string drop_both = fmt::format("DELETE FROM {} WHERE id IN (OLD.fid, NEW.fid);", tree);
    const auto trigger = [&](std::string_view suffix, std::string_view when, std::string_view body) {
        return squeezed(fmt::format("CREATE TRIGGER {0}_{1} AFTER {2} BEGIN {3} END", tree, suffix, when, body));
    };
    const auto on = [&](std::string_view event, std::string_view condition) {
        return fmt::format("{} ON {} {}", event, layer, condition);
    };
    std::map<std::string, std::set<std::string>> out;
    out[tree] = {squeezed(fmt::format("CREATE VIRTUAL TABLE {} USING rtree(id, minx, maxx, miny, maxy)", tree))};
    out[tree + "_insert"] = {trigger("insert", on("INSERT", "WHEN " + filled), put)};
    const std::string same_fid = "OLD.fid = NEW.fid AND ";
    const std::string other_fid = "OLD.fid != NEW.fid AND ";
    out[tree + "_update1"] = {trigger("update1", on("UPDATE OF geom", "WHEN " + same_fid + filled), put)};
    out[tree + "_update2"] = {trigger("update2", on("UPDATE OF geom", "WHEN " + same_fid + empty), drop_old)};
    const std::string moved = drop_old + put;
    out[tree + "_update3"] = {trigger("update3", on("UPDATE OF geom", "WHEN " + other_fid + filled), moved),
                              trigger("update3", on("UPDATE", "WHEN " + other_fid + filled), moved)};
    out[tree + "_update4"] = {trigger("update4", on("UPDATE", "WHEN " + other_fid + empty), drop_both)};
    out[tree + "_update5"] = {trigger("update5", on("UPDATE", "WHEN " + other_fid + filled), moved)};
    const std::string old_filled = "(OLD.geom NOT NULL AND NOT ST_IsEmpty(OLD.geom))";
    const std::string old_empty = "(OLD.geom IS NULL OR ST_IsEmpty(OLD.geom))";
    const std::string change = fmt::format("UPDATE {} SET minx = ST_MinX(NEW.geom), maxx = ST_MaxX(NEW.geom), "
                                           "miny = ST_MinY(NEW.geom), maxy = ST_MaxY(NEW.geom) WHERE id = NEW.fid;",
                                           tree);
    out[tree + "_update6"] = {
        trigger("update6", on("UPDATE OF geom", "WHEN " + same_fid + filled + " AND " + old_filled), change)};
    out[tree + "_update7"] = {trigger("update7",
                                      on("UPDATE OF geom", "WHEN " + same_fid + filled + " AND " + old_empty),
                                      fmt::format("INSERT INTO {} {};", tree, row("fid")))};
    out[tree + "_delete"] = {trigger("delete", on("DELETE", "WHEN OLD.geom NOT NULL"), drop_old)};
    return out;
}

bool is_word_in(std::string_view word, std::string_view sql) {
    const auto is_name = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    };
    for (std::size_t at = sql.find(word); at != std::string_view::npos; at = sql.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !is_name(sql[at - 1])) && (end == sql.size() || !is_name(sql[end]))) return true;
    }
    return false;
}

/// Whether a trigger or view of somebody else touches a table of ours.
bool is_on_ours(const SchemaItem& item, const SchemaItems& reference) {
    const auto is_table = [](const SchemaItem& candidate) { return candidate.type == "table"; };
    if (item.type == "trigger") {
        const auto it = reference.find(text::fold_case(item.table));
        return (it != reference.end() && is_table(it->second)) || reference.contains(item.table);
    }
    const std::string sql = text::fold_case(item.sql);
    return std::any_of(reference.begin(), reference.end(),
                       [&](const auto& entry) { return is_table(entry.second) && is_word_in(entry.first, sql); });
}

void check_foreign_items(const SchemaItems& theirs, const SchemaItems& ours, SchemaFindings& findings) {
    std::map<std::string, std::set<std::string>> templates;
    for (const std::string_view layer : kFeatureTables) templates.merge(rtree_templates(layer));
    for (const auto& [name, item] : theirs) {
        if (item.type != "trigger" && item.type != "view") continue;
        const auto it = ours.find(name);
        if (it != ours.end() && it->second.type == item.type && it->second.sql == item.sql) continue;
        const auto known = templates.find(name);
        if (known != templates.end() && known->second.contains(squeezed(item.sql))) continue;
        if (!is_on_ours(item, ours)) continue;
        findings.import_only_because.push_back(
            fmt::format("the {} {} was not made by Planum", item.type, text::clean_utf8(name).text));
    }
    for (const std::string_view layer : kFeatureTables) {
        const auto it = theirs.find(rtree_name(layer));
        if (it == theirs.end()) continue;
        if (templates.at(it->first).contains(squeezed(it->second.sql))) findings.rtree_tables.emplace_back(layer);
    }
}

} // namespace

const std::vector<std::string>& record_tables() {
    static const std::vector<std::string> tables = {
        "project",
        "area",
        "source",
        "import_note",
        "period",
        "phase",
        "unit",
        "relation",
        "relation_statement",
        "unit_group",
        "group_member",
        "level",
        "find",
        "dating",
        "sample",
        "document",
        "surface",
        "section",
        "region",
        "scan",
        "registration_run",
        "scan_pose",
        "decision",
        "interpretation",
        "interpretation_added",
        "interpretation_dropped",
    };
    return tables;
}

void create_schema(const sqlite::Database& database) { migrate(database, 0, kSchemaVersion); }

void migrate(const sqlite::Database& database, std::int64_t version, std::int64_t last) {
    for (const EmbeddedMigration& migration : embedded_migrations()) {
        const std::int64_t number = number_of(migration);
        if (number > version && number <= last) database.execute(migration.sql);
    }
}

std::int64_t read_schema_version(const sqlite::Database& database) {
    if (!database.has_table("planum_meta")) {
        throw Error(ErrorCode::BadInput, database.name() + ": a GeoPackage, but not a Planum project");
    }
    const std::string said = database.text("SELECT value FROM planum_meta WHERE key = 'schema_version'");
    const auto version = text::parse_integer(said);
    if (!version || *version < 1)
        throw Error(ErrorCode::BadInput, database.name() + ": the project has no schema version");
    return *version;
}

SchemaFindings examine_schema(const sqlite::Database& database, std::int64_t version) {
    const sqlite::Database reference = sqlite::Database::in_memory();
    migrate(reference, 0, version);
    const SchemaItems ours = read_items(reference);
    const SchemaItems theirs = read_items(database);
    SchemaFindings findings;
    for (const auto& [name, item] : ours) {
        const auto it = theirs.find(name);
        if (item.type == "table") {
            check_table(database, reference, name, item, it == theirs.end() ? nullptr : &it->second, findings);
        } else if (it == theirs.end()) {
            findings.missing_sql.push_back(item.sql);
            findings.missing_names.push_back(name);
        } else if (it->second.type == "index" && it->second.sql != item.sql) {
            findings.import_only_because.push_back(fmt::format("the index {} was not made by Planum", name));
        }
    }
    check_foreign_items(theirs, ours, findings);
    return findings;
}

void drop_rtree(const sqlite::Database& database, std::string_view layer) {
    const std::string tree = rtree_name(layer);
    for (const auto& [name, sql] : rtree_templates(layer)) {
        if (name != tree) database.execute("DROP TRIGGER IF EXISTS " + sqlite::quote_identifier(name));
    }
    database.execute("DROP TABLE IF EXISTS " + sqlite::quote_identifier(tree));
    sqlite::Statement entry = database.prepare(
        "DELETE FROM gpkg_extensions WHERE lower(table_name) = :layer AND extension_name = 'gpkg_rtree_index'");
    entry.bind(":layer", layer).run();
}

} // namespace planum::store
