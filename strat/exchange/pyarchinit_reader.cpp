// SPDX-License-Identifier: MIT
#include "strat/exchange/readers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/sqlite/database.hpp"
#include "strat/exchange/pyarchinit_rows.hpp"

namespace planum::strat {

namespace {

constexpr std::int64_t kMaxRows = 2'000'000;       // of one table; the largest database seen has 12,000 units
constexpr std::size_t kMaxTableSize = 512U << 20U; // in memory [bytes]

struct DatabaseTable {
    std::string_view name;
    PyarchinitTable table;
};

constexpr std::array kDatabaseTables = {
    DatabaseTable{"periodizzazione_table", PyarchinitTable::Periods},
    DatabaseTable{"datazioni_table", PyarchinitTable::Datings},
    DatabaseTable{"us_table", PyarchinitTable::Units},
    DatabaseTable{"us_relationships_table", PyarchinitTable::PairsOfUnits},
    DatabaseTable{"harris_matrix_table", PyarchinitTable::PairsOfUnits},
    DatabaseTable{"pyarchinit_quote", PyarchinitTable::Levels},
    DatabaseTable{"inventario_materiali_table", PyarchinitTable::Finds},
    DatabaseTable{"campioni_table", PyarchinitTable::Samples},
};

std::optional<PyarchinitTable> table_of(const TableHeader& header) {
    const auto has = [&header](std::string_view name) { return header.has(name); };
    if (has("cron_iniziale") && has("periodo") && has("fase")) return PyarchinitTable::Periods;
    if (has("us_q") && has("quota_q")) return PyarchinitTable::Levels;
    if (has("numero_inventario") && has("tipo_reperto")) return PyarchinitTable::Finds;
    if (has("nr_campione") && has("tipo_campione")) return PyarchinitTable::Samples;
    if ((has("us_sopra") && has("us_sotto")) || (has("us_from") && has("us_to") && has("relationship_type"))) {
        return PyarchinitTable::PairsOfUnits;
    }
    if (!has("us")) return std::nullopt;
    const bool units = has("rapporti") || has("d_stratigrafica") || has("periodo_iniziale") || has("unita_tipo");
    return units ? std::optional(PyarchinitTable::Units) : std::nullopt;
}

// SpatiaLite keeps a point as 0x00, byte order, srid, four corners of its box, 0x7C, type, coordinates.
// For a point the lower left corner of the box is the point itself.
void read_point(std::span<const std::byte> blob, PyarchinitRow& row) {
    constexpr std::size_t kBoxAt = 6;
    constexpr std::size_t kMarkAt = 38;
    const bool is_little = blob.size() > kMarkAt && blob[0] == std::byte{0} && blob[1] == std::byte{1};
    if (!is_little || blob[kMarkAt] != std::byte{0x7C}) return;
    double x = 0.0;
    double y = 0.0;
    std::memcpy(&x, blob.data() + kBoxAt, sizeof x);
    std::memcpy(&y, blob.data() + kBoxAt + sizeof x, sizeof y);
    if (!(std::abs(x) < 1e9) || !(std::abs(y) < 1e9)) return;
    row.x = x;
    row.y = y;
}

PyarchinitRow read_row(const sqlite::Statement& statement, std::size_t& replaced) {
    PyarchinitRow row;
    for (int column = 0; column < statement.column_count(); ++column) {
        const std::string name = text::fold_case(statement.column_name(column));
        if (statement.type(column) == sqlite::ValueType::Blob) {
            if (name == "the_geom" || name == "geom") read_point(statement.blob(column), row);
            continue;
        }
        text::Cleaned cleaned = text::clean_utf8(statement.text(column));
        replaced += cleaned.replaced;
        if (!cleaned.text.empty()) row.fields.emplace(name, std::move(cleaned.text));
    }
    return row;
}

void read_database_table(const sqlite::Database& database, const DatabaseTable& table, const std::string& file,
                         PyarchinitRows& rows, Progress& progress) {
    sqlite::Statement statement = database.prepare("SELECT * FROM main." + sqlite::quote_identifier(table.name));
    constexpr std::size_t kFieldOverhead = 100; // of a node of the row's map [bytes]
    std::size_t replaced = 0;
    std::size_t size = 0;
    std::int64_t number = 0;
    while (statement.step()) {
        if (++number > kMaxRows) {
            throw Error(ErrorCode::BadInput, fmt::format("{} has more than {} rows", table.name, kMaxRows));
        }
        if (number % 1000 == 0) progress.check();
        PyarchinitRow row = read_row(statement, replaced);
        for (const auto& [name, value] : row.fields) size += kFieldOverhead + name.size() + value.size();
        if (size > kMaxTableSize) {
            throw Error(ErrorCode::BadInput, fmt::format("{} holds more than {} MB", table.name, kMaxTableSize >> 20U));
        }
        row.file = file;
        row.table = table.name;
        row.line = number;
        rows.add(table.table, std::move(row));
    }
    if (replaced > 0) {
        rows.note({file, 0, {}}, "replaced-characters",
                  fmt::format("{}: {} characters that are no text were replaced", table.name, replaced));
    }
}

void read_database(const InputFile& input, PyarchinitRows& rows, Progress& progress) {
    sqlite::Database database = sqlite::Database::open_foreign(input.path);
    database.stop_with(progress.stop_token());
    if (!database.has_table("us_table")) {
        throw Error(ErrorCode::BadInput, "no table us_table, so no pyArchInit database");
    }
    for (const DatabaseTable& table : kDatabaseTables) {
        if (database.has_table(table.name)) read_database_table(database, table, input.name, rows, progress);
    }
}

void read_csv(const InputFile& input, PyarchinitRows& rows) {
    require_text(input, "a pyArchInit table");
    DelimitedTable table = parse_table(input.bytes, input.name);
    rows.add_notes(std::move(table.notes));
    if (table.rows.empty()) throw Error(ErrorCode::BadInput, "the file is empty");
    const TableHeader header(table.rows.front());
    const auto kind = table_of(header);
    if (!kind) {
        throw Error(ErrorCode::BadInput,
                    "the first line has not the columns of a pyArchInit table (us with rapporti, d_stratigrafica or "
                    "periodo_iniziale; periodo, fase, cron_iniziale; us_q, quota_q)");
    }
    for (std::size_t i = 1; i < table.rows.size(); ++i) {
        PyarchinitRow row;
        row.file = input.name;
        row.line = table.rows[i].line;
        std::vector<std::string>& cells = table.rows[i].cells;
        for (std::size_t column = 0; column < std::min(cells.size(), header.names().size()); ++column) {
            if (!cells[column].empty()) row.fields.emplace(header.names()[column], std::move(cells[column]));
        }
        if (cells.size() > header.names().size()) {
            rows.note({input.name, row.line, cells.back()}, "unparsed",
                      fmt::format("the row has {} cells and the header {}; the last ones were left out", cells.size(),
                                  header.names().size()));
        }
        rows.add(*kind, std::move(row));
    }
}

bool is_pyarchinit_database(const InputFile& input) {
    try {
        return sqlite::Database::open_foreign(input.path).has_table("us_table");
    } catch (const Error&) {
        return false; // reading it will say why
    }
}

Recognition recognise(std::span<const InputFile> files) {
    Recognition out;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (files[i].is_database) {
            if (!is_pyarchinit_database(files[i])) continue;
            out.why = "a database with us_table";
        } else {
            const DelimitedTable table = glimpse_table(files[i]);
            if (table.rows.empty() || !table_of(TableHeader(table.rows.front()))) continue;
            if (out.why.empty()) out.why = "columns of pyArchInit tables";
        }
        out.files.push_back(i);
        out.confidence = Confidence::Certain;
    }
    return out;
}

Imported<ImportedRecord> read(std::span<const InputFile* const> files, const ReadOptions& options, Progress& progress) {
    PyarchinitRows rows(options);
    for (const InputFile* file : files) {
        progress.check();
        try {
            if (file->is_database) {
                read_database(*file, rows, progress);
            } else {
                read_csv(*file, rows);
            }
        } catch (Error& e) {
            if (!std::string_view(e.what()).starts_with(file->name)) e.add_context(file->name);
            throw;
        }
    }
    return rows.finish();
}

} // namespace

const Reader& pyarchinit_reader() {
    static const Reader reader = {"pyarchinit", "pyArchInit database or CSV tables", recognise, read};
    return reader;
}

} // namespace planum::strat
