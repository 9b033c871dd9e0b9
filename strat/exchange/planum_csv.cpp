// SPDX-License-Identifier: MIT
#include "strat/exchange/planum_csv.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include "core/base/text.hpp"
#include "core/model/unit.hpp"

namespace planum::strat {

namespace {

using Names = std::vector<std::string_view>;

Names unit_columns() {
    Names names = {"unit",
                   "area",
                   "kind",
                   "form",
                   "status",
                   "title",
                   "description",
                   "interpretation",
                   "excavated_from",
                   "excavated_on",
                   "recorded_by",
                   "recorded_on",
                   "phase",
                   "period",
                   "parent",
                   "group",
                   "top",
                   "x",
                   "y"};
    for (const model::UnitFieldInfo& field : model::kUnitFields) names.push_back(field.name);
    return names;
}

bool is_number_between(std::string_view text, long long low, long long high) {
    const auto number = text::parse_integer(text);
    return number && *number >= low && *number <= high;
}

} // namespace

std::span<const std::string_view> csv_columns(CsvTable table) {
    static const Names units = unit_columns();
    static const Names relations = {"unit",      "area",   "relation",    "other", "other_area",
                                    "certainty", "person", "correlation", "side"};
    static const Names members = {"group", "unit", "area"};
    static const Names levels = {"unit", "area", "z", "role", "x", "y", "label"};
    static const Names finds = {"find",     "unit",  "area",   "x",         "y",   "z",        "type",
                                "material", "count", "weight", "condition", "box", "found_on", "description"};
    static const Names samples = {"sample", "unit",       "area", "type", "volume", "weight", "laboratory_number",
                                  "state",  "description"};
    static const Names documents = {"document", "unit", "area", "type", "title", "path", "made_on", "author"};
    static const Names datings = {"dating", "unit", "area",  "find",        "kind", "from",
                                  "to",     "bp",   "error", "association", "notes"};
    static const Names phases = {"phase", "title", "description", "period", "from", "to", "rank"};
    static const Names periods = {"period", "title", "description", "from", "to", "rank"};
    static const Names groups = {"group", "type", "title", "description", "parent"};
    static const Names areas = {"area", "title", "method", "first_number", "last_number"};
    switch (table) {
    case CsvTable::Units: return units;
    case CsvTable::Relations: return relations;
    case CsvTable::Members: return members;
    case CsvTable::Levels: return levels;
    case CsvTable::Finds: return finds;
    case CsvTable::Samples: return samples;
    case CsvTable::Documents: return documents;
    case CsvTable::Datings: return datings;
    case CsvTable::Phases: return phases;
    case CsvTable::Periods: return periods;
    case CsvTable::Groups: return groups;
    case CsvTable::Areas: return areas;
    }
    return {};
}

std::string_view csv_name(CsvTable table) noexcept {
    switch (table) {
    case CsvTable::Units: return "units";
    case CsvTable::Relations: return "relations";
    case CsvTable::Members: return "members";
    case CsvTable::Levels: return "levels";
    case CsvTable::Finds: return "finds";
    case CsvTable::Samples: return "samples";
    case CsvTable::Documents: return "documents";
    case CsvTable::Datings: return "datings";
    case CsvTable::Phases: return "phases";
    case CsvTable::Periods: return "periods";
    case CsvTable::Groups: return "groups";
    case CsvTable::Areas: return "areas";
    }
    return {};
}

std::optional<CsvTable> csv_table_of(const TableHeader& header) {
    // A table is named by its first column, whose word other tables use for references.
    const std::string_view first = header.names().empty() ? std::string_view{} : header.names().front();
    if (header.has("unit") && header.has("relation") && header.has("other")) return CsvTable::Relations;
    if (header.has("dating")) return CsvTable::Datings;
    if (header.has("sample") && header.has("unit")) return CsvTable::Samples;
    if (header.has("document") && header.has("unit")) return CsvTable::Documents;
    if (first == "find") return CsvTable::Finds;
    if (header.has("unit") && header.has("z")) return CsvTable::Levels;
    if (first == "group" && header.has("unit")) return CsvTable::Members;
    if (header.has("unit")) return CsvTable::Units;
    if (first == "phase") return CsvTable::Phases;
    if (first == "period") return CsvTable::Periods;
    if (first == "group") return CsvTable::Groups;
    if (first == "area") return CsvTable::Areas;
    return std::nullopt;
}

std::string without_formula_guard(std::string_view cell) {
    const std::size_t at = cell.find_first_not_of('\'');
    const bool guarded =
        at != std::string_view::npos && at > 0 && std::string_view{"=+-@"}.find(cell[at]) != std::string_view::npos;
    return std::string{guarded ? cell.substr(1) : cell};
}

std::optional<std::string> iso_date(std::string_view text) {
    text = text::trim(text);
    const char separator = text.find('-') != std::string_view::npos   ? '-'
                           : text.find('.') != std::string_view::npos ? '.'
                                                                      : '/';
    std::vector<std::string_view> parts = text::split(text, separator);
    if (parts.size() != 3) return std::nullopt;
    if (separator != '-') std::swap(parts[0], parts[2]);
    if (parts[0].size() != 4 || !is_number_between(parts[0], 1000, 9999) || parts[1].size() > 2 ||
        parts[2].size() > 2 || !is_number_between(parts[1], 1, 12) || !is_number_between(parts[2], 1, 31)) {
        return std::nullopt;
    }
    return fmt::format("{}-{:02}-{:02}", parts[0], *text::parse_integer(parts[1]), *text::parse_integer(parts[2]));
}

} // namespace planum::strat
