// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/hmc_nodes.hpp"
#include "strat/exchange/readers.hpp"
#include "strat/exchange/record_builder.hpp"
#include "strat/exchange/table_reader.hpp"

namespace planum::strat {

namespace {

using model::DirectedKind;
using model::RelationKind;

struct ListColumn {
    std::string_view name;
    DirectedKind kind;
};

// Lists the units to which this one stands so: ABOVE holds those that this one is above.
constexpr std::array kListColumns = {
    ListColumn{"above", {RelationKind::Covers, false}},
    ListColumn{"below", {RelationKind::Covers, true}},
    ListColumn{"later", {RelationKind::Later, false}},
    ListColumn{"earlier", {RelationKind::Later, true}},
    ListColumn{"contemporary", {RelationKind::Contemporary, false}},
};

bool is_tag(const TableRow& row, std::string_view tag) {
    return !row.cells.empty() && text::trim(row.cells.front()) == tag;
}

/// Reads the lines of one file; its HEADER lines say the columns of those below.
class HmcTable {
  public:
    HmcTable(RecordBuilder& builder, std::string_view file) : builder_(builder), file_(file) {}

    void read(const DelimitedTable& table) {
        for (const TableRow& row : table.rows) {
            if (is_tag(row, "HEADER")) {
                header_ = TableHeader(row);
            } else if (is_tag(row, "PROJECT")) {
                read_project(row);
            } else if (is_tag(row, "UNIT") && header_ && header_->has("id")) {
                rows_.push_back(&row);
                nodes_.push_back(node_of(row));
            } else {
                builder_.note({file_, row.line, row.cells.front()}, "unparsed",
                              "neither HEADER nor PROJECT nor UNIT; left out");
            }
        }
        add_hmc_nodes(builder_, nodes_, file_);
        for (const HmcNode& node : nodes_) {
            if (is_hmc_group(node.type)) groups_.insert(node.id);
        }
        for (std::size_t i = 0; i < rows_.size(); ++i) add_relations(nodes_[i], *rows_[i]);
    }

    [[nodiscard]] bool is_empty() const { return nodes_.empty(); }

  private:
    [[nodiscard]] std::string value(const TableRow& row, std::string_view column) const {
        return header_ ? std::string{cell(row, header_->find(column))} : std::string{};
    }

    void read_project(const TableRow& row) {
        if (builder_.record.project_name.empty()) builder_.record.project_name = value(row, "name");
    }

    [[nodiscard]] HmcNode node_of(const TableRow& row) const {
        return {value(row, "id"),
                value(row, "type"),
                value(row, "name"),
                value(row, "description"),
                value(row, "parent"),
                value(row, "valid") != "false",
                row.line};
    }

    void add_relations(const HmcNode& node, const TableRow& row) {
        if (node.id.empty()) return;
        for (const ListColumn& column : kListColumns) {
            const std::string list = value(row, column.name);
            for (const std::string& other : split_list(list, ListSeparator::Comma)) {
                const std::string raw = fmt::format("{} {}: {}", node.id, text::fold_case(column.name), other);
                const Place place{file_, row.line, raw};
                if (is_hmc_group(node.type) || groups_.contains(other)) {
                    builder_.note(place, "group-relation",
                                  "a relation of a group was left out; only units have relations");
                } else {
                    builder_.relate(builder_.name(node.id), column.kind, builder_.name(other), place);
                }
            }
        }
    }

    RecordBuilder& builder_;
    std::string_view file_;
    std::optional<TableHeader> header_;
    std::vector<const TableRow*> rows_;
    std::vector<HmcNode> nodes_;
    std::unordered_set<std::string> groups_;
};

bool is_hmc_table(const DelimitedTable& table) {
    return std::any_of(table.rows.begin(), table.rows.end(), [](const TableRow& row) {
        if (!is_tag(row, "HEADER")) return false;
        const TableHeader header(row);
        return header.has("id") && (header.has("above") || header.has("below"));
    });
}

void read_table(DelimitedTable& table, const InputFile& file, RecordBuilder& builder) {
    HmcTable reader(builder, file.name);
    reader.read(table);
    if (reader.is_empty()) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("{}: no line tagged UNIT below a HEADER line with the column ID", file.name));
    }
}

Recognition recognise(std::span<const InputFile> files) {
    return recognise_tables(files, is_hmc_table, "lines tagged HEADER, PROJECT, UNIT");
}

Imported<ImportedRecord> read(std::span<const InputFile* const> files, const ReadOptions& options, Progress& progress) {
    return read_tables(files, options, progress, "a table of the Harris Matrix Composer", read_table);
}

} // namespace

const Reader& hmc_csv_reader() {
    static const Reader reader{"hmc-csv", "Harris Matrix Composer table (.csv)", recognise, read};
    return reader;
}

} // namespace planum::strat
