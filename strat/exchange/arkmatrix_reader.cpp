// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/readers.hpp"
#include "strat/exchange/record_builder.hpp"
#include "strat/exchange/table_reader.hpp"

namespace planum::strat {

namespace {

using model::DirectedKind;
using model::RelationKind;

constexpr std::array<std::string_view, 14> kTags = {"site",         "dataset",     "status", "class",  "type",
                                                    "label",        "description", "above",  "below",  "same",
                                                    "contemporary", "subgroup",    "group",  "landuse"};
constexpr std::array<std::string_view, 3> kLevels = {"subgroup", "group", "landuse"};

struct TaggedRow {
    std::string unit;
    std::string value;
    std::string tag;
    std::int64_t line = 0;
};

// The last field is the tag; commas between belong to the value, as real files do not quote them.
std::optional<TaggedRow> tagged(const TableRow& row) {
    if (row.cells.size() < 3) return std::nullopt;
    TaggedRow result{std::string{cell(row, 0)}, {}, text::fold_case(cell(row, row.cells.size() - 1)), row.line};
    for (std::size_t i = 1; i + 1 < row.cells.size(); ++i) {
        if (i > 1) result.value += ", ";
        result.value += cell(row, i);
    }
    return result;
}

bool is_known_tag(std::string_view tag) { return std::find(kTags.begin(), kTags.end(), tag) != kTags.end(); }

bool is_tagged(const DelimitedTable& table) {
    const auto known = std::count_if(table.rows.begin(), table.rows.end(), [](const TableRow& row) {
        const auto entry = tagged(row);
        return entry && is_known_tag(entry->tag);
    });
    return known > 0 && known * 10 >= std::ssize(table.rows) * 6;
}

// Two short cells in every row, none of them a heading in words above numbers.
bool is_simple(const DelimitedTable& table) {
    if (table.rows.empty() || cell(table.rows.front(), 0).empty()) return false;
    const auto has_digit = [](std::string_view s) {
        return std::any_of(s.begin(), s.end(), [](char c) { return c >= '0' && c <= '9'; });
    };
    std::size_t with_digits = 0;
    for (const TableRow& row : table.rows) {
        if (row.cells.size() != 2 || cell(row, 0).size() > 20 || cell(row, 1).size() > 20) return false;
        with_digits += has_digit(cell(row, 0)) || has_digit(cell(row, 1)) ? 1U : 0U;
    }
    const bool heading = !has_digit(cell(table.rows.front(), 0)) && !has_digit(cell(table.rows.front(), 1));
    return with_digits * 2 > table.rows.size() && !heading;
}

void read_simple(const DelimitedTable& table, std::string_view file, RecordBuilder& builder) {
    std::string above;
    std::string below;
    for (const TableRow& row : table.rows) {
        const std::string first{cell(row, 0)};
        const std::string second{cell(row, 1)};
        const std::string raw = first + "," + second;
        const Place place{file, row.line, raw};
        if (row.cells.size() > 2) builder.note(place, "unparsed", "more than two cells; only two were read");
        above = first.empty() ? below : first; // an empty cell goes on from the row before
        below = second;
        if (below.empty() && !above.empty()) {
            builder.unit(builder.name(above), place); // a unit that stands alone
            below = above;
            continue;
        }
        StatedRelation* relation =
            builder.relate(builder.name(above), {RelationKind::Covers, false}, builder.name(below), place);
        if (relation != nullptr) relation->side = model::StatementSide::Neither;
    }
}

/// Reads rows of three; groups are known only once all rows are.
class TaggedReader {
  public:
    TaggedReader(RecordBuilder& builder, std::string_view file) : builder_(builder), file_(file) {}

    void read(const DelimitedTable& table) {
        std::vector<TaggedRow> rows;
        for (const TableRow& row : table.rows) {
            const auto entry = tagged(row);
            if (entry) {
                rows.push_back(*entry);
            } else {
                builder_.note({file_, row.line, text::join(row.cells, ",")}, "unparsed",
                              "not three cells: unit, value, tag; left out");
            }
        }
        for (const TaggedRow& row : rows) {
            if (const auto level = level_of(row.tag)) groups_[row.value].insert(*level);
        }
        for (const TaggedRow& row : rows) read_row(row);
    }

  private:
    static std::optional<std::size_t> level_of(std::string_view tag) {
        const auto it = std::find(kLevels.begin(), kLevels.end(), tag);
        if (it == kLevels.end()) return std::nullopt;
        return static_cast<std::size_t>(it - kLevels.begin());
    }

    // The same number may be a subgroup and a group; then the higher ones carry their level's word.
    std::string group_number(const std::string& number, std::size_t level) const {
        const auto it = groups_.find(number);
        const bool lowest = it == groups_.end() || *it->second.begin() == level;
        return lowest ? number : fmt::format("{} {}", kLevels.at(level), number);
    }

    void read_row(const TaggedRow& row) {
        const std::string raw = fmt::format("{},{},{}", row.unit, row.value, row.tag);
        const Place place{file_, row.line, raw};
        if (row.tag == "site" || row.tag == "dataset") {
            std::string& name = builder_.record.project_name;
            if (!row.unit.empty()) name += (name.empty() ? "" : " ") + row.unit;
            return;
        }
        if (row.unit.empty()) {
            builder_.note(place, "unparsed", "a line without a unit was left out");
            return;
        }
        if (const auto level = level_of(row.tag)) return read_group(row, *level, place);
        const UnitName name = builder_.name(row.unit);
        if (row.tag == "above" || row.tag == "below") {
            builder_.relate(name, {RelationKind::Covers, row.tag == "below"}, builder_.name(row.value), place);
        } else if (row.tag == "same") {
            builder_.relate(name, {RelationKind::SameAs, false}, builder_.name(row.value), place);
        } else if (row.tag == "contemporary") {
            builder_.relate(name, {RelationKind::Contemporary, false}, builder_.name(row.value), place);
        } else {
            read_field(row, name, place);
        }
    }

    void read_field(const TaggedRow& row, const UnitName& name, const Place& place) {
        if (!is_known_tag(row.tag)) {
            builder_.note(place, "unknown-tag", fmt::format("the tag {} is not known; left out", row.tag));
            return;
        }
        ImportedUnit& unit = builder_.unit(name, place);
        if (row.tag == "label") builder_.fill(unit.values.title, row.value, "the label", place);
        if (row.tag == "description") builder_.fill(unit.values.description, row.value, "the description", place);
        if (row.tag == "status") read_status(row.value, unit, place);
        if ((row.tag == "class" || row.tag == "type") && text::fold_case(row.value) != "undefined") {
            const auto kind = model::kind_from_any_word(row.value);
            if (!kind) {
                builder_.note(place, "unknown-type", fmt::format("the class {} is not known", row.value));
                return;
            }
            unit.values.kind = kind->kind;
            unit.values.form = kind->form;
        }
    }

    void read_status(std::string_view value, ImportedUnit& unit, const Place& place) {
        const std::string status = text::fold_case(value);
        if (status == "void") {
            unit.values.status = model::UnitStatus::Void;
        } else if (status != "assigned" && status != "allocated") {
            builder_.note(place, "unknown-status", fmt::format("the status {} is not known", value));
        }
    }

    void read_group(const TaggedRow& row, std::size_t level, const Place& place) {
        if (row.value.empty()) {
            builder_.note(place, "empty-target", "a line without a group was left out");
            return;
        }
        const std::string number = group_number(row.value, level);
        builder_.group(number).values.type = kLevels.at(level);
        const auto below = groups_.find(row.unit);
        if (below != groups_.end()) {
            // The highest level under this one is what stands in it.
            for (std::size_t inner = level; inner-- > 0;) {
                if (!below->second.contains(inner)) continue;
                const std::string inner_number = group_number(row.unit, inner);
                builder_.group(inner_number).values.type = kLevels.at(inner);
                builder_.fill(builder_.group(inner_number).parent, number, "the group around " + row.unit, place);
                return;
            }
        }
        builder_.add_member(number, builder_.name(row.unit));
    }

    RecordBuilder& builder_;
    std::string_view file_;
    std::map<std::string, std::set<std::size_t>> groups_; ///< number → levels it occurs on
};

Recognition recognise(std::span<const InputFile> files) {
    Recognition result;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const DelimitedTable table = glimpse_table(files[i]);
        const bool tagged_rows = is_tagged(table);
        if (!tagged_rows && !is_simple(table)) continue;
        result.files.push_back(i);
        const Confidence confidence = tagged_rows ? Confidence::Certain : Confidence::Possible;
        if (confidence <= result.confidence) continue;
        result.confidence = confidence;
        result.why = tagged_rows ? "rows of unit, value, tag" : "two columns of numbers without a header";
    }
    return result;
}

void read_table(DelimitedTable& table, const InputFile& file, RecordBuilder& builder) {
    if (is_tagged(table)) {
        TaggedReader(builder, file.name).read(table);
    } else if (std::any_of(table.rows.begin(), table.rows.end(), [](const auto& r) { return r.cells.size() > 1; })) {
        read_simple(table, file.name, builder);
    } else {
        throw Error(ErrorCode::BadInput,
                    fmt::format("{}: neither two columns (above, below) nor three (unit, value, tag)", file.name));
    }
}

Imported<ImportedRecord> read(std::span<const InputFile* const> files, const ReadOptions& options, Progress& progress) {
    return read_tables(files, options, progress, "an ArkMatrix table", read_table);
}

} // namespace

const Reader& arkmatrix_reader() {
    static const Reader reader{"arkmatrix", "ArkMatrix table, simple or tagged (.csv)", recognise, read};
    return reader;
}

} // namespace planum::strat
