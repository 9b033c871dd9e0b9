// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/base/text.hpp"
#include "strat/exchange/planum_csv.hpp"
#include "strat/exchange/write_support.hpp"
#include "strat/exchange/writers.hpp"

namespace planum::strat {

namespace {

using model::RelationKind;

/// One row: values by column, in any order.
using Row = std::map<std::string_view, std::string>;

std::string text_of(const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : std::string{}; // shortest text that reads back the same
}

std::string text_of(const std::optional<std::int64_t>& value) {
    return value ? fmt::format("{}", *value) : std::string{};
}

/// Gathers rows and leaves out the columns that stay empty in all of them.
class TableText {
  public:
    explicit TableText(CsvTable table) : table_(table) {}

    void add(Row row) { rows_.push_back(std::move(row)); }

    [[nodiscard]] bool empty() const { return rows_.empty(); }

    [[nodiscard]] std::string write(const WriteOptions& options) const {
        std::vector<std::string_view> columns;
        const auto all = csv_columns(table_);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const bool needed = i < 3 || std::any_of(rows_.begin(), rows_.end(), [&](const Row& row) {
                                    const auto it = row.find(all[i]);
                                    return it != row.end() && !it->second.empty();
                                });
            if (needed) columns.push_back(all[i]);
        }
        const RowWriter writer{options.delimiter, "\n", false, options.guard_formulas};
        std::string out = options.byte_order_mark ? "\xEF\xBB\xBF" : "";
        out += writer.write(std::vector<std::string>(columns.begin(), columns.end()));
        for (const Row& row : rows_) {
            std::vector<std::string> cells;
            for (const std::string_view column : columns) {
                const auto it = row.find(column);
                cells.push_back(it == row.end() ? std::string{} : it->second);
            }
            out += writer.write(cells);
        }
        return out;
    }

  private:
    CsvTable table_;
    std::vector<Row> rows_;
};

/// The word from the object's side: `covered_by`, ….
std::string inverse_word(RelationKind kind) {
    switch (kind) {
    case RelationKind::Covers: return "covered_by";
    case RelationKind::Cuts: return "cut_by";
    case RelationKind::Fills: return "filled_by";
    case RelationKind::Abuts: return "abutted_by";
    case RelationKind::Later: return "earlier";
    case RelationKind::BondsWith:
    case RelationKind::SameAs:
    case RelationKind::Borders:
    case RelationKind::Contemporary: return std::string{model::to_word(kind)};
    }
    return {};
}

class CsvDocument {
  public:
    CsvDocument(const RecordNames& names, std::vector<std::string>& lost)
        : names_(names), record_(names.record()), lost_(lost) {}

    TableText units() {
        TableText table(CsvTable::Units);
        std::size_t numeric_base = 0;
        std::size_t far_parent = 0;
        for (const model::StratigraphicUnit& unit : record_.units) {
            if (unit.origin == model::UnitOrigin::Mentioned) continue; // relations name it
            Row row = {{"unit", unit.number},
                       {"area", names_.area(unit.area)},
                       {"kind", unit.kind == model::UnitKind::Unknown ? "" : std::string{model::to_word(unit.kind)}},
                       {"form", std::string{model::to_word(unit.form)}},
                       {"status", std::string{model::to_word(unit.status)}},
                       {"title", unit.title},
                       {"description", unit.description},
                       {"interpretation", unit.interpretation},
                       {"excavated_from", unit.excavated_from},
                       {"excavated_on", unit.excavated_on},
                       {"recorded_by", unit.recorded_by},
                       {"recorded_on", unit.recorded_on},
                       {"phase", names_.phase(unit.phase)},
                       {"period", names_.period(unit.period)}};
            if (names_.has(unit.parent)) {
                const model::StratigraphicUnit& parent = names_.unit_at(unit.parent);
                row["parent"] = parent.area == unit.area ? parent.number : qualified(parent);
                far_parent += parent.area.is_nil() && !unit.area.is_nil() ? 1U : 0U;
            }
            for (const auto& [name, value] : unit.details) row[name] = value;
            const auto base = unit.details.find("base");
            numeric_base += base != unit.details.end() && text::parse_double(base->second) ? 1U : 0U;
            table.add(std::move(row));
        }
        add_loss(lost_, numeric_base, "fields `base` that are numbers and will be read as heights");
        add_loss(lost_, far_parent, "parents without an area, which will be read as of their unit's area");
        return table;
    }

    TableText relations() {
        TableText table(CsvTable::Relations);
        std::unordered_map<model::RelationId, std::vector<const model::RelationStatement*>> statements;
        for (const model::RelationStatement& statement : record_.statements) {
            statements[statement.relation].push_back(&statement);
        }
        for (const std::size_t i : complete_relations(names_)) {
            const model::PhysicalRelation& relation = record_.relations[i];
            const auto said = statements.find(relation.id);
            if (said == statements.end()) {
                table.add(relation_row(relation, nullptr));
                continue;
            }
            for (const model::RelationStatement* statement : said->second) {
                table.add(relation_row(relation, statement));
            }
        }
        add_loss(lost_, far_others_, "relations from an area to a unit without one, which will be read as of it");
        add_loss(lost_, lists_,
                 "units without a sheet whose number has a comma or semicolon and will be read as a list");
        return table;
    }

    TableText members() const {
        TableText table(CsvTable::Members);
        for (const model::UnitGroup& group : record_.groups) {
            for (const model::UnitId member : group.members) {
                if (!names_.has(member)) continue;
                table.add(with_unit({{"group", group.number}}, member));
            }
        }
        return table;
    }

    TableText levels() const {
        TableText table(CsvTable::Levels);
        for (const model::Level& level : record_.levels) {
            if (!names_.has(level.unit)) continue;
            table.add(with_unit({{"z", text_of(std::optional{level.z})},
                                 {"role", std::string{model::to_word(level.role)}},
                                 {"x", text_of(level.x)},
                                 {"y", text_of(level.y)},
                                 {"label", level.label}},
                                level.unit));
        }
        return table;
    }

    TableText finds() const {
        TableText table(CsvTable::Finds);
        for (const model::Find& find : record_.finds) {
            table.add(with_unit({{"find", find.number},
                                 {"x", text_of(find.x)},
                                 {"y", text_of(find.y)},
                                 {"z", text_of(find.z)},
                                 {"type", find.type},
                                 {"material", find.material},
                                 {"count", text_of(find.count)},
                                 {"weight", text_of(find.weight)},
                                 {"condition", find.condition},
                                 {"box", find.box},
                                 {"found_on", find.found_on},
                                 {"description", find.description}},
                                find.unit));
        }
        return table;
    }

    TableText samples() const {
        TableText table(CsvTable::Samples);
        for (const model::Sample& sample : record_.samples) {
            table.add(with_unit({{"sample", sample.number},
                                 {"type", sample.type},
                                 {"volume", text_of(sample.volume)},
                                 {"weight", text_of(sample.weight)},
                                 {"laboratory_number", sample.laboratory_number},
                                 {"state", sample.state},
                                 {"description", sample.description}},
                                sample.unit));
        }
        return table;
    }

    TableText documents() const {
        TableText table(CsvTable::Documents);
        for (const model::Document& document : record_.documents) {
            table.add(with_unit({{"document", document.number},
                                 {"type", document.type},
                                 {"title", document.title},
                                 {"path", document.path},
                                 {"made_on", document.made_on},
                                 {"author", document.author}},
                                document.unit));
        }
        return table;
    }

    TableText datings() const {
        TableText table(CsvTable::Datings);
        for (const model::Dating& dating : record_.datings) {
            table.add(with_unit({{"dating", dating.label},
                                 {"find", names_.find(dating.find)},
                                 {"kind", std::string{model::to_word(dating.kind)}},
                                 {"from", text_of(dating.from)},
                                 {"to", text_of(dating.to)},
                                 {"bp", text_of(dating.bp)},
                                 {"error", text_of(dating.bp_error)},
                                 {"association", dating.association},
                                 {"notes", dating.notes}},
                                dating.unit));
        }
        return table;
    }

    TableText phases() const {
        TableText table(CsvTable::Phases);
        for (const model::Phase& phase : record_.phases) {
            Row row = chronology_row(phase);
            row["phase"] = names_.phase(phase.id);
            row["period"] = names_.period(phase.period);
            table.add(std::move(row));
        }
        return table;
    }

    TableText periods() const {
        TableText table(CsvTable::Periods);
        for (const model::Period& period : record_.periods) {
            Row row = chronology_row(period);
            row["period"] = period.number;
            table.add(std::move(row));
        }
        return table;
    }

    TableText groups() const {
        TableText table(CsvTable::Groups);
        for (const model::UnitGroup& group : record_.groups) {
            table.add({{"group", group.number},
                       {"type", group.type},
                       {"title", group.title},
                       {"description", group.description},
                       {"parent", names_.group(group.parent)}});
        }
        return table;
    }

    TableText areas() const {
        TableText table(CsvTable::Areas);
        for (const model::Area& area : record_.areas) {
            table.add({{"area", area.name},
                       {"title", area.title},
                       {"method", std::string{model::to_word(area.method)}},
                       {"first_number", area.first_number},
                       {"last_number", area.last_number}});
        }
        return table;
    }

  private:
    [[nodiscard]] std::string qualified(const model::StratigraphicUnit& unit) const {
        const std::string area = names_.area(unit.area);
        return area.empty() ? unit.number : area + "::" + unit.number;
    }

    [[nodiscard]] Row with_unit(Row row, model::UnitId id) const {
        if (!names_.has(id)) return row;
        const model::StratigraphicUnit& unit = names_.unit_at(id);
        row["unit"] = unit.number;
        row["area"] = names_.area(unit.area);
        return row;
    }

    template<class Value>
    static Row chronology_row(const Value& value) {
        return {{"title", value.title},
                {"description", value.description},
                {"from", text_of(value.from)},
                {"to", text_of(value.to)},
                {"rank", text_of(value.rank)}};
    }

    Row relation_row(const model::PhysicalRelation& relation, const model::RelationStatement* statement) {
        const bool inverse = statement != nullptr && statement->side == model::StatementSide::Object;
        const auto& first = names_.unit_at(inverse ? relation.object : relation.subject);
        const auto& second = names_.unit_at(inverse ? relation.subject : relation.object);
        Row row = with_unit({}, first.id);
        row["relation"] = inverse ? inverse_word(relation.kind) : std::string{model::to_word(relation.kind)};
        row["other"] = second.number;
        if (second.area != first.area) row["other_area"] = names_.area(second.area);
        far_others_ += second.area.is_nil() && !first.area.is_nil() ? 1U : 0U;
        const bool bare = second.origin == model::UnitOrigin::Mentioned;
        lists_ += bare && second.number.find_first_of(",;") != std::string::npos ? 1U : 0U;
        if (relation.certainty == model::Certainty::Uncertain) row["certainty"] = "uncertain";
        if (relation.correlation) row["correlation"] = "yes";
        if (statement == nullptr) return row;
        row["person"] = statement->person;
        if (statement->side == model::StatementSide::Neither) row["side"] = "neither";
        return row;
    }

    const RecordNames& names_;
    const model::Record& record_;
    std::vector<std::string>& lost_;
    std::size_t far_others_ = 0;
    std::size_t lists_ = 0;
};

TableText table_of(CsvTable table, CsvDocument& document) {
    switch (table) {
    case CsvTable::Units: return document.units();
    case CsvTable::Relations: return document.relations();
    case CsvTable::Members: return document.members();
    case CsvTable::Levels: return document.levels();
    case CsvTable::Finds: return document.finds();
    case CsvTable::Samples: return document.samples();
    case CsvTable::Documents: return document.documents();
    case CsvTable::Datings: return document.datings();
    case CsvTable::Phases: return document.phases();
    case CsvTable::Periods: return document.periods();
    case CsvTable::Groups: return document.groups();
    case CsvTable::Areas: return document.areas();
    }
    return TableText(table);
}

} // namespace

Written write_planum_csv(const model::Record& record, const WriteOptions& options) {
    Written written;
    written.lost = losses(record, carries_everything());
    const RecordNames names(record);
    CsvDocument document(names, written.lost);
    for (const CsvTable table : kAllCsvTables) {
        const TableText text = table_of(table, document);
        if (text.empty() && table != CsvTable::Units) continue;
        written.files.push_back({std::string{csv_name(table)} + ".csv", text.write(options)});
    }
    return written;
}

} // namespace planum::strat
