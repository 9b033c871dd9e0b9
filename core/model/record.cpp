// SPDX-License-Identifier: MIT
#include "core/model/record.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "core/base/text.hpp"
#include "core/model/words.hpp"

namespace planum::model {

namespace {

constexpr std::array kScopeWords = {
    std::pair{NumberScope::Site, std::string_view{"site"}},
    std::pair{NumberScope::Area, std::string_view{"area"}},
};

constexpr std::array kStrictnessWords = {
    std::pair{Strictness::Lenient, std::string_view{"lenient"}},
    std::pair{Strictness::Normal, std::string_view{"normal"}},
    std::pair{Strictness::Strict, std::string_view{"strict"}},
};

// Sorts by natural text first and id last, so that the order is total and independent of insertion.
template<class Values, class Text>
void sort_by_text(Values& values, Text text_of) {
    std::sort(values.begin(), values.end(), [&](const auto& a, const auto& b) {
        const auto order = text::natural_order(text_of(a), text_of(b));
        return order != 0 ? order < 0 : a.id < b.id;
    });
}

template<class Values, class Key>
void sort_by_key(Values& values, Key key_of) {
    std::sort(values.begin(), values.end(), [&](const auto& a, const auto& b) { return key_of(a) < key_of(b); });
}

void sort_units(Record& record) {
    std::unordered_map<AreaId, std::string_view> areas;
    for (const Area& area : record.areas) areas.emplace(area.id, area.name);
    const auto area_of = [&](const StratigraphicUnit& unit) {
        const auto it = areas.find(unit.area);
        return it == areas.end() ? std::string_view{} : it->second;
    };
    std::sort(record.units.begin(), record.units.end(), [&](const auto& a, const auto& b) {
        if (const auto order = text::natural_order(area_of(a), area_of(b)); order != 0) return order < 0;
        if (const auto order = text::natural_order(a.number, b.number); order != 0) return order < 0;
        return a.id < b.id;
    });
}

// Statements in the order of their relations. The place of each is looked up once: there are more statements
// than anything else, and looking up while comparing took a third of loading a large project.
void sort_statements(Record& record, const std::unordered_map<RelationId, std::uint32_t>& relation_place) {
    struct Placed {
        std::uint32_t relation;
        std::uint32_t from;
    };

    const std::vector<RelationStatement>& all = record.statements;
    std::vector<Placed> order;
    order.reserve(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto it = relation_place.find(all[i].relation);
        order.push_back({it == relation_place.end() ? kNoUnit : it->second, static_cast<std::uint32_t>(i)});
    }
    std::sort(order.begin(), order.end(), [&](const Placed& x, const Placed& y) {
        if (x.relation != y.relation) return x.relation < y.relation;
        const RelationStatement& a = all[x.from];
        const RelationStatement& b = all[y.from];
        return std::tie(a.source, a.line, a.side, a.id) < std::tie(b.source, b.line, b.side, b.id);
    });
    std::vector<RelationStatement> sorted;
    sorted.reserve(order.size());
    for (const Placed& placed : order) sorted.push_back(std::move(record.statements[placed.from]));
    record.statements = std::move(sorted);
}

// Relations by the places of their units, then statements in the order of their relations.
void sort_relations(Record& record, const std::unordered_map<UnitId, UnitIndex>& place) {
    const auto at = [&](UnitId id) {
        const auto it = place.find(id);
        return it == place.end() ? kNoUnit : it->second;
    };

    struct Keyed {
        std::tuple<UnitIndex, UnitIndex, RelationKind, RelationId> key;
        std::size_t from;
    };

    std::vector<Keyed> order;
    order.reserve(record.relations.size());
    for (std::size_t i = 0; i < record.relations.size(); ++i) {
        const PhysicalRelation& r = record.relations[i];
        order.push_back({{at(r.subject), at(r.object), r.kind, r.id}, i});
    }
    std::sort(order.begin(), order.end(), [](const Keyed& a, const Keyed& b) { return a.key < b.key; });
    std::vector<PhysicalRelation> sorted;
    sorted.reserve(order.size());
    std::unordered_map<RelationId, std::uint32_t> relation_place;
    relation_place.reserve(order.size());
    for (const Keyed& entry : order) {
        relation_place.emplace(record.relations[entry.from].id, static_cast<std::uint32_t>(sorted.size()));
        sorted.push_back(record.relations[entry.from]);
    }
    record.relations = std::move(sorted);
    sort_statements(record, relation_place);
}

} // namespace

RecordIndex::RecordIndex(const Record& record) : record_(&record) {
    by_id_.reserve(record.units.size());
    by_number_.reserve(record.units.size());
    for (std::size_t i = 0; i < record.units.size(); ++i) {
        by_id_.emplace(record.units[i].id, static_cast<UnitIndex>(i));
        by_number_[record.units[i].number].push_back(static_cast<UnitIndex>(i));
    }
    for (const Area& area : record.areas) area_names_.emplace(area.id, area.name);
}

UnitIndex RecordIndex::find(UnitId id) const noexcept {
    const auto it = by_id_.find(id);
    return it == by_id_.end() ? kNoUnit : it->second;
}

std::vector<UnitIndex> RecordIndex::named(std::string_view name) const {
    const std::string wanted{text::trim(name)};
    if (const auto it = by_number_.find(wanted); it != by_number_.end()) return it->second;
    std::vector<UnitIndex> hits;
    const std::size_t colons = wanted.find("::");
    if (colons == std::string::npos) return hits;
    const std::string area = wanted.substr(0, colons);
    const auto it = by_number_.find(wanted.substr(colons + 2));
    if (it == by_number_.end()) return hits;
    for (const UnitIndex unit : it->second) {
        const auto area_name = area_names_.find(record_->units[unit].area);
        if (area_name != area_names_.end() && area_name->second == area) hits.push_back(unit);
    }
    return hits;
}

std::string RecordIndex::name(UnitIndex unit) const {
    const StratigraphicUnit& u = record_->units.at(unit);
    const auto same_number = by_number_.find(u.number);
    const auto area = area_names_.find(u.area);
    if (same_number == by_number_.end() || same_number->second.size() < 2 || area == area_names_.end()) {
        return u.number;
    }
    return area->second + "::" + u.number;
}

std::string RecordIndex::name(UnitId id) const {
    const UnitIndex unit = find(id);
    return unit == kNoUnit ? std::string{"?"} : name(unit);
}

const ScanPose* pose_in_force(const Record& record, ScanId scan) noexcept {
    const ScanPose* best = nullptr;
    const RegistrationRun* best_run = nullptr;
    const auto is_later = [](const RegistrationRun& a, const RegistrationRun& b) {
        return a.made_at != b.made_at ? a.made_at > b.made_at : text::natural_order(a.name, b.name) > 0;
    };
    for (const ScanPose& pose : record.poses) {
        if (pose.scan != scan) continue;
        const auto run = std::find_if(record.runs.begin(), record.runs.end(),
                                      [&](const RegistrationRun& r) { return r.id == pose.run; });
        if (run == record.runs.end() || run->state != "accepted") continue;
        if (best_run != nullptr && !is_later(*run, *best_run)) continue;
        best = &pose;
        best_run = &*run;
    }
    return best;
}

void sort_record(Record& record) {
    sort_by_text(record.areas, [](const Area& a) -> std::string_view { return a.name; });
    sort_units(record);
    std::unordered_map<UnitId, UnitIndex> place;
    place.reserve(record.units.size());
    for (std::size_t i = 0; i < record.units.size(); ++i) {
        place.emplace(record.units[i].id, static_cast<UnitIndex>(i));
    }
    sort_relations(record, place);
    const auto at = [&](UnitId id) {
        const auto it = place.find(id);
        return it == place.end() ? kNoUnit : it->second;
    };
    sort_by_text(record.sources, [](const Source& s) -> std::string_view { return s.name; });
    sort_by_key(record.import_notes, [](const ImportNote& n) { return std::tie(n.source, n.line, n.raw_text, n.id); });
    sort_by_text(record.periods, [](const Period& p) -> std::string_view { return p.number; });
    sort_by_text(record.phases, [](const Phase& p) -> std::string_view { return p.number; });
    sort_by_text(record.groups, [](const UnitGroup& g) -> std::string_view { return g.number; });
    for (UnitGroup& group : record.groups) {
        std::sort(group.members.begin(), group.members.end(), [&](UnitId a, UnitId b) { return at(a) < at(b); });
    }
    sort_by_key(record.datings, [&](const Dating& d) { return std::make_tuple(at(d.unit), d.label, d.id); });
    sort_by_key(record.levels,
                [&](const Level& l) { return std::make_tuple(at(l.unit), l.role, l.z, l.x, l.y, l.id); });
    sort_by_text(record.finds, [](const Find& f) -> std::string_view { return f.number; });
    sort_by_text(record.samples, [](const Sample& s) -> std::string_view { return s.number; });
    sort_by_text(record.documents, [](const Document& d) -> std::string_view { return d.number; });
    sort_by_key(record.surfaces, [](const Surface& s) { return std::tie(s.order, s.first_day, s.name, s.id); });
    sort_by_text(record.sections, [](const Section& s) -> std::string_view { return s.name; });
    sort_by_key(record.regions,
                [&](const Region& r) { return std::make_tuple(r.surface, r.section, at(r.unit), r.part, r.id); });
    sort_by_text(record.scans, [](const Scan& s) -> std::string_view { return s.name; });
    sort_by_key(record.poses, [](const ScanPose& p) { return std::tie(p.scan, p.run); });
    sort_by_key(record.runs, [](const RegistrationRun& r) { return std::tie(r.made_at, r.name, r.id); });
    sort_by_key(record.decisions, [](const Decision& d) { return std::tie(d.made_at, d.subject_id, d.id); });
    sort_by_text(record.interpretations, [](const Interpretation& i) -> std::string_view { return i.name; });
}

std::string_view to_word(NumberScope scope) noexcept { return detail::word_of(kScopeWords, scope); }

std::string_view to_word(Strictness strictness) noexcept { return detail::word_of(kStrictnessWords, strictness); }

std::optional<NumberScope> number_scope_from_word(std::string_view word) noexcept {
    return detail::value_of(kScopeWords, word);
}

std::optional<Strictness> strictness_from_word(std::string_view word) noexcept {
    return detail::value_of(kStrictnessWords, word);
}

} // namespace planum::model
