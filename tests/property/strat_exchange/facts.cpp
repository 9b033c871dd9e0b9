// SPDX-License-Identifier: MIT
#include "tests/property/strat_exchange/facts.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>

namespace planum::test {

namespace {

using model::RelationKind;

void add(Facts& facts, std::string_view tag, std::string_view of, std::string_view value) {
    if (!value.empty()) facts.insert(fmt::format("{} {}: {}", tag, of, value));
}

template<class Number>
std::string text(const std::optional<Number>& value) {
    return value ? fmt::format("{}", *value) : "-";
}

void add_unit(Facts& facts, const std::string& name, const model::StratigraphicUnit& u) {
    facts.insert("unit " + name);
    if (u.kind != model::UnitKind::Unknown) add(facts, "kind", name, model::to_word(u.kind));
    if (u.kind == model::UnitKind::Deposit) add(facts, "deposit", name, "yes");
    if (u.kind == model::UnitKind::Interface) add(facts, "interface", name, "yes");
    if (u.kind == model::UnitKind::Natural) add(facts, "natural", name, "yes");
    add(facts, "form", name, model::to_word(u.form));
    add(facts, "status", name, model::to_word(u.status));
    add(facts, "title", name, u.title);
    add(facts, "description", name, u.description);
    add(facts, "field", name, u.interpretation);
    add(facts, "field", name, u.excavated_from + "/" + u.excavated_on + "/" + u.recorded_by + "/" + u.recorded_on);
    for (const auto& [key, value] : u.details) add(facts, "field", name, key + "=" + value);
}

void add_relation(Facts& facts, const std::string& a, RelationKind kind, const std::string& b,
                  model::Certainty certainty, bool correlation) {
    const bool swap = model::is_symmetric(kind) && b < a;
    const std::string pair = swap ? b + " > " + a : a + " > " + b;
    facts.insert(fmt::format("{} {}", model::to_word(kind), pair));
    facts.insert(fmt::format("exact {} {} {} {}", pair, model::to_word(kind), model::to_word(certainty), correlation));
    if (model::time_meaning(kind) == model::TimeMeaning::SubjectLater) {
        facts.insert("order " + pair);
        facts.insert((kind == RelationKind::Later ? "after " : "above ") + pair);
    }
    if (model::time_meaning(kind) == model::TimeMeaning::SameTime) facts.insert("sametime " + pair);
}

template<class Value>
std::string chronology(const Value& c) {
    return fmt::format("{}|{}|{}|{}|{}", c.title, c.description, text(c.from), text(c.to), text(c.rank));
}

std::string find_text(const model::Find& f) {
    return fmt::format("{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}", f.number, text(f.x), text(f.y), text(f.z), f.type,
                       f.material, text(f.count), text(f.weight), f.condition, f.box, f.found_on, f.description);
}

std::string sample_text(const model::Sample& s) {
    return fmt::format("{}|{}|{}|{}|{}|{}|{}", s.number, s.type, text(s.volume), text(s.weight), s.laboratory_number,
                       s.state, s.description);
}

std::string document_text(const model::Document& d) {
    return fmt::format("{}|{}|{}|{}|{}|{}", d.number, d.type, d.title, d.path, d.made_on, d.author);
}

std::string dating_text(const model::Dating& d) {
    return fmt::format("{}|{}|{}|{}|{}|{}|{}|{}", d.label, model::to_word(d.kind), text(d.from), text(d.to), text(d.bp),
                       text(d.bp_error), d.association, d.notes);
}

std::string level_text(const model::Level& l) {
    return fmt::format("{}|{}|{}|{}|{}", text(l.x), text(l.y), l.z, model::to_word(l.role), l.label);
}

std::string area_text(const model::Area& a) {
    return fmt::format("{}|{}|{}|{}|{}", a.name, a.title, model::to_word(a.method), a.first_number, a.last_number);
}

std::string group_text(const model::UnitGroup& g) {
    return fmt::format("{}|{}|{}|{}", g.number, g.type, g.title, g.description);
}

std::string text_of(const strat::UnitName& name) {
    return name.area.empty() ? name.number : name.area + "::" + name.number;
}

/// Names by id, written out the slow way.
struct Names {
    const model::Record& record;
    Naming naming;

    [[nodiscard]] std::string area(model::AreaId id) const {
        for (const auto& a : record.areas) {
            if (a.id == id) return a.name;
        }
        return {};
    }

    [[nodiscard]] std::string unit(model::UnitId id) const {
        for (const auto& u : record.units) {
            if (u.id != id) continue;
            const auto same = std::count_if(record.units.begin(), record.units.end(),
                                            [&](const auto& other) { return other.number == u.number; });
            const std::string of = area(u.area);
            return of.empty() || (naming == Naming::Short && same < 2) ? u.number : of + "::" + u.number;
        }
        return {};
    }

    [[nodiscard]] std::string period(model::PeriodId id) const {
        for (const auto& p : record.periods) {
            if (p.id == id) return p.number;
        }
        return {};
    }

    [[nodiscard]] std::string phase(model::PhaseId id) const {
        for (const auto& p : record.phases) {
            if (p.id != id) continue;
            const auto same = std::count_if(record.phases.begin(), record.phases.end(),
                                            [&](const auto& other) { return other.number == p.number; });
            const std::string of = period(p.period);
            return of.empty() || same < 2 ? p.number : of + "." + p.number;
        }
        return {};
    }

    [[nodiscard]] std::string group(model::GroupId id) const {
        for (const auto& g : record.groups) {
            if (g.id == id) return g.number;
        }
        return {};
    }
};

} // namespace

Facts facts_of(const model::Record& record, Naming naming) {
    Facts facts;
    const Names names{record, naming};
    add(facts, "project", "", record.settings.name);
    for (const auto& a : record.areas) add(facts, "area", "", area_text(a));
    for (const auto& u : record.units) {
        const std::string name = names.unit(u.id);
        facts.insert("anyunit " + name);
        add(facts, "anytitle", name, u.title);
        if (u.origin != model::UnitOrigin::Recorded) continue;
        add_unit(facts, name, u);
        add(facts, "inphase", name, names.phase(u.phase));
        add(facts, "inperiod", name, names.period(u.period));
        add(facts, "parent", name, names.unit(u.parent));
    }
    std::map<model::RelationId, const model::PhysicalRelation*> relations;
    for (const auto& r : record.relations) {
        relations[r.id] = &r;
        add_relation(facts, names.unit(r.subject), r.kind, names.unit(r.object), r.certainty, r.correlation);
    }
    for (const auto& s : record.statements) {
        const auto& r = *relations.at(s.relation);
        const std::string sheet = s.side == model::StatementSide::Neither
                                      ? "no sheet"
                                      : names.unit(s.side == model::StatementSide::Object ? r.object : r.subject);
        facts.insert(fmt::format("said {} {} {} by {}", model::to_word(r.kind),
                                 fmt::join(std::set{names.unit(r.subject), names.unit(r.object)}, ","), sheet,
                                 s.person));
    }
    for (const auto& p : record.periods) add(facts, "period", p.number, chronology(p));
    for (const auto& p : record.phases)
        add(facts, "phase", names.phase(p.id), chronology(p) + "|" + names.period(p.period));
    for (const auto& p : record.periods) add(facts, "periodtitle", p.number, p.title + "|" + p.description);
    for (const auto& p : record.phases) add(facts, "phasetitle", names.phase(p.id), p.title + "|" + p.description);
    for (const auto& p : record.phases) add(facts, "phaseperiod", names.phase(p.id), names.period(p.period));
    for (const auto& g : record.groups) {
        add(facts, "group", g.number, group_text(g));
        add(facts, "groupparent", g.number, names.group(g.parent));
        for (const auto& m : g.members) add(facts, "member", g.number, names.unit(m));
    }
    for (const auto& l : record.levels) add(facts, "level", names.unit(l.unit), level_text(l));
    for (const auto& f : record.finds) add(facts, "find", names.unit(f.unit), find_text(f));
    for (const auto& s : record.samples) add(facts, "sample", names.unit(s.unit), sample_text(s));
    for (const auto& d : record.documents) add(facts, "document", names.unit(d.unit), document_text(d));
    for (const auto& d : record.datings) {
        std::string find;
        for (const auto& f : record.finds) find = f.id == d.find ? f.number : find;
        add(facts, "dating", names.unit(d.unit), dating_text(d) + "|" + find);
    }
    return facts;
}

Facts facts_of(const strat::ImportedRecord& record) {
    Facts facts;
    add(facts, "project", "", record.project_name);
    for (const auto& a : record.areas) add(facts, "area", "", area_text(a));
    for (const auto& u : record.units) {
        const std::string name = text_of(u.name);
        facts.insert("anyunit " + name);
        add(facts, "anytitle", name, u.values.title);
        add_unit(facts, name, u.values);
        add(facts, "inphase", name, u.phase);
        add(facts, "inperiod", name, u.period);
        add(facts, "parent", name, text_of(u.parent));
    }
    for (const auto& r : record.relations) {
        const std::string a = text_of(r.subject);
        const std::string b = text_of(r.object);
        facts.insert("anyunit " + a);
        facts.insert("anyunit " + b);
        add_relation(facts, a, r.kind, b, r.certainty, r.correlation);
        const std::string sheet = r.side == model::StatementSide::Neither  ? "no sheet"
                                  : r.side == model::StatementSide::Object ? b
                                                                           : a;
        facts.insert(fmt::format("said {} {} {} by {}", model::to_word(r.kind), fmt::join(std::set{a, b}, ","), sheet,
                                 r.person));
    }
    for (const auto& p : record.periods) add(facts, "period", p.number, chronology(p));
    for (const auto& p : record.phases) add(facts, "phase", p.values.number, chronology(p.values) + "|" + p.period);
    for (const auto& p : record.periods) add(facts, "periodtitle", p.number, p.title + "|" + p.description);
    for (const auto& p : record.phases)
        add(facts, "phasetitle", p.values.number, p.values.title + "|" + p.values.description);
    for (const auto& p : record.phases) add(facts, "phaseperiod", p.values.number, p.period);
    for (const auto& g : record.groups) {
        add(facts, "group", g.values.number, group_text(g.values));
        add(facts, "groupparent", g.values.number, g.parent);
        for (const auto& m : g.members) add(facts, "member", g.values.number, text_of(m));
    }
    for (const auto& l : record.levels) add(facts, "level", text_of(l.unit), level_text(l.values));
    for (const auto& f : record.finds) add(facts, "find", text_of(f.unit), find_text(f.values));
    for (const auto& s : record.samples) add(facts, "sample", text_of(s.unit), sample_text(s.values));
    for (const auto& d : record.documents) add(facts, "document", text_of(d.unit), document_text(d.values));
    for (const auto& d : record.datings) add(facts, "dating", text_of(d.unit), dating_text(d.values) + "|" + d.find);
    return facts;
}

Facts only(const Facts& facts, const std::set<std::string, std::less<>>& tags) {
    Facts chosen;
    for (const std::string& fact : facts) {
        if (tags.contains(std::string_view{fact}.substr(0, fact.find(' ')))) chosen.insert(fact);
    }
    return chosen;
}

std::string difference(const Facts& a, const Facts& b) {
    std::string text;
    for (const std::string& fact : a) {
        if (!b.contains(fact)) text += "\nonly written: " + fact;
    }
    for (const std::string& fact : b) {
        if (!a.contains(fact)) text += "\nonly read:    " + fact;
    }
    return text;
}

} // namespace planum::test
