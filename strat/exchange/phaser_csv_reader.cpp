// SPDX-License-Identifier: MIT

// PHASER's tables: contexts, stratigraphy, phases, groups, subgroups, periods, datings, and the older single
// table of five columns. Any delimiter, blanks included.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/phaser_record.hpp"
#include "strat/exchange/readers.hpp"

namespace planum::strat {

namespace {

struct NodeTable {
    std::string_view id; ///< column that names the rows, folded
    PhaserClass kind;
    std::string_view type;
    std::string_view other; ///< a second column that must be there, so that no other table is taken
};

constexpr std::array kTables = {
    NodeTable{"datingid", PhaserClass::Dating, "datingtype", "minyear"},
    NodeTable{"subgroupid", PhaserClass::Subgroup, "subgrouptype", "withingroup"},
    NodeTable{"groupid", PhaserClass::Group, "grouptype", "withinphase"},
    NodeTable{"phaseid", PhaserClass::Phase, "phasetype", "minyear"},
    NodeTable{"contextid", PhaserClass::Context, "contexttype", "sitecode"},
    NodeTable{"periodid", PhaserClass::Period, "periodtype", "minyear"},
};

struct WithinColumn {
    std::string_view column;
    PhaserClass kind;
};

// Nearest first.
constexpr std::array kWithin = {
    WithinColumn{"withincontext", PhaserClass::Context}, WithinColumn{"withinsubgroup", PhaserClass::Subgroup},
    WithinColumn{"withingroup", PhaserClass::Group},     WithinColumn{"withinphase", PhaserClass::Phase},
    WithinColumn{"withinperiod", PhaserClass::Period},
};

const NodeTable* node_table(const TableHeader& header) {
    const auto* const found = std::find_if(kTables.begin(), kTables.end(), [&](const NodeTable& table) {
        return header.has(table.id) && header.has(table.other);
    });
    return found == kTables.end() ? nullptr : found;
}

bool is_stratigraphy(const TableHeader& header) {
    return header.has("sourceid") && header.has("stratrelationship") && header.has("targetid");
}

bool is_old_form(const TableHeader& header) {
    return header.has("contextno") && header.has("stratrelationship") && header.has("relatedcontextno");
}

bool is_phaser(const TableHeader& header) {
    return is_stratigraphy(header) || is_old_form(header) || node_table(header) != nullptr;
}

// Where the usual delimiters leave the first line in one piece, blanks may be meant.
DelimitedTable with_blanks_if_needed(DelimitedTable table, std::string_view bytes, std::string_view name) {
    const bool one_cell = !table.rows.empty() && table.rows.front().cells.size() == 1;
    if (!one_cell || table.rows.front().cells.front().find(' ') == std::string::npos) return table;
    TableOptions blanks;
    blanks.delimiter = ' ';
    return parse_table(bytes, name, blanks);
}

std::string get(const TableRow& row, const TableHeader& header, std::string_view column) {
    return std::string(cell(row, header.find(column)));
}

void read_node(const TableRow& row, const TableHeader& header, const NodeTable& table, const std::string& file,
               PhaserRecord& record) {
    PhaserNode node;
    node.kind = table.kind;
    node.id = get(row, header, table.id);
    node.file = file;
    node.line = row.line;
    if (node.id.empty()) {
        record.builder().note({file, row.line, {}}, "unparsed", fmt::format("a row without {}; left out", table.id));
        return;
    }
    node.site = get(row, header, "sitecode");
    node.type = get(row, header, table.type);
    node.cud = get(row, header, "cud");
    node.description = get(row, header, "description");
    node.uri = get(row, header, "uri");
    node.from = get(row, header, "minyear");
    node.to = get(row, header, "maxyear");
    for (const WithinColumn& within : kWithin) {
        std::string outer = get(row, header, within.column);
        if (!outer.empty()) node.within.emplace_back(within.kind, std::move(outer));
    }
    record.add(std::move(node));
}

void read_old_row(const TableRow& row, const TableHeader& header, const std::string& file, PhaserRecord& record) {
    PhaserNode node;
    node.id = get(row, header, "contextno");
    node.site = get(row, header, "sitecode");
    node.type = get(row, header, "contexttype");
    node.file = file;
    node.line = row.line;
    if (node.id.empty()) {
        record.builder().note({file, row.line, {}}, "unparsed", "a row without contextNo; left out");
        return;
    }
    const std::string source = node.id;
    record.add(std::move(node));
    std::string relation = get(row, header, "stratrelationship");
    std::string target = get(row, header, "relatedcontextno");
    if (relation.empty() && target.empty()) return; // a context without relations
    record.add(PhaserEdge{source, std::move(target), std::move(relation), file, row.line});
}

void read_file(const InputFile& file, PhaserRecord& record) {
    require_text(file, "a PHASER table");
    DelimitedTable table = with_blanks_if_needed(parse_table(file.bytes, file.name), file.bytes, file.name);
    record.builder().add_notes(std::move(table.notes));
    const TableHeader header(table.rows.empty() ? TableRow{} : table.rows.front());
    if (!is_phaser(header)) {
        throw Error(ErrorCode::BadInput,
                    file.name +
                        ": the first line has not the columns of a PHASER table (siteCode, contextID; sourceID, "
                        "stratRelationship, targetID; phaseID, groupID, subgroupID, periodID, datingID)");
    }
    const NodeTable* nodes = node_table(header);
    for (std::size_t i = 1; i < table.rows.size(); ++i) {
        const TableRow& row = table.rows[i];
        if (is_stratigraphy(header)) {
            record.add(PhaserEdge{get(row, header, "sourceid"), get(row, header, "targetid"),
                                  get(row, header, "stratrelationship"), file.name, row.line});
        } else if (is_old_form(header)) {
            read_old_row(row, header, file.name, record);
        } else {
            read_node(row, header, *nodes, file.name, record);
        }
    }
}

Recognition recognise(std::span<const InputFile> files) {
    Recognition out;
    for (std::size_t i = 0; i < files.size(); ++i) {
        DelimitedTable table = glimpse_table(files[i]);
        if (table.rows.empty()) continue;
        table = with_blanks_if_needed(std::move(table), std::string_view(files[i].bytes).substr(0, 1U << 16U),
                                      files[i].name);
        if (table.rows.empty() || !is_phaser(TableHeader(table.rows.front()))) continue;
        out.files.push_back(i);
        out.confidence = Confidence::Certain;
        out.why = "columns of PHASER tables";
    }
    return out;
}

Imported<ImportedRecord> read(std::span<const InputFile* const> files, const ReadOptions& options, Progress& progress) {
    PhaserRecord record(options);
    for (const InputFile* file : files) {
        progress.check();
        read_file(*file, record);
    }
    return record.finish();
}

} // namespace

const Reader& phaser_csv_reader() {
    static const Reader reader = {"phaser-csv", "PHASER tables (.csv)", recognise, read};
    return reader;
}

} // namespace planum::strat
