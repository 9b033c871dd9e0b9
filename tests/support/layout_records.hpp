// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "core/model/record.hpp"

namespace planum::test {

/// Builds small records for drawings by hand: `a_matrix().above("1", "2").kind("1", Cut).record()`.
class MatrixBuilder {
  public:
    MatrixBuilder& unit(const std::string& number) {
        find(number);
        return *this;
    }

    MatrixBuilder& relate(const std::string& a, model::RelationKind kind, const std::string& b,
                          model::Certainty certainty = model::Certainty::Certain) {
        model::PhysicalRelation relation;
        relation.id = {ids_.next()};
        relation.subject = record_.units[find(a)].id;
        relation.object = record_.units[find(b)].id;
        relation.kind = kind;
        relation.certainty = certainty;
        record_.relations.push_back(relation);
        return *this;
    }

    MatrixBuilder& above(const std::string& a, const std::string& b) {
        return relate(a, model::RelationKind::Covers, b);
    }

    MatrixBuilder& kind(const std::string& number, model::UnitKind kind) {
        record_.units[find(number)].kind = kind;
        return *this;
    }

    MatrixBuilder& phase(const std::string& number, const std::string& phase, std::int64_t rank) {
        auto it = std::find_if(record_.phases.begin(), record_.phases.end(),
                               [&](const model::Phase& p) { return p.number == phase; });
        if (it == record_.phases.end()) {
            model::Phase fresh;
            fresh.id = {ids_.next()};
            fresh.number = phase;
            fresh.rank = rank;
            it = record_.phases.insert(it, fresh);
        }
        record_.units[find(number)].phase = it->id;
        return *this;
    }

    MatrixBuilder& group(const std::string& number, const std::string& group) {
        auto it = std::find_if(record_.groups.begin(), record_.groups.end(),
                               [&](const model::UnitGroup& g) { return g.number == group; });
        if (it == record_.groups.end()) {
            model::UnitGroup fresh;
            fresh.id = {ids_.next()};
            fresh.number = group;
            it = record_.groups.insert(it, fresh);
        }
        it->members.push_back(record_.units[find(number)].id);
        return *this;
    }

    [[nodiscard]] model::UnitId id(const std::string& number) { return record_.units[find(number)].id; }

    [[nodiscard]] model::Record record() const {
        model::Record sorted = record_;
        model::sort_record(sorted);
        return sorted;
    }

    model::Record& raw() { return record_; }

  private:
    std::size_t find(const std::string& number) {
        for (std::size_t i = 0; i < record_.units.size(); ++i) {
            if (record_.units[i].number == number) return i;
        }
        model::StratigraphicUnit unit;
        unit.id = {ids_.next()};
        unit.number = number;
        record_.units.push_back(unit);
        return record_.units.size() - 1;
    }

    SeededUuids ids_{1};
    model::Record record_;
};

inline MatrixBuilder a_matrix() { return {}; }

struct TrenchOptions {
    std::size_t units = 100;
    std::uint32_t seed = 1;
    std::size_t width = 24;      ///< columns of ground; more of them: broader matrices
    std::size_t layer_reach = 5; ///< columns that a layer covers, at most
};

/// A record as a trench would give it: layers laid over stretches of ground, pits cut and filled, walls
/// built. Relations are stated between what touches, so some are redundant. Unit 1 is the latest.
inline model::Record a_trench(const TrenchOptions& options) {
    using model::UnitKind;

    struct Laid {
        UnitKind kind;
        std::vector<std::pair<std::size_t, model::RelationKind>> below;
    };

    std::mt19937 random(options.seed);
    const auto pick = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
    std::vector<Laid> laid = {{UnitKind::Natural, {}}};
    std::vector<std::vector<std::size_t>> ground(options.width, {0}); // per column, what lies there, top last
    const auto lay = [&](UnitKind kind, model::RelationKind relation, std::size_t from, std::size_t to) {
        Laid unit{kind, {}};
        for (std::size_t c = from; c < to; ++c) {
            const std::size_t under = ground[c].back();
            const auto known = [&](const auto& r) { return r.first == under; };
            if (std::none_of(unit.below.begin(), unit.below.end(), known)) unit.below.emplace_back(under, relation);
            ground[c].push_back(laid.size());
        }
        laid.push_back(std::move(unit));
    };
    while (laid.size() < options.units) {
        const std::size_t from = pick(options.width);
        const std::size_t to = std::min(options.width, from + 1 + pick(options.layer_reach));
        const std::size_t what = pick(10);
        if (what < 6) {
            lay(UnitKind::Deposit, model::RelationKind::Covers, from, to);
        } else if (what < 9) { // a pit: takes some layers away, then gets a fill or two
            for (std::size_t c = from; c < std::min(to, from + 2); ++c) {
                for (std::size_t depth = pick(3); depth > 0 && ground[c].size() > 1; --depth) ground[c].pop_back();
            }
            lay(UnitKind::Cut, model::RelationKind::Cuts, from, std::min(to, from + 2));
            lay(UnitKind::Deposit, model::RelationKind::Fills, from, std::min(to, from + 2));
        } else {
            lay(UnitKind::Structure, model::RelationKind::Covers, from, std::min(to, from + 2));
        }
    }
    MatrixBuilder builder;
    const auto number = [&](std::size_t i) { return std::to_string(laid.size() - i); };
    for (std::size_t i = laid.size(); i-- > 0;) builder.kind(number(i), laid[i].kind);
    for (std::size_t i = laid.size(); i-- > 0;) {
        for (const auto& [under, kind] : laid[i].below) builder.relate(number(i), kind, number(under));
    }
    builder.raw().settings.name = "Generated trench";
    return builder.record();
}

struct RandomMatrixOptions {
    std::size_t units = 12;
    std::size_t relations = 20;
    std::uint32_t seed = 1;
    bool cycles = false; ///< relations in both directions
    bool contemporaries = false;
    bool same_as = false;
    bool uncertain = false;
    std::size_t phases = 0; ///< given to units at random, whatever the relations say
    std::size_t groups = 0; ///< likewise
};

/// Any relations between any units: nothing a trench would give, everything a drawing must survive.
inline model::Record a_random_record(const RandomMatrixOptions& options) {
    std::mt19937 random(options.seed);
    const auto pick = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
    MatrixBuilder builder;
    for (std::size_t u = 1; u <= options.units; ++u) builder.unit(std::to_string(u));
    const auto name = [](std::size_t u) { return std::to_string(u + 1); };
    for (std::size_t r = 0; r < options.relations; ++r) {
        std::size_t a = pick(options.units);
        std::size_t b = pick(options.units);
        if (a == b) continue;
        const std::size_t what = pick(12);
        if (what == 0 && options.contemporaries) {
            builder.relate(name(a), model::RelationKind::Contemporary, name(b));
            continue;
        }
        if (what == 1 && options.same_as) {
            builder.relate(name(a), model::RelationKind::SameAs, name(b));
            continue;
        }
        if (a > b && !(options.cycles && pick(6) == 0)) std::swap(a, b);
        const bool uncertain = options.uncertain && pick(4) == 0;
        builder.relate(name(a), model::RelationKind::Covers, name(b),
                       uncertain ? model::Certainty::Uncertain : model::Certainty::Certain);
    }
    for (std::size_t u = 0; u < options.units && options.phases > 0; ++u) {
        const std::size_t phase = pick(options.phases + 1);
        if (phase > 0) builder.phase(name(u), "P" + std::to_string(phase), static_cast<std::int64_t>(phase));
    }
    for (std::size_t u = 0; u < options.units && options.groups > 0; ++u) {
        const std::size_t group = pick(2 * options.groups);
        if (group < options.groups) builder.group(name(u), "Group " + std::to_string(group + 1));
    }
    return builder.record();
}

struct DenseOptions {
    std::size_t units = 1000;
    std::size_t orders_each = 3; ///< about as many reduced orders a unit
    std::uint32_t seed = 1;
    std::size_t depth = 60; ///< levels
    std::size_t reach = 6;  ///< how far aside an order goes on its level
};

/// Units on levels, each above some near ones one level down and now and then further: few of the orders are
/// redundant, so this is as dense as matrices get.
inline model::Record a_dense_record(const DenseOptions& options) {
    std::mt19937 random(options.seed);
    const auto pick = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
    SeededUuids ids(options.seed);
    model::Record record;
    record.settings.name = "Dense matrix";
    const std::size_t width = std::max<std::size_t>(1, options.units / options.depth);
    for (std::size_t u = 0; u < options.units; ++u) {
        model::StratigraphicUnit unit;
        unit.id = {ids.next()};
        unit.number = std::to_string(u + 1);
        unit.kind = model::UnitKind::Deposit;
        record.units.push_back(unit);
    }
    for (std::size_t u = 0; u < options.units; ++u) {
        std::vector<std::size_t> below;
        for (std::size_t k = 0; k < options.orders_each; ++k) {
            const std::size_t down = pick(8) == 0 ? 2 + pick(3) : 1;
            const std::size_t aside = pick(2 * options.reach + 1);
            const std::size_t column =
                std::min(width - 1, (u % width) + aside - std::min(u % width + aside, options.reach));
            const std::size_t other = (u / width + down) * width + column;
            if (other >= options.units || std::find(below.begin(), below.end(), other) != below.end()) continue;
            below.push_back(other);
            model::PhysicalRelation relation;
            relation.id = {ids.next()};
            relation.subject = record.units[u].id;
            relation.object = record.units[other].id;
            record.relations.push_back(relation);
        }
    }
    model::sort_record(record);
    return record;
}

} // namespace planum::test
