// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "strat/checks/families.hpp"

namespace planum::strat {

namespace {

using model::Severity;
using model::Year;

std::string with_years(std::string name, const std::optional<Year>& from, const std::optional<Year>& to) {
    if (from && to) return fmt::format("{} ({} to {})", name, year_text(*from), year_text(*to));
    if (from) return fmt::format("{} (from {})", name, year_text(*from));
    if (to) return fmt::format("{} (until {})", name, year_text(*to));
    return name;
}

PhaseOrder by_rank(std::int64_t a, std::int64_t b) {
    if (a == b) return PhaseOrder::Same;
    return a < b ? PhaseOrder::Earlier : PhaseOrder::Later;
}

} // namespace

// What is known of one unit's phase, down from period to phase.
struct PhaseComparer::Span {
    const model::Phase* phase = nullptr;
    const model::Period* period = nullptr;

    [[nodiscard]] std::optional<Year> from() const {
        if (phase != nullptr && (phase->from || phase->to)) return phase->from;
        return period != nullptr ? period->from : std::nullopt;
    }

    [[nodiscard]] std::optional<Year> to() const {
        if (phase != nullptr && (phase->from || phase->to)) return phase->to;
        return period != nullptr ? period->to : std::nullopt;
    }

    [[nodiscard]] std::string name() const {
        std::string text;
        if (phase != nullptr) text = "phase " + phase->number;
        if (period != nullptr) text += (text.empty() ? "period " : " of period ") + period->number;
        return with_years(text, from(), to());
    }
};

// Whether `second` begins when `first` is over; ranges may share the year between them.
template<class Span>
bool follows(const Span& first, const Span& second) {
    if (!first.to() || !second.from() || *first.to() > *second.from()) return false;
    if (*first.to() < *second.from()) return true;
    return first.from() && *first.from() < *first.to() && second.to() && *second.from() < *second.to();
}

PhaseComparer::PhaseComparer(const model::Record& record) : record_(&record) {
    for (std::uint32_t i = 0; i < record.phases.size(); ++i) phases_.emplace(record.phases[i].id, i);
    for (std::uint32_t i = 0; i < record.periods.size(); ++i) periods_.emplace(record.periods[i].id, i);
    any_ = std::any_of(record.units.begin(), record.units.end(), [](const model::StratigraphicUnit& unit) {
        return !unit.phase.is_nil() || !unit.period.is_nil();
    });
}

PhaseComparer::Span PhaseComparer::span_of(UnitIndex u) const {
    Span span;
    const model::StratigraphicUnit& unit = record_->units[u];
    if (const auto it = phases_.find(unit.phase); it != phases_.end()) span.phase = &record_->phases[it->second];
    const model::PeriodId period =
        span.phase != nullptr && !span.phase->period.is_nil() ? span.phase->period : unit.period;
    if (const auto it = periods_.find(period); it != periods_.end()) span.period = &record_->periods[it->second];
    return span;
}

PhaseComparison PhaseComparer::compare(UnitIndex a, UnitIndex b) const {
    const Span sa = span_of(a);
    const Span sb = span_of(b);
    PhaseComparison result;
    if ((sa.phase == nullptr && sa.period == nullptr) || (sb.phase == nullptr && sb.period == nullptr)) return result;
    result.first = sa.name();
    result.second = sb.name();
    if (sa.phase == sb.phase && sa.period == sb.period) {
        result.order = PhaseOrder::Same;
        return result;
    }
    // Years first: numbers of phases restart in each period and run either way.
    if (follows(sa, sb)) {
        result.order = PhaseOrder::Earlier;
        result.by_years = true;
    } else if (follows(sb, sa)) {
        result.order = PhaseOrder::Later;
        result.by_years = true;
    } else if (sa.period != nullptr && sb.period != nullptr && sa.period != sb.period) {
        if (sa.period->rank && sb.period->rank) result.order = by_rank(*sa.period->rank, *sb.period->rank);
    } else if (sa.phase != nullptr && sb.phase != nullptr && sa.period == sb.period) {
        if (sa.phase->rank && sb.phase->rank) result.order = by_rank(*sa.phase->rank, *sb.phase->rank);
    }
    return result;
}

namespace {

class PhaseCheck {
  public:
    PhaseCheck(const CheckContext& context, Findings& findings)
        : c_(context), findings_(findings), phases_(context.record), dates_(date_bounds(context)) {}

    void run() {
        if (!phases_.has_any()) return;
        add_direct();
        add_across_one_unphased();
    }

  private:
    const CheckContext& c_;
    Findings& findings_;
    PhaseComparer phases_;
    std::vector<DateBounds> dates_;
    std::set<std::pair<UnitIndex, UnitIndex>> reported_;

    [[nodiscard]] bool has_phase(UnitIndex u) const {
        return !c_.unit(u).phase.is_nil() || !c_.unit(u).period.is_nil();
    }

    // The dates of the two units already say it: one mistake, one diagnostic.
    [[nodiscard]] bool said_by_dates(UnitIndex later, UnitIndex earlier) const {
        return dates_[later].to && dates_[earlier].from && *dates_[later].to < *dates_[earlier].from;
    }

    void add(UnitIndex later, UnitIndex earlier, const std::string& relation,
             std::vector<model::NamedRelation> relations) {
        const PhaseComparison comparison = phases_.compare(later, earlier);
        if (comparison.order != PhaseOrder::Earlier) return;
        if (said_by_dates(later, earlier) || !reported_.emplace(later, earlier).second) return;
        auto d = make_diagnostic(Severity::Error, "phase-contradiction",
                                 fmt::format("{}, but {} belongs to {} and {} to {}, which is later", relation,
                                             c_.name(later), comparison.first, c_.name(earlier), comparison.second));
        d.units = {c_.unit(later).id, c_.unit(earlier).id};
        d.evidence["by_years"] = static_cast<std::int64_t>(comparison.by_years ? 1 : 0);
        d.evidence["steps"] = static_cast<std::int64_t>(relations.size());
        d.relations = std::move(relations);
        findings_.push_back(std::move(d));
    }

    void add_direct() {
        for (RelationIndex r = 0; r < c_.subject.size(); ++r) {
            if (!c_.states_order(r) || c_.subject[r] == c_.object[r]) continue;
            if (!has_phase(c_.subject[r]) || !has_phase(c_.object[r])) continue;
            add(c_.subject[r], c_.object[r], c_.sentence(r), {c_.named(r)});
        }
    }

    // Phases are no numbers that could be carried with a maximum, but units without one pass the question
    // on: below each of them the nearest phased units are remembered (the first few by number, so that a
    // layer over a whole cemetery stays cheap).
    struct Below {
        UnitIndex origin = model::kNoUnit;
        std::uint32_t order = 0;
    };

    static constexpr std::size_t kRemembered = 4;
    std::vector<std::vector<Below>> below_;

    void add_across_one_unphased() {
        const HarrisMatrix& m = c_.matrix;
        below_.assign(m.node_count(), {});
        for (std::uint32_t component = static_cast<std::uint32_t>(m.component_count()); component-- > 0;) {
            const auto nodes = m.component(component);
            if (nodes.size() == 1) carry_into(nodes.front());
        }
    }

    void carry_into(NodeIndex node) {
        const HarrisMatrix& m = c_.matrix;
        UnitIndex phased = model::kNoUnit;
        for (const UnitIndex u : m.members(node)) {
            if (phased == model::kNoUnit && has_phase(u)) phased = u;
        }
        for (const std::uint32_t order : m.orders_below(node)) {
            const NodeIndex lower = m.orders()[order].earlier;
            for (const Below& b : below_[lower]) {
                if (phased == model::kNoUnit) {
                    remember(node, {b.origin, order});
                } else if (!is_phased(lower) && phases_.compare(phased, b.origin).order == PhaseOrder::Earlier) {
                    const auto path = path_down(order, b.origin);
                    add(phased, b.origin, path_text(c_, path, 6, {phased, b.origin}), path_relations(c_, path));
                }
            }
        }
        if (phased != model::kNoUnit) below_[node] = {{phased, 0}};
    }

    [[nodiscard]] bool is_phased(NodeIndex node) const {
        const auto members = c_.matrix.members(node);
        return std::any_of(members.begin(), members.end(), [&](UnitIndex u) { return has_phase(u); });
    }

    void remember(NodeIndex node, const Below& b) {
        auto& list = below_[node];
        if (list.size() == kRemembered) return;
        for (const Below& known : list) {
            if (known.origin == b.origin) return;
        }
        list.push_back(b);
    }

    [[nodiscard]] std::vector<std::uint32_t> path_down(std::uint32_t order, UnitIndex origin) const {
        std::vector<std::uint32_t> path{order};
        NodeIndex node = c_.matrix.orders()[order].earlier;
        while (node != c_.matrix.node_of(origin)) {
            const auto& list = below_[node];
            const auto it = std::find_if(list.begin(), list.end(), [&](const Below& b) { return b.origin == origin; });
            if (it == list.end()) break;
            path.push_back(it->order);
            node = c_.matrix.orders()[it->order].earlier;
        }
        return path;
    }
};

} // namespace

void check_phases(const CheckContext& context, Findings& findings) { PhaseCheck(context, findings).run(); }

} // namespace planum::strat
