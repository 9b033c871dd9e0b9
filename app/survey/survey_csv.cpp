// SPDX-License-Identifier: MIT
#include "app/survey/survey_csv.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/delimited_table.hpp"

namespace planum::app {

namespace {

using Names = std::span<const std::string_view>;

constexpr std::array<std::string_view, 10> kName = {"name",   "point", "pt",          "nr",    "id",
                                                    "number", "punkt", "punktnummer", "punto", "no"};
constexpr std::array<std::string_view, 9> kX = {"x",          "e",   "east", "easting", "rechts",
                                                "rechtswert", "ost", "est",  "x_m"};
constexpr std::array<std::string_view, 10> kY = {"y",        "n",    "north", "northing", "hoch",
                                                 "hochwert", "nord", "y_m",   "norte",    "nordwert"};
constexpr std::array<std::string_view, 10> kZ = {"z",     "h",    "height", "elevation", "elev",
                                                 "hoehe", "höhe", "quota",  "altitude",  "z_m"};
constexpr std::array<std::string_view, 5> kCode = {"code", "code1", "kode", "codice", "attribute"};
constexpr std::array<std::string_view, 7> kUnit = {"unit", "us", "context", "befund", "ue", "stelle", "feature"};
constexpr std::array<std::string_view, 6> kFind = {"find", "fund", "fundnummer", "fundnr", "reperto", "sf"};
constexpr std::array<std::string_view, 6> kText = {"text", "description", "remark", "bemerkung", "note", "desc"};

struct Columns {
    std::optional<std::size_t> name;
    std::optional<std::size_t> x;
    std::optional<std::size_t> y;
    std::optional<std::size_t> z;
    std::optional<std::size_t> code;
    std::optional<std::size_t> unit;
    std::optional<std::size_t> find;
    std::optional<std::size_t> text;
};

Columns columns_of(const strat::TableHeader& header) {
    return {header.find_any(kName), header.find_any(kX),    header.find_any(kY),    header.find_any(kZ),
            header.find_any(kCode), header.find_any(kUnit), header.find_any(kFind), header.find_any(kText)};
}

// Names of --columns that mean nothing would silently leave out what stands below them.
void check_columns(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        strat::TableRow one;
        one.cells = {name};
        const Columns known = columns_of(strat::TableHeader(one));
        if (name.empty() || name == "-" || known.name || known.x || known.y || known.z || known.code || known.unit ||
            known.find || known.text) {
            continue;
        }
        throw Error(ErrorCode::BadInput,
                    fmt::format("columns {}: {} is none of name, x, y, z, code, unit, find, text; write - for one that "
                                "is not to be read",
                                text::join(names, ","), name));
    }
}

// Instruments also write columns apart by blanks only.
std::string blanks_as_tabs(std::string_view bytes) {
    std::string out;
    bool blank = true; // at the start of a line
    for (const char c : bytes) {
        if (c == ' ') {
            if (!blank) out += '\t';
            blank = true;
            continue;
        }
        if (c == '\n' && !out.empty() && out.back() == '\t') out.pop_back();
        out += c;
        blank = c == '\n';
    }
    return out;
}

std::optional<double> coordinate(const strat::TableRow& row, std::optional<std::size_t> column) {
    std::string word{strat::cell(row, column)};
    if (word.find('.') == std::string::npos) std::replace(word.begin(), word.end(), ',', '.');
    const auto value = text::parse_double(word);
    constexpr double kFarthest = 1e8;
    return value && std::abs(*value) < kFarthest ? value : std::nullopt;
}

std::string word(const strat::TableRow& row, std::optional<std::size_t> column) {
    return std::string(strat::cell(row, column));
}

SurveyPoint point_of(const strat::TableRow& row, const Columns& columns, double x, double y) {
    SurveyPoint point;
    point.name = word(row, columns.name);
    point.code = word(row, columns.code);
    point.unit = word(row, columns.unit);
    point.find = word(row, columns.find);
    point.text = word(row, columns.text);
    point.x = x;
    point.y = y;
    point.z = coordinate(row, columns.z);
    point.line = row.line;
    return point;
}

} // namespace

SurveyFile read_survey_csv(std::string_view bytes, std::string_view file_name, std::string_view columns) {
    const bool parted = bytes.find_first_of(",;\t|") != std::string_view::npos;
    const strat::DelimitedTable table =
        parted ? strat::parse_table(bytes, file_name) : strat::parse_table(blanks_as_tabs(bytes), file_name);
    SurveyFile file;
    file.notes = table.notes;
    if (table.rows.empty()) throw Error(ErrorCode::BadInput, "it holds no points");
    strat::TableRow names = table.rows.front();
    std::size_t first = 1;
    const Columns by_heading = columns_of(strat::TableHeader(names));
    if (!columns.empty() || !by_heading.x || !by_heading.y) {
        names.cells.clear();
        const std::string_view wanted = columns.empty() ? std::string_view("name,x,y,z,code") : columns;
        for (const std::string_view name : text::split(wanted, ',')) names.cells.emplace_back(text::trim(name));
        check_columns(names.cells);
        first = 0;
    }
    const Columns where = columns_of(strat::TableHeader(names));
    if (!where.x || !where.y) {
        throw Error(ErrorCode::BadInput, fmt::format("columns {}: there is no x and y", text::join(names.cells, ",")));
    }
    for (std::size_t i = first; i < table.rows.size(); ++i) {
        const strat::TableRow& row = table.rows[i];
        const auto x = coordinate(row, where.x);
        const auto y = coordinate(row, where.y);
        if (x && y) {
            file.points.push_back(point_of(row, where, *x, *y));
            continue;
        }
        const bool empty = std::all_of(row.cells.begin(), row.cells.end(), [](const auto& c) { return c.empty(); });
        if (empty || (i == 0 && !columns.empty())) continue; // headings that --columns overrules
        file.notes.push_back({std::string(file_name), row.line, "unparsed", text::join(row.cells, ",").substr(0, 200),
                              "no coordinates; the row was left out"});
    }
    if (file.points.empty()) throw Error(ErrorCode::BadInput, "none of its rows holds coordinates; see --columns");
    return file;
}

} // namespace planum::app
