// SPDX-License-Identifier: MIT
#include "strat/checks/relation_weights.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/text.hpp"

namespace planum::strat {

namespace {

using model::RelationKind;
using model::UnitKind;

// About one relation in a hundred and fifty is wrong in a record like Al-Khutm, fewer in most; this is what makes few
// doubts dearer than many cheap ones.
constexpr double kPrior = 5.0;
// No single observation decides: at most e³ = 20 to one.
constexpr double kMost = 3.0;
// The same mistake on both sheets happens, for the second is often filled in from the first.
constexpr double kBothWrong = 0.15;

constexpr int kAsExpected = 0;
constexpr int kUndecided = 1;
constexpr int kContrary = 2;
constexpr int kUnknown = -1;

double capped(double log_ratio) { return std::clamp(log_ratio, -kMost, kMost); }

std::uint64_t pair_key(UnitIndex a, UnitIndex b) { return (static_cast<std::uint64_t>(a) << 32U) | b; }

std::optional<double> number_value(std::string_view number) {
    const std::size_t first = number.find_first_of("0123456789");
    if (first == std::string_view::npos) return std::nullopt;
    const std::size_t last = number.find_first_not_of("0123456789", first);
    return text::parse_double(number.substr(first, last == std::string_view::npos ? last : last - first));
}

bool is_deposit(const model::StratigraphicUnit& unit) {
    return unit.kind == UnitKind::Deposit || unit.kind == UnitKind::Unknown;
}

double kind_log_ratio(RelationKind kind, bool between_deposits) {
    switch (kind) {
    case RelationKind::Fills: return 0.6;
    case RelationKind::Cuts: return 0.5;
    case RelationKind::Covers: return 0.0;
    case RelationKind::Abuts: return between_deposits ? -1.4 : -0.7;
    case RelationKind::Later: return -0.2;
    case RelationKind::BondsWith:
    case RelationKind::SameAs:
    case RelationKind::Borders:
    case RelationKind::Contemporary: return 0.0;
    }
    return 0.0;
}

} // namespace

double RelationWeights::Direction::log_ratio(int outcome) const {
    if (outcome == kUnknown || outcome == kUndecided) return 0.0;
    // Two right ones of either kind are assumed before anything is counted.
    const double agree = count[kAsExpected] + 2.0;
    const double contrary = count[kContrary] + 2.0;
    const double ratio = std::log(agree / contrary);
    return capped(outcome == kAsExpected ? ratio : -ratio);
}

double RelationWeights::Distance::log_ratio(double distance) const {
    if (!usable) return 0.0;
    std::size_t bin = 0;
    while (bin < bounds.size() && distance > bounds[bin]) ++bin;
    // A wrong relation is either between neighbours all the same (reversed) or a chance pair (mistyped).
    const double wrong = 0.5 * right[bin] + 0.5 * chance[bin];
    return capped(std::log(right[bin] / wrong));
}

RelationWeights::RelationWeights(const CheckContext& context)
    : c_(context), dates_(date_bounds(context)), phases_(context.record) {
    const auto& units = c_.record.units;
    numbers_.reserve(units.size());
    places_.reserve(units.size());
    for (UnitIndex u = 0; u < units.size(); ++u) {
        numbers_.push_back(number_value(units[u].number));
        double x = 0.0;
        double y = 0.0;
        double n = 0.0;
        for (const std::uint32_t i : c_.levels_of(u)) {
            const model::Level& level = c_.record.levels[i];
            if (!level.x || !level.y) continue;
            x += *level.x;
            y += *level.y;
            n += 1.0;
        }
        places_.push_back(n > 0.0 ? std::optional(std::array{x / n, y / n}) : std::nullopt);
    }
    for (const model::Source& source : c_.record.sources) {
        sources_.emplace(source.id, static_cast<std::uint32_t>(sources_.size()));
    }
    sides_.resize(sources_.size() + 1);
    for (const model::SurfaceEvidence& e : c_.surfaces) {
        if (!e.testable) continue;
        const UnitIndex upper = c_.index.find(e.upper);
        const UnitIndex lower = c_.index.find(e.lower);
        // A square metre either way is as good as proof.
        const double weight = capped(3.0 * (e.area - e.contrary_area));
        surfaces_[pair_key(upper, lower)] += weight;
        surfaces_[pair_key(lower, upper)] -= weight;
    }
    count();
}

void RelationWeights::count() {
    std::vector<RelationIndex> right;
    for (RelationIndex r = 0; r < c_.subject.size(); ++r) {
        if (!c_.states_order(r)) continue;
        const std::uint32_t component = c_.matrix.component_of(c_.matrix.node_of(c_.subject[r]));
        if (component == c_.matrix.component_of(c_.matrix.node_of(c_.object[r]))) continue;
        right.push_back(r);
        const auto kind = static_cast<std::size_t>(c_.record.relations[r].kind);
        const auto tally = [&](Direction& direction, int outcome) {
            if (outcome != kUnknown) direction.count[static_cast<std::size_t>(outcome)] += 1.0;
        };
        tally(digging_[kind], digging_outcome(r));
        tally(heights_[kind], height_outcome(r));
        tally(order_of_numbers_[kind], number_outcome(r));
        if (has_sheets(r)) {
            Sides& sides = sides_[source_of(r)];
            (c_.stated[r].both() ? sides.both : sides.one) += 1.0;
        }
    }
    count_distances(right);
}

void RelationWeights::count_distances(const std::vector<RelationIndex>& right) {
    const std::size_t units = c_.record.units.size();
    const auto learn = [&](Distance& d, auto&& distance_of) {
        std::vector<double> of_right;
        for (const RelationIndex r : right) {
            if (const auto x = distance_of(c_.subject[r], c_.object[r])) of_right.push_back(*x);
        }
        std::vector<double> of_chance;
        // Pairs drawn by a fixed stride, so that the same record always gives the same counts.
        for (std::size_t i = 0; i < std::min<std::size_t>(units, 4000); ++i) {
            const auto a = static_cast<UnitIndex>((i * 7919) % units);
            const auto b = static_cast<UnitIndex>((i * 104729 + 13) % units);
            if (a == b) continue;
            if (const auto x = distance_of(a, b)) of_chance.push_back(*x);
        }
        if (of_right.size() < 20 || of_chance.size() < 20) return;
        std::sort(of_right.begin(), of_right.end());
        const auto quantile = [&](double q) {
            return of_right[static_cast<std::size_t>(q * static_cast<double>(of_right.size() - 1))];
        };
        d.bounds = {quantile(0.5), quantile(0.9), quantile(0.99)};
        d.right = {0.5, 0.4, 0.09, 0.01};
        std::array<double, 4> hits = {1.0, 1.0, 1.0, 1.0};
        for (const double x : of_chance) {
            std::size_t bin = 0;
            while (bin < d.bounds.size() && x > d.bounds[bin]) ++bin;
            hits[bin] += 1.0;
        }
        for (std::size_t b = 0; b < hits.size(); ++b)
            d.chance[b] = hits[b] / (static_cast<double>(of_chance.size()) + 4.0);
        d.usable = true;
    };
    if (units < 2) return;
    learn(plan_, [&](UnitIndex a, UnitIndex b) { return plan_distance(a, b); });
    learn(number_, [&](UnitIndex a, UnitIndex b) { return number_distance(a, b); });
}

int RelationWeights::digging_outcome(RelationIndex relation) const {
    const std::string& upper = c_.unit(c_.subject[relation]).excavated_on;
    const std::string& lower = c_.unit(c_.object[relation]).excavated_on;
    if (upper.size() < 10 || lower.size() < 10) return kUnknown;
    const int order = upper.compare(0, 10, lower, 0, 10);
    if (order == 0) return kUndecided;
    return order < 0 ? kAsExpected : kContrary;
}

// The tops, or whatever was measured; "as expected" is learnt a kind at a time, so a cut may well be
// expected lower than what it cuts.
int RelationWeights::height_outcome(RelationIndex relation) const {
    const Heights& upper = c_.heights[c_.subject[relation]];
    const Heights& lower = c_.heights[c_.object[relation]];
    if (upper.contradictory || lower.contradictory) return kUnknown;
    const auto height = [](const Heights& h) { return h.highest_top ? h.highest_top : h.highest_base; };
    const auto u = height(upper);
    const auto v = height(lower);
    if (!u || !v) return kUnknown;
    if (std::abs(*u - *v) <= c_.record.settings.tolerance) return kUndecided;
    return *u > *v ? kAsExpected : kContrary;
}

int RelationWeights::number_outcome(RelationIndex relation) const {
    const auto& upper = numbers_[c_.subject[relation]];
    const auto& lower = numbers_[c_.object[relation]];
    if (!upper || !lower || *upper == *lower) return kUnknown;
    if (c_.unit(c_.subject[relation]).area != c_.unit(c_.object[relation]).area) return kUnknown;
    return *upper < *lower ? kAsExpected : kContrary;
}

std::optional<double> RelationWeights::plan_distance(UnitIndex a, UnitIndex b) const {
    if (!places_[a] || !places_[b]) return std::nullopt;
    return std::hypot((*places_[a])[0] - (*places_[b])[0], (*places_[a])[1] - (*places_[b])[1]);
}

std::optional<double> RelationWeights::number_distance(UnitIndex a, UnitIndex b) const {
    if (!numbers_[a] || !numbers_[b]) return std::nullopt;
    return std::abs(*numbers_[a] - *numbers_[b]);
}

bool RelationWeights::has_sheets(RelationIndex relation) const {
    const StatedSides& s = c_.stated[relation];
    return (s.subject > 0 || s.object > 0) && !c_.is_mentioned(c_.subject[relation]) &&
           !c_.is_mentioned(c_.object[relation]);
}

std::uint32_t RelationWeights::source_of(RelationIndex relation) const {
    const auto typed_in = static_cast<std::uint32_t>(sides_.size() - 1);
    const std::uint32_t first = c_.statement_begin[relation];
    if (first == c_.statement_begin[relation + 1]) return typed_in;
    const auto it = sources_.find(c_.record.statements[first].source);
    return it == sources_.end() ? typed_in : it->second;
}

void RelationWeights::gather_statements(RelationIndex relation, Gathered& g) const {
    if (!has_sheets(relation)) return;
    const Sides& sides = sides_[source_of(relation)];
    // Three of each are assumed before counting, so that a short record says little.
    const double both = (sides.both + 3.0) / (sides.both + sides.one + 6.0);
    if (c_.stated[relation].both()) {
        g.add(capped(-std::log(kBothWrong)), "both sheets state it");
    } else {
        g.add(capped(std::log((1.0 - both) / (1.0 - kBothWrong * both))),
              sides.both > sides.one ? "only one of the two sheets states it, where most relations stand on both"
                                     : "only one of the two sheets states it");
    }
}

void RelationWeights::gather_directions(RelationIndex relation, Gathered& g) const {
    const auto kind = static_cast<std::size_t>(c_.record.relations[relation].kind);
    const int digging = digging_outcome(relation);
    if (digging == kAsExpected) {
        g.add(digging_[kind].log_ratio(digging), "the upper unit was dug first");
    } else if (digging == kContrary) {
        g.add(digging_[kind].log_ratio(digging), "the lower unit was dug before the upper one");
    } else {
        // Numbers follow the digging, so they count only where its days do not tell.
        const int numbers = number_outcome(relation);
        const double ratio = order_of_numbers_[kind].log_ratio(numbers);
        g.add(ratio, ratio < 0.0 ? "numbers of this site grow downwards as a rule, here it is the other way round"
                                 : "the numbers follow each other as on the rest of the site");
    }
    const int height = height_outcome(relation);
    const double ratio = heights_[kind].log_ratio(height);
    g.add(ratio, ratio < 0.0 ? "the levels lie the other way round than between such units as a rule"
                             : "the levels lie as they should");
}

void RelationWeights::gather_distances(RelationIndex relation, Gathered& g) const {
    const UnitIndex u = c_.subject[relation];
    const UnitIndex v = c_.object[relation];
    if (const auto distance = plan_distance(u, v)) {
        const double ratio = plan_.log_ratio(*distance);
        g.add(ratio, ratio < 0.0 ? "the two units lie far apart in plan" : "the two units lie close together in plan");
        return;
    }
    if (const auto distance = number_distance(u, v)) {
        const double ratio = number_.log_ratio(*distance);
        g.add(ratio, ratio < 0.0 ? "the two numbers are further apart than those of units that touch as a rule"
                                 : "the two numbers are close together");
    }
}

void RelationWeights::gather_fixed(RelationIndex relation, Gathered& g) const {
    const UnitIndex u = c_.subject[relation];
    const UnitIndex v = c_.object[relation];
    const model::PhysicalRelation& stated = c_.record.relations[relation];
    const bool deposits = is_deposit(c_.unit(u)) && is_deposit(c_.unit(v));
    const double kind = kind_log_ratio(stated.kind, deposits);
    g.add(kind, kind > 0.0 ? "a cut or fill is hard to see the wrong way round"
                : deposits ? "which of two deposits leans on the other is easily mistaken"
                           : "leaning and age alone are weaker observations than covering");
    if (stated.certainty == model::Certainty::Uncertain) g.add(-1.5, "it is marked as uncertain");
    if (kinds_mismatch(c_, relation, model::Strictness::Strict)) {
        g.add(-2.5, "the kinds of the two units do not fit it");
    }
    const LevelJudgement levels = judge_by_levels(c_, relation);
    if (levels.verdict == LevelVerdict::Contradicted) {
        g.add(levels.near ? -2.5 : -2.0, "the levels of the two units exclude it");
    } else if (levels.verdict == LevelVerdict::Confirmed) {
        g.add(levels.near ? 1.5 : 1.0, "the levels of the two units confirm it");
    }
    if (dates_[u].to && dates_[v].from && *dates_[u].to < *dates_[v].from)
        g.add(-2.0, "the dates of the two units exclude it");
    if (dates_[v].to && dates_[u].from && *dates_[v].to <= *dates_[u].from)
        g.add(1.0, "the dates of the two units agree with it");
    if (phases_.has_any()) {
        const PhaseOrder order = phases_.compare(u, v).order;
        if (order == PhaseOrder::Earlier) g.add(-2.0, "the phases of the two units exclude it");
        if (order == PhaseOrder::Later) g.add(1.0, "the phases of the two units agree with it");
    }
    if (const auto it = surfaces_.find(pair_key(u, v)); it != surfaces_.end()) {
        g.add(it->second,
              it->second > 0.0 ? "the recorded surfaces show it" : "the recorded surfaces show the opposite");
    }
    if (const auto slip = reciprocal_slip(relation))
        g.add(slip->fit > 2.0 ? -2.5 : -1.2,
              "another sheet, one slip of the pen away, states what this one seems to mean");
}

RelationWeights::Gathered RelationWeights::gather(RelationIndex relation) const {
    Gathered g;
    gather_statements(relation, g);
    gather_directions(relation, g);
    gather_distances(relation, g);
    gather_fixed(relation, g);
    return g;
}

double RelationWeights::log_odds(RelationIndex relation) const {
    const Gathered g = gather(relation);
    double sum = kPrior;
    for (std::size_t i = 0; i < g.count; ++i) sum += g.items[i].log_ratio;
    return sum;
}

RelationWeight RelationWeights::explain(RelationIndex relation) const {
    Gathered g = gather(relation);
    RelationWeight weight;
    weight.log_odds = kPrior;
    std::stable_sort(
        g.items.begin(), g.items.begin() + static_cast<std::ptrdiff_t>(g.count),
        [](const Evidence& a, const Evidence& b) { return std::abs(a.log_ratio) > std::abs(b.log_ratio); });
    for (std::size_t i = 0; i < g.count; ++i) {
        weight.log_odds += g.items[i].log_ratio;
        // What changes the odds by less than a tenth is not worth a sentence.
        if (std::abs(g.items[i].log_ratio) < 0.1) continue;
        (g.items[i].log_ratio < 0.0 ? weight.against : weight.in_favour).emplace_back(g.items[i].what);
    }
    return weight;
}

RelationWeight RelationWeights::weigh_same_as(RelationIndex relation) const {
    const model::PhysicalRelation& stated = c_.record.relations[relation];
    RelationWeight weight;
    weight.log_odds = kPrior;
    const auto add = [&](double log_ratio, std::string_view what) {
        weight.log_odds += log_ratio;
        (log_ratio < 0.0 ? weight.against : weight.in_favour).emplace_back(what);
    };
    if (stated.correlation) add(-1.5, "it is a correlation across a gap, not one unit seen twice");
    if (stated.certainty == model::Certainty::Uncertain) add(-1.5, "it is marked as uncertain");
    if (c_.stated[relation].both()) add(1.0, "both sheets state it");
    const UnitIndex u = c_.subject[relation];
    const UnitIndex v = c_.object[relation];
    if (c_.unit(u).area != c_.unit(v).area) add(-0.7, "the two units lie in different areas");
    if (c_.unit(u).kind != c_.unit(v).kind && c_.unit(u).kind != UnitKind::Unknown &&
        c_.unit(v).kind != UnitKind::Unknown) {
        add(-1.5, "the two units are of different kinds");
    }
    const bool no_overlap = (dates_[u].to && dates_[v].from && *dates_[u].to < *dates_[v].from) ||
                            (dates_[v].to && dates_[u].from && *dates_[v].to < *dates_[u].from);
    if (no_overlap) add(-2.0, "the dates of the two units exclude each other");
    return weight;
}

} // namespace planum::strat
