// SPDX-License-Identifier: MIT

// The table of the R package stratigraphr: one row a unit, lists of the units above, below and equal.

#include <array>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/readers.hpp"
#include "strat/exchange/record_builder.hpp"
#include "strat/exchange/table_reader.hpp"
#include "strat/exchange/unit_fields.hpp"

namespace planum::strat {

namespace {

struct ListColumn {
    std::string_view name;
    model::DirectedKind kind; ///< what the row's unit is to those listed
};

constexpr std::array kLists = {
    ListColumn{"above", {model::RelationKind::Covers, true}}, // those listed lie above this one
    ListColumn{"below", {model::RelationKind::Covers, false}},
    ListColumn{"equal", {model::RelationKind::SameAs, false}},
    ListColumn{"contemporary", {model::RelationKind::Contemporary, false}},
};
constexpr std::array<std::string_view, 4> kElsewhere = {"context", "type", "phase", "structure"};

std::string_view value(const TableRow& row, const TableHeader& header, std::string_view column) {
    const std::string_view text = cell(row, header.find(column));
    return text == "NA" ? std::string_view{} : text; // how R writes "nothing"
}

bool is_list(std::string_view column) {
    return std::any_of(kLists.begin(), kLists.end(), [&](const ListColumn& list) { return list.name == column; });
}

void read_fields(const TableRow& row, const TableHeader& header, ImportedUnit& unit) {
    set_kind(unit, value(row, header, "type"));
    unit.phase = value(row, header, "phase");
    for (const std::string& column : header.names()) {
        const bool elsewhere = std::find(kElsewhere.begin(), kElsewhere.end(), column) != kElsewhere.end();
        if (!elsewhere && !is_list(column) && !column.empty())
            add_custom_field(unit, column, value(row, header, column));
    }
}

void read_row(const TableRow& row, const TableHeader& header, std::string_view file, RecordBuilder& builder) {
    const UnitName name = builder.name(value(row, header, "context"));
    if (name.number.empty()) {
        builder.note({file, row.line, {}}, "unparsed", "a row without a context; left out");
        return;
    }
    const Place place{file, row.line, {}};
    if (builder.has_unit(name)) {
        builder.note(place, "repeated-unit", fmt::format("unit {} has two rows; both were read", name.number));
    }
    read_fields(row, header, builder.unit(name, place));
    if (const std::string_view structure = value(row, header, "structure"); !structure.empty()) {
        builder.group(structure).values.type = "structure";
        builder.add_member(structure, name);
    }
    for (const ListColumn& list : kLists) {
        for (const std::string& other : split_list(value(row, header, list.name), ListSeparator::CommaOrSemicolon)) {
            const std::string raw = fmt::format("{}: {}", list.name, other);
            builder.relate(name, list.kind, builder.name(other), {file, row.line, raw});
        }
    }
}

bool has_columns(const DelimitedTable& table) {
    if (table.rows.empty()) return false;
    const TableHeader header(table.rows.front());
    return header.has("context") && header.has("above") && header.has("below");
}

void read_table(DelimitedTable& table, const InputFile& file, RecordBuilder& builder) {
    const TableHeader header(table.rows.empty() ? TableRow{} : table.rows.front());
    if (!header.has("context") || !(header.has("above") || header.has("below"))) {
        throw Error(ErrorCode::BadInput,
                    file.name + ": the first line has no columns context, above and below of a stratigraphr table");
    }
    for (std::size_t i = 1; i < table.rows.size(); ++i) read_row(table.rows[i], header, file.name, builder);
}

Recognition recognise(std::span<const InputFile> files) {
    return recognise_tables(files, has_columns, "columns context, above, below");
}

Imported<ImportedRecord> read(std::span<const InputFile* const> files, const ReadOptions& options, Progress& progress) {
    return read_tables(files, options, progress, "a stratigraphr table", read_table);
}

} // namespace

const Reader& stratigraphr_reader() {
    static const Reader reader = {"stratigraphr", "stratigraphr table (context, above, below, equal)", recognise, read};
    return reader;
}

} // namespace planum::strat
