// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include "app/demo/record_generator.hpp"
#include "app/demo/record_mistakes.hpp"
#include "strat/checks/check.hpp"

namespace planum::test {

/// How often the seeded mistake stood where among the suspects.
struct SuspectTally {
    int cases = 0;
    int first = 0;
    int among_three = 0;
    int cannot_tell = 0;

    void operator+=(const SuspectTally& other) {
        cases += other.cases;
        first += other.first;
        among_three += other.among_three;
        cannot_tell += other.cannot_tell;
    }

    [[nodiscard]] double share_first() const { return cases == 0 ? 1.0 : static_cast<double>(first) / cases; }

    [[nodiscard]] double share_three() const { return cases == 0 ? 1.0 : static_cast<double>(among_three) / cases; }
};

inline model::RelationId suspected_relation(const model::Suspect& suspect) {
    struct Visitor {
        model::RelationId operator()(const model::SuspectRelation& s) const { return s.relation.relation; }

        model::RelationId operator()(const model::SuspectSameAs& s) const { return s.same_as.relation; }

        model::RelationId operator()(const model::SuspectNumber& s) const { return s.relation.relation; }

        model::RelationId operator()(const model::SuspectUnit&) const { return {}; }
    };

    return std::visit(Visitor{}, suspect.what);
}

/// Checks the record and notes where the wrong relation stands among the suspects of its cycle group.
inline void tally(const app::GeneratedRecord& generated, const app::Mistake& mistake, SuspectTally& t) {
    const auto matrix = strat::HarrisMatrix::build(generated.record);
    const auto result = strat::check(generated.record, matrix, {}, {}, Progress::none());
    ++t.cases;
    int place = 0;
    for (const auto& d : result.diagnostics) {
        if (d.code != "cycle" && d.code != "cycle-by-same-as") continue;
        for (std::size_t i = 0; i < d.suspects.size() && place == 0; ++i) {
            if (suspected_relation(d.suspects[i]) == mistake.relation) place = static_cast<int>(i) + 1;
        }
        const auto it = d.evidence.find("cannot_tell");
        if (it != d.evidence.end() && std::get<std::int64_t>(it->second) == 1) ++t.cannot_tell;
    }
    if (place == 1) ++t.first;
    if (place >= 1 && place <= 3) ++t.among_three;
}

/// One mistake of one kind in each of `records` generated records; records in which none closes a cycle as
/// asked are left out.
inline SuspectTally measure_suspects(const app::RecordOptions& base, app::MistakeKind kind, std::size_t records,
                                     std::size_t least_cycle = 6) {
    SuspectTally t;
    for (std::size_t i = 0; i < records; ++i) {
        app::RecordOptions options = base;
        options.seed = 1000 * (static_cast<std::uint64_t>(kind) + 1) + i;
        app::GeneratedRecord generated = app::generate_record(options);
        app::MistakeOptions how;
        how.seed = options.seed + 17;
        how.least_cycle = least_cycle;
        const auto mistake = app::seed_mistake(generated, kind, how);
        if (mistake) tally(generated, *mistake, t);
    }
    return t;
}

} // namespace planum::test
