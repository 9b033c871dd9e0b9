// SPDX-License-Identifier: MIT
#include "app/checks/interpretation_diff.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <tuple>

#include "app/checks/daily_check.hpp"
#include "app/evidence/section_evidence.hpp"
#include "core/base/text.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::app {

namespace {

using strat::HarrisMatrix;

// One reading with its matrix. Units are the same in both, in the same order.
struct Read {
    model::Record record;
    HarrisMatrix matrix;

    explicit Read(model::Record of) : record(std::move(of)), matrix(HarrisMatrix::build(record)) {}

    [[nodiscard]] bool is_later(model::UnitIndex later, model::UnitIndex earlier) const {
        return matrix.is_later(matrix.node_of(later), matrix.node_of(earlier));
    }
};

model::Record reading_named(const model::Record& record, const std::string& name) {
    const bool taken = std::any_of(record.interpretations.begin(), record.interpretations.end(),
                                   [&](const model::Interpretation& i) { return i.name == name; });
    return interpreted(record, name == "record" && !taken ? std::string{} : name);
}

bool has(const model::Record& record, const model::PhysicalRelation& wanted) {
    return std::any_of(record.relations.begin(), record.relations.end(), [&](const model::PhysicalRelation& r) {
        return r.subject == wanted.subject && r.kind == wanted.kind && r.object == wanted.object;
    });
}

void add_relations(const Read& from, const Read& other, Reading in, InterpretationDiff& diff) {
    const model::RecordIndex index(from.record);
    for (const model::PhysicalRelation& relation : from.record.relations) {
        if (has(other.record, relation)) continue;
        const bool orders = time_meaning(relation.kind) == model::TimeMeaning::SubjectLater;
        diff.relations.push_back({in, index.name(relation.subject), relation.kind, index.name(relation.object),
                                  orders && other.is_later(index.find(relation.object), index.find(relation.subject))});
    }
}

void add_orders(const Read& from, const Read& other, Reading in, InterpretationDiff& diff) {
    const model::RecordIndex index(from.record);
    for (const std::uint32_t at : from.matrix.reduced()) {
        const strat::Order& order = from.matrix.orders()[at];
        const model::UnitIndex later = from.matrix.members(order.later).front();
        const model::UnitIndex earlier = from.matrix.members(order.earlier).front();
        if (other.is_later(later, earlier)) continue;
        const bool reversed = other.is_later(earlier, later);
        const bool told = std::any_of(diff.orders.begin(), diff.orders.end(), [&](const DifferingOrder& o) {
            return o.reversed && o.later == index.name(earlier) && o.earlier == index.name(later);
        });
        if (told) continue; // from the first reading's side
        diff.orders.push_back({in, index.name(later), index.name(earlier), reversed});
    }
}

void add_problems(const DailyCheck& from, const DailyCheck& other, Reading in, InterpretationDiff& diff) {
    std::set<std::string> known;
    for (const auto* list : {&other.problems, &other.accepted}) {
        for (const model::Diagnostic& problem : *list) known.insert(problem.id);
    }
    for (const model::Diagnostic& problem : from.problems) {
        if (problem.severity == model::Severity::Info || known.contains(problem.id)) continue;
        diff.problems.push_back({in, problem});
    }
}

template<class T, class Names>
void sort_naturally(std::vector<T>& values, Names names) {
    std::stable_sort(values.begin(), values.end(), [&](const T& a, const T& b) {
        const auto [a1, a2] = names(a);
        const auto [b1, b2] = names(b);
        if (const auto first = text::natural_order(a1, b1); first != 0) return first < 0;
        return text::natural_order(a2, b2) < 0;
    });
}

} // namespace

InterpretationDiff diff_interpretations(Project& project, const std::string& first, const std::string& second,
                                        Progress& progress) {
    const Read a(reading_named(project.record(), first));
    const Read b(reading_named(project.record(), second));
    InterpretationDiff diff;
    add_relations(a, b, Reading::First, diff);
    add_relations(b, a, Reading::Second, diff);
    add_orders(a, b, Reading::First, diff);
    add_orders(b, a, Reading::Second, diff);
    sort_naturally(diff.relations, [](const auto& r) { return std::tie(r.unit, r.other); });
    sort_naturally(diff.orders, [](const auto& o) { return std::tie(o.later, o.earlier); });
    const model::Measurements measured = measured_evidence(project, progress);
    const DailyCheck check_a = check_record(a.record, measured, progress);
    const DailyCheck check_b = check_record(b.record, measured, progress);
    add_problems(check_a, check_b, Reading::First, diff);
    add_problems(check_b, check_a, Reading::Second, diff);
    return diff;
}

} // namespace planum::app
