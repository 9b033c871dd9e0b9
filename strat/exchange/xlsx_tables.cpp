// SPDX-License-Identifier: MIT
#include "strat/exchange/xlsx_tables.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/text.hpp"

namespace planum::strat {

namespace {

using Cell = XlsxCell;
using Row = std::vector<Cell>;
using Sheet = XlsxSheet;

template<class Number>
Cell cell(const std::optional<Number>& value) {
    return value ? Cell{static_cast<double>(*value)} : Cell{};
}

Cell cell(std::string_view value) { return value.empty() ? Cell{} : Cell{std::string(value)}; }

class Sheets {
  public:
    explicit Sheets(const RecordNames& names) : names_(names), record_(names.record()) {
        for (const model::Source& source : record_.sources) sources_.emplace(source.id, source.name);
    }

    [[nodiscard]] std::vector<Sheet> all() const {
        std::vector<Sheet> sheets = {units(),  relations(), statements(), phases(),    periods(), groups(), datings(),
                                     levels(), finds(),     samples(),    documents(), regions(), scans()};
        std::erase_if(sheets, [](const Sheet& sheet) { return sheet.rows.empty(); });
        if (sheets.empty()) sheets.push_back(units());
        return sheets;
    }

  private:
    [[nodiscard]] Cell unit(model::UnitId id) const { return names_.has(id) ? cell(names_.unit(id)) : Cell{}; }

    // Only those fields of the full record that some unit fills.
    [[nodiscard]] Sheet units() const {
        Sheet sheet{"Units",
                    {"Unit", "Area", "Kind", "Form", "Status", "Title", "Description", "Interpretation", "Phase",
                     "Period", "Begun", "Finished", "Recorded by", "Recorded on", "Part of"},
                    {}};
        std::vector<std::string_view> used;
        for (const model::UnitFieldInfo& info : model::kUnitFields) {
            const bool filled = std::any_of(record_.units.begin(), record_.units.end(),
                                            [&](const auto& u) { return u.details.contains(info.name); });
            if (!filled) continue;
            used.push_back(info.name);
            sheet.columns.emplace_back(info.label);
        }
        for (const model::StratigraphicUnit& u : record_.units) {
            Row row = {cell(names_.unit(u.id)),
                       cell(names_.area(u.area)),
                       cell(to_word(u.kind)),
                       cell(u.form == model::UnitForm::None ? "" : to_word(u.form)),
                       cell(to_word(u.status)),
                       cell(u.title),
                       cell(u.description),
                       cell(u.interpretation),
                       cell(names_.phase(u.phase)),
                       cell(names_.period(u.period)),
                       cell(u.excavated_from),
                       cell(u.excavated_on),
                       cell(u.recorded_by),
                       cell(u.recorded_on),
                       unit(u.parent)};
            for (const std::string_view name : used) {
                const auto it = u.details.find(name);
                row.push_back(it == u.details.end() ? Cell{} : cell(it->second));
            }
            sheet.rows.push_back(std::move(row));
        }
        return sheet;
    }

    [[nodiscard]] Sheet relations() const {
        Sheet sheet{"Relations", {"Unit", "Relation", "Other", "Certainty", "Statements"}, {}};
        std::map<model::RelationId, std::size_t> stated;
        for (const model::RelationStatement& statement : record_.statements) ++stated[statement.relation];
        for (const std::size_t i : complete_relations(names_)) {
            const model::PhysicalRelation& r = record_.relations[i];
            sheet.rows.push_back({unit(r.subject), cell(phrase(r.kind)), unit(r.object), cell(to_word(r.certainty)),
                                  Cell{static_cast<double>(stated[r.id])}});
        }
        return sheet;
    }

    [[nodiscard]] Sheet statements() const {
        Sheet sheet{"Statements",
                    {"Unit", "Relation", "Other", "Sheet of", "Source", "Line", "Person", "As written", "Stated at"},
                    {}};
        std::map<model::RelationId, const model::PhysicalRelation*> by_id;
        for (const model::PhysicalRelation& relation : record_.relations) by_id.emplace(relation.id, &relation);
        for (const model::RelationStatement& s : record_.statements) {
            const auto it = by_id.find(s.relation);
            if (it == by_id.end()) continue;
            const auto source = sources_.find(s.source);
            sheet.rows.push_back({unit(it->second->subject), cell(phrase(it->second->kind)), unit(it->second->object),
                                  cell(to_word(s.side)), source == sources_.end() ? Cell{} : cell(source->second),
                                  s.line > 0 ? Cell{static_cast<double>(s.line)} : Cell{}, cell(s.person),
                                  cell(s.raw_text), cell(s.stated_at)});
        }
        return sheet;
    }

    [[nodiscard]] Sheet phases() const {
        Sheet sheet{"Phases", {"Phase", "Title", "Period", "From", "To", "Rank", "Description"}, {}};
        for (const model::Phase& p : record_.phases) {
            sheet.rows.push_back({cell(p.number), cell(p.title), cell(names_.period(p.period)), cell(p.from),
                                  cell(p.to), cell(p.rank), cell(p.description)});
        }
        return sheet;
    }

    [[nodiscard]] Sheet periods() const {
        Sheet sheet{"Periods", {"Period", "Title", "From", "To", "Rank", "Description"}, {}};
        for (const model::Period& p : record_.periods) {
            sheet.rows.push_back(
                {cell(p.number), cell(p.title), cell(p.from), cell(p.to), cell(p.rank), cell(p.description)});
        }
        return sheet;
    }

    [[nodiscard]] Sheet groups() const {
        Sheet sheet{"Groups", {"Group", "Type", "Title", "Part of", "Units", "Description"}, {}};
        for (const model::UnitGroup& g : record_.groups) {
            std::vector<std::string> members;
            for (const model::UnitId member : g.members) {
                if (names_.has(member)) members.push_back(names_.unit(member));
            }
            sheet.rows.push_back({cell(g.number), cell(g.type), cell(g.title), cell(names_.group(g.parent)),
                                  cell(text::join(members, ", ")), cell(g.description)});
        }
        return sheet;
    }

    [[nodiscard]] Sheet datings() const {
        Sheet sheet{"Dates", {"Label", "Unit", "Find", "Kind", "From", "To", "BP", "±", "Association", "Notes"}, {}};
        for (const model::Dating& d : record_.datings) {
            sheet.rows.push_back({cell(d.label), unit(d.unit), cell(names_.find(d.find)), cell(to_word(d.kind)),
                                  cell(d.from), cell(d.to), cell(d.bp), cell(d.bp_error), cell(d.association),
                                  cell(d.notes)});
        }
        return sheet;
    }

    [[nodiscard]] Sheet levels() const {
        Sheet sheet{"Levels", {"Unit", "Role", "x [m]", "y [m]", "z [m]", "Label"}, {}};
        for (const model::Level& l : record_.levels) {
            sheet.rows.push_back({unit(l.unit), cell(to_word(l.role)), cell(l.x), cell(l.y), Cell{l.z}, cell(l.label)});
        }
        return sheet;
    }

    [[nodiscard]] Sheet finds() const {
        Sheet sheet{"Finds",
                    {"Find", "Unit", "Type", "Material", "Count", "Weight [g]", "x [m]", "y [m]", "z [m]", "Condition",
                     "Box", "Found on", "Description"},
                    {}};
        for (const model::Find& f : record_.finds) {
            sheet.rows.push_back({cell(f.number), unit(f.unit), cell(f.type), cell(f.material), cell(f.count),
                                  cell(f.weight), cell(f.x), cell(f.y), cell(f.z), cell(f.condition), cell(f.box),
                                  cell(f.found_on), cell(f.description)});
        }
        return sheet;
    }

    [[nodiscard]] Sheet samples() const {
        Sheet sheet{"Samples",
                    {"Sample", "Unit", "Type", "Volume [l]", "Weight [g]", "Laboratory number", "State", "Description"},
                    {}};
        for (const model::Sample& s : record_.samples) {
            sheet.rows.push_back({cell(s.number), unit(s.unit), cell(s.type), cell(s.volume), cell(s.weight),
                                  cell(s.laboratory_number), cell(s.state), cell(s.description)});
        }
        return sheet;
    }

    [[nodiscard]] Sheet documents() const {
        Sheet sheet{"Documents", {"Document", "Type", "Title", "Unit", "Path", "Made on", "Author"}, {}};
        for (const model::Document& d : record_.documents) {
            sheet.rows.push_back({cell(d.number), cell(d.type), cell(d.title), unit(d.unit), cell(d.path),
                                  cell(d.made_on), cell(d.author)});
        }
        return sheet;
    }

    [[nodiscard]] Sheet regions() const {
        Sheet sheet{
            "Regions", {"Unit", "Part", "Surface", "Day", "Category", "Shows", "σ [m]", "Drawn on", "Notes"}, {}};
        for (const model::Region& r : record_.regions) {
            const auto surface = std::find_if(record_.surfaces.begin(), record_.surfaces.end(),
                                              [&](const auto& s) { return s.id == r.surface; });
            const bool found = surface != record_.surfaces.end();
            sheet.rows.push_back({names_.has(r.unit) ? unit(r.unit) : cell(r.unit_as_drawn),
                                  Cell{static_cast<double>(r.part)}, found ? cell(surface->name) : Cell{},
                                  found ? cell(surface->first_day) : Cell{}, cell(to_word(r.category)),
                                  cell(to_word(r.shows)), Cell{r.sigma}, cell(r.drawn_on), cell(r.notes)});
        }
        return sheet;
    }

    [[nodiscard]] Sheet scans() const {
        Sheet sheet{"Scans", {"Scan", "Day", "Points", "Format", "Sensor", "File", "SHA-256"}, {}};
        for (const model::Scan& s : record_.scans) {
            sheet.rows.push_back({cell(s.name), cell(s.day), Cell{static_cast<double>(s.points)}, cell(s.format),
                                  cell(s.sensor), cell(s.path), cell(s.sha256)});
        }
        return sheet;
    }

    const RecordNames& names_;
    const model::Record& record_;
    std::map<model::SourceId, std::string> sources_;
};

} // namespace

std::vector<XlsxSheet> xlsx_tables(const RecordNames& names) { return Sheets(names).all(); }

} // namespace planum::strat
