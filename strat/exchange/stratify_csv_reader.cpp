// SPDX-License-Identifier: MIT

// Stratify's CSV: semicolons, ISO-8859-1, one row a unit or group.

#include <algorithm>
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

// Stratify states time, not contact: "later than" holds whatever this one lies above, cuts or fills.
constexpr std::array kLists = {
    ListColumn{"earlier_than", {model::RelationKind::Later, true}},
    ListColumn{"later_than", {model::RelationKind::Later, false}},
    ListColumn{"equal_to", {model::RelationKind::SameAs, false}},
    ListColumn{"contemporary_with", {model::RelationKind::Contemporary, false}},
};
constexpr std::array<std::string_view, 5> kElsewhere = {"unitname", "unitclass", "part_of", "unittype", "phase"};

bool is_stratify(const TableHeader& header) {
    return header.has("unitname") && (header.has("earlier_than") || header.has("later_than"));
}

/// One table: names first, because a part may stand before the group it is part of.
class StratifyReader {
  public:
    StratifyReader(RecordBuilder& builder, const InputFile& file, const TableHeader& header)
        : builder_(builder), file_(file.name), header_(header) {}

    void read(const std::vector<TableRow>& rows) {
        for (const TableRow& row : rows) {
            if (text::fold_case(get(row, "unitclass")) == "group") groups_.insert(std::string(get(row, "unitname")));
        }
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (i == 0 && is_dummy(rows[i])) continue;
            read_row(rows[i]);
        }
    }

  private:
    [[nodiscard]] std::string_view get(const TableRow& row, std::string_view column) const {
        return cell(row, header_.find(column));
    }

    // Stratify wants a first row that is no unit.
    [[nodiscard]] bool is_dummy(const TableRow& row) const {
        if (text::fold_case(get(row, "unitname")) != "dummy") return false;
        return std::all_of(kLists.begin(), kLists.end(),
                           [&](const ListColumn& list) { return get(row, list.name).empty(); });
    }

    void read_row(const TableRow& row) {
        const std::string_view text = get(row, "unitname");
        const Place place{file_, row.line, text};
        if (text.empty()) {
            builder_.note(place, "unparsed", "a row without a name of a unit; left out");
            return;
        }
        if (groups_.contains(std::string(text))) {
            read_group(row, text);
        } else {
            read_unit(row, builder_.name(text));
        }
    }

    void read_group(const TableRow& row, std::string_view name) {
        ImportedGroup& group = builder_.group(name);
        group.values.type = "group";
        group.parent = get(row, "part_of");
        for (const ListColumn& list : kLists) {
            if (get(row, list.name).empty()) continue;
            builder_.note({file_, row.line, get(row, list.name)}, "group-relation",
                          fmt::format("group {} has relations of its own; only its units can have them", name));
        }
    }

    void read_unit(const TableRow& row, const UnitName& name) {
        const Place place{file_, row.line, {}};
        ImportedUnit& unit = builder_.unit(name, place);
        set_kind(unit, get(row, "unittype"));
        unit.period = get(row, "period");
        unit.phase = get(row, "phase");
        if (const std::string_view where = get(row, "location"); !where.empty())
            unit.values.details["position"] = where;
        if (const std::string_view how = get(row, "conditions"); !how.empty()) unit.values.details["conditions"] = how;
        for (const std::string& column : header_.names()) {
            const bool elsewhere = std::find(kElsewhere.begin(), kElsewhere.end(), column) != kElsewhere.end() ||
                                   column == "period" || column == "location" || column == "conditions";
            const bool is_list =
                std::any_of(kLists.begin(), kLists.end(), [&](const auto& l) { return l.name == column; });
            if (!elsewhere && !is_list && !column.empty()) add_custom_field(unit, column, get(row, column));
        }
        for (const std::string& group : split_list(get(row, "part_of"), ListSeparator::Comma)) {
            builder_.add_member(group, name);
        }
        for (const ListColumn& list : kLists) {
            for (const std::string& other : split_list(get(row, list.name), ListSeparator::Comma)) {
                const std::string raw = fmt::format("{}: {}", list.name, other);
                builder_.relate(name, list.kind, builder_.name(other), {file_, row.line, raw});
            }
        }
    }

    RecordBuilder& builder_;
    std::string_view file_;
    const TableHeader& header_;
    std::set<std::string> groups_;
};

bool has_columns(const DelimitedTable& table) {
    return !table.rows.empty() && is_stratify(TableHeader(table.rows.front()));
}

void read_table(DelimitedTable& table, const InputFile& file, RecordBuilder& builder) {
    if (!has_columns(table)) {
        throw Error(ErrorCode::BadInput,
                    file.name + ": the first line has no columns Unitname, Earlier than and Later than of Stratify");
    }
    const TableHeader header(table.rows.front());
    table.rows.erase(table.rows.begin());
    StratifyReader(builder, file, header).read(table.rows);
}

Recognition recognise(std::span<const InputFile> files) {
    return recognise_tables(files, has_columns, "columns Unitname, Earlier than, Later than");
}

Imported<ImportedRecord> read(std::span<const InputFile* const> files, const ReadOptions& options, Progress& progress) {
    return read_tables(files, options, progress, "a Stratify table", read_table);
}

} // namespace

const Reader& stratify_csv_reader() {
    static const Reader reader = {"stratify-csv", "Stratify table (.csv)", recognise, read};
    return reader;
}

} // namespace planum::strat
