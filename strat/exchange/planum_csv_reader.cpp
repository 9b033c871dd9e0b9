// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/planum_csv_rows.hpp"
#include "strat/exchange/readers.hpp"

namespace planum::strat {

namespace {

struct ParsedFile {
    const InputFile* file = nullptr;
    DelimitedTable table;
    TableHeader header;
    CsvTable kind = CsvTable::Units;
};

std::size_t known_columns(const TableHeader& header, CsvTable table) {
    const auto known = csv_columns(table);
    return static_cast<std::size_t>(std::count_if(header.names().begin(), header.names().end(), [&](const auto& name) {
        return std::find(known.begin(), known.end(), name) != known.end();
    }));
}

// Relations are unmistakable; the others by how many of their columns we know.
Confidence confidence_in(const TableHeader& header, CsvTable table) {
    if (table == CsvTable::Relations) return Confidence::Certain;
    const std::size_t known = known_columns(header, table);
    if (known < 2) return Confidence::No;
    if (known == header.names().size()) return Confidence::Certain;
    return known * 2 >= header.names().size() ? Confidence::Likely : Confidence::Possible;
}

Recognition recognise(std::span<const InputFile> files) {
    Recognition result;
    result.why = "columns unit, kind, title, … or unit, relation, other";
    for (std::size_t i = 0; i < files.size(); ++i) {
        const DelimitedTable table = glimpse_table(files[i]);
        if (table.rows.empty()) continue;
        const TableHeader header(table.rows.front());
        const auto kind = csv_table_of(header);
        const Confidence confidence = kind ? confidence_in(header, *kind) : Confidence::No;
        if (confidence == Confidence::No) continue;
        result.files.push_back(i);
        result.confidence = std::max(result.confidence, confidence);
    }
    return result;
}

ParsedFile parse(const InputFile& file, RecordBuilder& builder) {
    require_text(file, "a table of units, relations, levels, finds, …");
    DelimitedTable table = parse_table(file.bytes, file.name);
    builder.add_notes(std::move(table.notes));
    TableHeader header(table.rows.empty() ? TableRow{} : table.rows.front());
    const auto kind = csv_table_of(header);
    if (!kind) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("{}: no table of ours; looked in the first line for the columns unit, relation, other "
                                "or unit, kind, title or another table's first column",
                                file.name));
    }
    return {&file, std::move(table), std::move(header), *kind};
}

void note_unknown_columns(const ParsedFile& parsed, RecordBuilder& builder) {
    const auto known = csv_columns(parsed.kind);
    for (const std::string& name : parsed.header.names()) {
        if (name.empty() || std::find(known.begin(), known.end(), name) != known.end()) continue;
        builder.note({parsed.file->name, parsed.table.rows.front().line, name}, "unknown-column",
                     parsed.kind == CsvTable::Units
                         ? fmt::format("the column {} is not known; kept among the free fields", name)
                         : fmt::format("the column {} is not known; left out", name));
    }
}

Imported<ImportedRecord> read(std::span<const InputFile* const> files, const ReadOptions& options, Progress& progress) {
    RecordBuilder builder(options);
    std::vector<ParsedFile> parsed;
    for (const InputFile* file : files) {
        progress.check();
        parsed.push_back(parse(*file, builder));
        note_unknown_columns(parsed.back(), builder);
    }
    // Units before relations, whatever the order of the files: `13, 14` is a list unless a unit is
    // called so.
    for (const CsvTable kind : kAllCsvTables) {
        for (const ParsedFile& table : parsed) {
            if (table.kind != kind) continue;
            progress.check();
            for (std::size_t i = 1; i < table.table.rows.size(); ++i) {
                read_csv_row(kind, CsvRow(table.header, table.table.rows[i], table.file->name, builder), builder);
            }
        }
    }
    return builder.finish();
}

} // namespace

const Reader& planum_csv_reader() {
    static const Reader reader{"planum-csv", "Tables of units, relations, levels, finds, … (.csv)", recognise, read};
    return reader;
}

} // namespace planum::strat
