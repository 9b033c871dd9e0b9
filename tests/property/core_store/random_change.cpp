// SPDX-License-Identifier: MIT
#include "tests/property/core_store/random_change.hpp"

#include <algorithm>
#include <random>
#include <utility>

namespace planum::test {

using namespace planum::model;
using store::ProjectFile;

namespace {

/// Random picks from one record, with ids of what is there.
class Dice {
  public:
    explicit Dice(std::uint32_t seed) : random_(seed) {}

    [[nodiscard]] std::size_t below(std::size_t n) { return random_() % n; }

    [[nodiscard]] bool one_in(std::size_t n) { return below(n) == 0; }

    [[nodiscard]] std::string text() {
        static const std::array<const char*, 5> words = {"", "brown silt", "a\nb", "Ü 'x' \"y\"", "10YR 4/3"};
        return words[below(words.size())];
    }

    [[nodiscard]] std::string fresh(const char* prefix) { return prefix + std::to_string(random_()); }

    [[nodiscard]] double real() { return static_cast<double>(static_cast<int>(below(20001)) - 10000) / 7.0; }

    template<class T>
    [[nodiscard]] auto id(const std::vector<T>& values) -> decltype(T::id) {
        return values.empty() || one_in(4) ? decltype(T::id){} : values[below(values.size())].id;
    }

    template<class T>
    [[nodiscard]] T& of(std::vector<T>& values) {
        return values[below(values.size())];
    }

  private:
    std::mt19937 random_;
};

void shake(Dice& dice, const Record&, Area& v) {
    v.title = dice.text(), v.method = static_cast<DigMethod>(dice.below(3));
}

void shake(Dice& dice, const Record&, Source& v) { v.format = dice.text(), v.states_both_sides = dice.one_in(2); }

void shake(Dice& dice, const Record&, Period& v) { v.title = dice.text(), v.from = static_cast<Year>(dice.below(99)); }

void shake(Dice& dice, const Record& r, Phase& v) { v.description = dice.text(), v.period = dice.id(r.periods); }

void shake(Dice& dice, const Record& r, StratigraphicUnit& v) {
    v.kind = static_cast<UnitKind>(dice.below(9));
    v.status = static_cast<UnitStatus>(dice.below(5));
    v.title = dice.text();
    v.phase = dice.id(r.phases);
    v.parent = dice.id(r.units);
    v.details.clear();
    if (dice.one_in(2)) v.details["colour"] = "grey " + dice.text();
}

void shake(Dice& dice, const Record&, PhysicalRelation& v) {
    v.kind = static_cast<RelationKind>(dice.below(9));
    v.certainty = static_cast<Certainty>(dice.below(2));
}

void shake(Dice& dice, const Record& r, UnitGroup& v) {
    v.title = dice.text();
    v.members.clear();
    for (const StratigraphicUnit& unit : r.units) {
        if (dice.one_in(3)) v.members.push_back(unit.id);
    }
}

void shake(Dice& dice, const Record&, Dating& v) { v.label = dice.text(), v.bp = dice.real(); }

void shake(Dice& dice, const Record&, Level& v) { v.z = dice.real(), v.x = dice.real(), v.y = dice.real(); }

void shake(Dice& dice, const Record& r, Find& v) { v.z = dice.real(), v.unit = dice.id(r.units), v.type = dice.text(); }

void shake(Dice& dice, const Record& r, Sample& v) { v.state = dice.text(), v.unit = dice.id(r.units); }

void shake(Dice& dice, const Record& r, Document& v) { v.path = dice.text(), v.unit = dice.id(r.units); }

void shake(Dice& dice, const Record& r, Surface& v) {
    v.order = static_cast<std::int64_t>(dice.below(9)), v.area = dice.id(r.areas);
}

void shake(Dice& dice, const Record&, Section& v) { v.to_in_site = {dice.real(), dice.real()}; }

void shake(Dice& dice, const Record& r, Scan& v) {
    v.points = static_cast<std::int64_t>(dice.below(999)), v.surface = dice.id(r.surfaces);
}

void shake(Dice& dice, const Record&, RegistrationRun& v) { v.state = dice.text(); }

void shake(Dice& dice, const Record& r, Region& v) {
    v.unit = dice.id(r.units);
    v.shows = static_cast<RegionShows>(dice.below(7));
    v.outline = {Polygon{{{0, 0, dice.real()}, {dice.real(), 0, 1}, {0, dice.real(), 2}}, {}}};
    v.has_heights = !dice.one_in(4);
    if (v.has_heights) return;
    for (auto& p : v.outline.front().outer) p[2] = 0.0;
}

void shake(Dice& dice, const Record& r, Interpretation& v) {
    v.author = dice.text();
    v.dropped.clear();
    for (const PhysicalRelation& relation : r.relations) {
        if (dice.one_in(4)) v.dropped.push_back(relation.id);
    }
    if (!v.added.empty() && dice.one_in(2)) v.added.pop_back();
    if (r.units.size() > 1) {
        PhysicalRelation added;
        added.subject = r.units.front().id;
        added.object = r.units.back().id;
        v.added.push_back(added);
    }
}

template<class T>
T made(Dice& dice, const Record& record) {
    T value;
    if constexpr (requires { value.number; }) value.number = dice.fresh("n");
    if constexpr (requires { value.name; }) value.name = dice.fresh("name ");
    shake(dice, record, value);
    return value;
}

/// Updates or removes one record of one kind.
template<class T>
void change_one(ProjectFile& project, Dice& dice, Record& record, std::vector<T>& values, bool removable) {
    T& value = dice.of(values);
    if constexpr (requires { project.remove(value.id); }) {
        if (removable && dice.one_in(3)) {
            project.remove(value.id);
            values.erase(values.begin() + (&value - values.data()));
            return;
        }
    }
    shake(dice, record, value);
    project.update(value);
}

/// Inserts, updates or removes one record of one kind.
template<class T>
void step(ProjectFile& project, Dice& dice, Record& record, std::vector<T>& values, bool removable) {
    if (!values.empty() && !dice.one_in(2)) return change_one(project, dice, record, values, removable);
    T value = made<T>(dice, record);
    value.id = project.insert(value);
    values.push_back(value);
}

void relation_step(ProjectFile& project, Dice& dice, Record& record) {
    if (record.units.empty()) return;
    if (!record.relations.empty() && dice.one_in(2)) {
        return change_one(project, dice, record, record.relations, true);
    }
    PhysicalRelation relation;
    relation.subject = dice.of(record.units).id;
    relation.object = dice.of(record.units).id;
    relation.kind = static_cast<RelationKind>(dice.below(9));
    relation.id = project.insert(relation);
    record.relations.push_back(relation);
    project.insert(
        RelationStatement{{}, relation.id, StatementSide::Object, dice.id(record.sources), 3, "", dice.text(), ""});
}

void level_step(ProjectFile& project, Dice& dice, Record& record) {
    if (record.units.empty()) return;
    Level level = made<Level>(dice, record);
    level.unit = dice.of(record.units).id;
    project.insert(level);
    Dating dating = made<Dating>(dice, record);
    dating.unit = level.unit;
    project.insert(dating);
}

void scan_step(ProjectFile& project, Dice& dice, Record& record) {
    if (dice.one_in(2)) step(project, dice, record, record.scans, true);
    if (dice.one_in(2)) step(project, dice, record, record.runs, false);
    if (record.scans.empty()) return;
    ScanPose pose;
    pose.scan = dice.of(record.scans).id;
    pose.run = dice.id(record.runs);
    pose.site_from_scan[3] = dice.real();
    project.insert(pose);
}

void settings_step(ProjectFile& project, Dice& dice, Record& record) {
    record.settings.name = dice.text();
    record.settings.srs_id = dice.one_in(2) ? 25832 : -1;
    project.update(record.settings);
}

void any_step(ProjectFile& project, Dice& dice, Record& record) {
    switch (dice.below(19)) {
    case 0: return step(project, dice, record, record.areas, true);
    case 1: return step(project, dice, record, record.sources, false);
    case 2: return step(project, dice, record, record.periods, true);
    case 3: return step(project, dice, record, record.phases, true);
    case 4: return step(project, dice, record, record.groups, true);
    case 5: return step(project, dice, record, record.finds, true);
    case 6: return step(project, dice, record, record.samples, true);
    case 7: return step(project, dice, record, record.documents, true);
    case 8: return step(project, dice, record, record.surfaces, true);
    case 9: return step(project, dice, record, record.sections, true);
    case 10: return step(project, dice, record, record.regions, true);
    case 11: return step(project, dice, record, record.interpretations, true);
    case 12: return scan_step(project, dice, record);
    case 13: return level_step(project, dice, record);
    case 14: return settings_step(project, dice, record);
    case 15:
    case 16: return relation_step(project, dice, record);
    default: break;
    }
    // Removing a unit takes others along; what the picks still know of them is read again with the next change.
    step(project, dice, record, record.units, false);
}

} // namespace

void make_random_change(ProjectFile& project, std::uint32_t seed) {
    Dice dice(seed);
    Record record = project.load();
    project.change("Change " + std::to_string(seed), [&] {
        if (!record.units.empty() && dice.one_in(5)) {
            project.remove(dice.of(record.units).id);
            return;
        }
        for (std::size_t steps = 1 + dice.below(6); steps > 0; --steps) any_step(project, dice, record);
        if (dice.one_in(6))
            project.insert(Decision{{}, dice.fresh("d"), "diagnostic", "accepted", dice.text(), "", 0.5, "Ada", ""});
        if (dice.one_in(6)) project.insert(ImportNote{{}, dice.id(record.sources), 4, "unparsed", dice.text(), ""});
    });
}

} // namespace planum::test
