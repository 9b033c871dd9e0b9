// SPDX-License-Identifier: MIT
#include "scans/surface/conclusions.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace planum::scans {

namespace {

using model::RelationKind;
using model::UnitForm;
using model::UnitKind;
using Pair = std::pair<UnitNumber, UnitNumber>;

constexpr double kLeastAsked = 0.008;     // less is not even asked of [m²]
constexpr double kLeastClearArea = 0.004; // of those away from outlines [m²]
constexpr double kWorthAsking = 0.1;      // [m²]
constexpr double kInside = 0.9;           // share of what touches a unit, from which on it lies inside
constexpr double kMostOfIt = 0.6;         // of a line or of cells
constexpr double kAllOfIt = 0.8;
constexpr double kPartReplaced = 0.2;   // below, it may be something seen too late
constexpr double kMostOfReplaced = 0.4; // below, something thin may have lain between

double share(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }

// What a unit is to the rules. Where the kind is not known, the careful reading holds.
struct Nature {
    const KnownUnit* unit;

    [[nodiscard]] bool is_cut() const { return unit->kind == UnitKind::Cut; }

    [[nodiscard]] bool is_feature() const { return unit->kind == UnitKind::Feature; }

    [[nodiscard]] bool is_structure() const {
        return unit->kind == UnitKind::Structure || unit->form == UnitForm::Masonry || unit->form == UnitForm::Timber;
    }

    [[nodiscard]] bool is_natural() const { return unit->kind == UnitKind::Natural; }

    [[nodiscard]] bool is_layer() const { return unit->kind == UnitKind::Deposit && unit->form == UnitForm::Layer; }

    [[nodiscard]] bool is_fill() const { return unit->kind == UnitKind::Deposit && unit->form == UnitForm::Fill; }

    /// Nobody said yet what it is.
    [[nodiscard]] bool is_unknown() const { return unit->kind == UnitKind::Unknown; }

    /// What stands or lies in a cut.
    [[nodiscard]] bool fills_cuts() const { return is_fill() || is_structure() || unit->kind == UnitKind::Skeleton; }
};

const Showing* showing_of(const SurfaceSummary& summary, UnitNumber unit) {
    const auto at = std::lower_bound(summary.showings.begin(), summary.showings.end(), unit,
                                     [](const Showing& s, UnitNumber u) { return s.unit < u; });
    return at != summary.showings.end() && at->unit == unit ? &*at : nullptr;
}

double edge_length(const SurfaceSummary& summary, UnitNumber u, UnitNumber v) {
    const Pair pair{std::min(u, v), std::max(u, v)};
    for (const SharedEdge& edge : summary.edges) {
        if (edge.a == pair.first && edge.b == pair.second) return edge.length;
    }
    return 0.0;
}

// The share of `inner`'s outline against units that it has in common with `outer`.
double inside_share(const SurfaceSummary& summary, UnitNumber inner, UnitNumber outer) {
    const Showing* showing = showing_of(summary, inner);
    if (showing == nullptr) return 0.0;
    return share(edge_length(summary, inner, outer), showing->perimeter - showing->open_edge);
}

// One step between two surfaces, with what the rules ask of it.
class Step {
  public:
    Step(const AreaHistory& history, std::size_t from, std::span<const KnownUnit> units)
        : history_(history), from_(from), units_(units), step_(history.steps[from]), area_(step_.cell * step_.cell) {}

    [[nodiscard]] std::vector<Conclusion> conclude() const {
        std::vector<Conclusion> conclusions;
        for (const Succession& s : step_.successions) {
            const double all = static_cast<double>(s.cells) * area_;
            if (s.first == s.then || all < kLeastAsked) continue;
            if (all < kLeastProposed || static_cast<double>(s.lower + s.thin) * area_ < kLeastClearArea) {
                if (may_ask_of_edges(s)) conclusions.push_back(ask(s, Ground::OnlyAlongOutlines));
                continue;
            }
            if (auto c = by_levels(s) ? from_levels(s) : from_surfaces(s)) conclusions.push_back(*c);
        }
        return conclusions;
    }

  private:
    [[nodiscard]] Nature nature(UnitNumber u) const { return {&units_[static_cast<std::size_t>(u)]}; }

    [[nodiscard]] const SurfaceSummary& upper() const { return history_.summaries[from_]; }

    [[nodiscard]] const SurfaceSummary& lower() const { return history_.summaries[from_ + 1]; }

    [[nodiscard]] bool by_levels(const Succession& s) const {
        return history_.methods[from_ + 1] != model::DigMethod::Stratigraphic &&
               (s.cut_first + s.cut_then == 0 || s.level * 2 > s.lower);
    }

    [[nodiscard]] Conclusion begin(const Succession& s, Ground ground, RelationKind kind) const {
        Conclusion c;
        c.unit = s.first;
        c.other = s.then;
        c.kind = kind;
        c.ground = ground;
        const std::int64_t told = s.lower > 0 ? s.lower : s.thin;
        c.area = static_cast<double>(told) * area_;
        c.thin = s.lower == 0;
        c.thickness = s.drop;
        c.tolerance = s.tolerance;
        c.from = from_;
        c.to = from_ + 1;
        c.source = history_.methods[from_ + 1] == model::DigMethod::Stratigraphic
                       ? model::EvidenceSource::StratigraphicSurfaces
                       : model::EvidenceSource::Levels;
        return c;
    }

    [[nodiscard]] Conclusion ask(const Succession& s, Ground ground) const {
        Conclusion c = begin(s, ground, RelationKind::Later);
        c.is_question = true;
        c.area = static_cast<double>(s.cells) * area_;
        return c;
    }

    // The most that was bare of a cut on any surface so far, in cells.
    [[nodiscard]] std::int64_t bare_before(UnitNumber cut) const {
        std::int64_t most = 0;
        for (std::size_t i = 0; i <= from_; ++i) {
            const Showing* showing = showing_of(history_.summaries[i], cut);
            if (showing != nullptr) most = std::max(most, showing->cut_cells);
        }
        return most;
    }

    // Cells of `first` that became something else, and of these those that became `then` or what lies in it.
    [[nodiscard]] double share_into(UnitNumber first, UnitNumber cut) const {
        std::int64_t all = 0;
        std::int64_t into = 0;
        for (const Succession& s : step_.successions) {
            if (s.first != first || s.then == first) continue;
            all += s.cells;
            const bool new_fill = nature(s.then).fills_cuts() && showing_of(upper(), s.then) == nullptr;
            if (s.then == cut || new_fill) into += s.cells;
        }
        return share(static_cast<double>(into), static_cast<double>(all));
    }

    // What is left in a half-emptied hollow lies lower than all else around it; a roof does not.
    [[nodiscard]] bool lies_in_hollow(UnitNumber unit, UnitNumber cut) const {
        constexpr double kBelowRim = 0.1; // [m]
        const Showing* own = showing_of(upper(), unit);
        const Showing* hollow = showing_of(upper(), cut);
        if (own == nullptr || hollow == nullptr || edge_length(upper(), unit, cut) < 0.3 * own->perimeter) return false;
        bool has_rim = false;
        for (const SharedEdge& edge : upper().edges) {
            if ((edge.a != cut && edge.b != cut) || edge.length < 0.1 * hollow->perimeter) continue;
            const UnitNumber other = edge.a == cut ? edge.b : edge.a;
            if (other == unit || nature(other).fills_cuts()) continue;
            has_rim = true;
            if (own->height > showing_of(upper(), other)->height - kBelowRim) return false;
        }
        return has_rim;
    }

    [[nodiscard]] bool other_fill_left(UnitNumber layer, UnitNumber cut) const {
        return std::any_of(step_.successions.begin(), step_.successions.end(), [&](const Succession& s) {
            return s.then == cut && s.first != layer && nature(s.first).fills_cuts() &&
                   static_cast<double>(s.cells) * area_ >= kLeastProposed;
        });
    }

    // u, then an emptied cut below it: order only for what lay in the hollow. The roof over an undercut pit is
    // older than the pit, and in plan looks the same.
    // A layer that sealed a hollow without fill: nothing of the hollow was to be seen, and the layer is gone all
    // around. Where some of it is left the pit may have been overlooked; on levels it may always.
    [[nodiscard]] bool may_be_sealed(const Succession& s, std::int64_t bare_before) const {
        return nature(s.first).is_layer() && bare_before == 0 && !other_fill_left(s.first, s.then) &&
               history_.methods[from_ + 1] == model::DigMethod::Stratigraphic &&
               edge_length(lower(), s.first, s.then) == 0.0;
    }

    [[nodiscard]] std::optional<Conclusion> onto_cut(const Succession& s) const {
        const std::int64_t before = bare_before(s.then);
        const Nature first = nature(s.first);
        if (first.fills_cuts()) {
            const double into = share_into(s.first, s.then);
            const bool inside = inside_share(upper(), s.first, s.then) >= kInside || lies_in_hollow(s.first, s.then);
            const bool fresh = before == 0 && into >= kMostOfIt;
            const bool mostly_fresh = 2 * before <= s.cells && into >= kAllOfIt;
            if (inside || fresh || mostly_fresh) {
                Conclusion c = begin(s, Ground::EmptiedCut, RelationKind::Fills);
                c.direct = true;
                return c;
            }
        } else if (may_be_sealed(s, before)) {
            Conclusion c = begin(s, Ground::EmptiedCut, RelationKind::Covers);
            c.direct = true;
            return c;
        }
        if (first.is_unknown() && lay_in_cut(s, before)) return begin(s, Ground::EmptiedCut, RelationKind::Later);
        if (static_cast<double>(s.cells) * area_ < kWorthAsking) return std::nullopt;
        return ask(s, Ground::RoofOfHollow);
    }

    // Whatever it is: nearly all of it that went came off the cut, of which nothing was bare before. A roof goes on
    // beside the mouth of its hollow, and that was emptied first.
    [[nodiscard]] bool lay_in_cut(const Succession& s, std::int64_t bare_before) const {
        return bare_before == 0 && share_into(s.first, s.then) >= kAllOfIt;
    }

    [[nodiscard]] std::optional<Conclusion> below_cut(const Succession& s) const {
        const bool touched = edge_length(upper(), s.first, s.then) >= 0.1;
        Conclusion c = begin(s, Ground::BelowBareCut, touched ? RelationKind::Cuts : RelationKind::Later);
        c.direct = touched;
        return c;
    }

    // Narrow strips nowhere get clear of the outlines. Whether a strip is a roof is worth a question only when
    // it is large.
    [[nodiscard]] bool may_ask_of_edges(const Succession& s) const {
        if (by_levels(s) && !nature(s.first).is_cut() && !nature(s.then).is_cut()) return false;
        if (!nature(s.then).is_cut()) return true;
        return static_cast<double>(s.cells) * area_ >= kWorthAsking ||
               (nature(s.first).fills_cuts() && bare_before(s.then) == 0);
    }

    // Was something between the two that no surface shows?
    [[nodiscard]] bool hides(const Succession& s) const {
        constexpr double kTooWideToDoubt = 3.0; // of so much contact a hidden unit takes only a part [m²]
        if (static_cast<double>(s.cells) * area_ > kTooWideToDoubt) return false;
        return s.hidden > 0 || (from_ < history_.hides_somewhere.size() && history_.hides_somewhere[from_]);
    }

    // A fill over something that is neither in the same hollow nor its cut has its cut between.
    [[nodiscard]] bool cut_between(const Succession& s) const {
        return nature(s.first).fills_cuts() && !(nature(s.then).fills_cuts() && in_one_hollow(s.first, s.then));
    }

    // Both were followed by the same emptied cut somewhere.
    [[nodiscard]] bool in_one_hollow(UnitNumber u, UnitNumber v) const {
        std::map<UnitNumber, int> cuts;
        for (const SurfaceStep& step : history_.steps) {
            for (const Succession& s : step.successions) {
                if (s.first == u && s.then != v && nature(s.then).is_cut() && s.cells >= 12) cuts[s.then] |= 1;
                if (s.first == v && nature(s.then).is_cut() && s.cells >= 12) cuts[s.then] |= 2;
            }
        }
        return std::any_of(cuts.begin(), cuts.end(), [](const auto& cut) { return cut.second == 3; });
    }

    [[nodiscard]] std::optional<Conclusion> from_surfaces(const Succession& s) const {
        if (s.cut_then > 0 || nature(s.then).is_cut()) return onto_cut(s);
        if (s.cut_first > 0 || nature(s.first).is_cut()) return below_cut(s);
        const bool told = s.lower > 0;
        Conclusion c = begin(s, told ? Ground::LayBareBelow : Ground::ThinUnit, RelationKind::Covers);
        c.direct = told && s.overdug * 2 < s.lower && !cut_between(s) && !hides(s);
        if (nature(s.first).is_feature()) {
            c.kind = RelationKind::Cuts;
        } else if (!c.direct) {
            c.kind = RelationKind::Later;
        }
        return c;
    }

    [[nodiscard]] double flat_share_into(UnitNumber unit, UnitNumber other) const {
        for (const EdgeMigration& edge : step_.edges) {
            if (edge.a != std::min(unit, other) || edge.b != std::max(unit, other)) continue;
            if (edge.followed < 0.2) return 0.0;
            return share(unit == edge.a ? edge.into_a : edge.into_b, edge.followed);
        }
        return 0.0;
    }

    [[nodiscard]] double left_of(UnitNumber unit) const {
        const Showing* before = showing_of(upper(), unit);
        const Showing* after = showing_of(lower(), unit);
        if (before == nullptr || after == nullptr) return 0.0;
        return share(static_cast<double>(after->cells), static_cast<double>(before->cells));
    }

    [[nodiscard]] double share_of_succession(const Succession& s) const {
        const Showing* before = showing_of(upper(), s.first);
        return before == nullptr ? 0.0 : share(static_cast<double>(s.cells), static_cast<double>(before->cells));
    }

    [[nodiscard]] std::optional<Conclusion> from_levels(const Succession& s) const {
        if (nature(s.first).is_structure() || nature(s.then).is_structure()) return ask(s, Ground::StructureStands);
        if (s.lower == 0) return std::nullopt;
        if (s.cut_then > 0 || nature(s.then).is_cut()) return onto_cut(s);
        if (s.cut_first > 0 || nature(s.first).is_cut()) return below_cut(s);
        const Nature first = nature(s.first);
        const Nature then = nature(s.then);
        if (then.is_natural()) {
            const bool layer = first.is_layer() && share_of_succession(s) >= kMostOfReplaced;
            Conclusion c = begin(s, Ground::AboveNatural, layer ? RelationKind::Covers : RelationKind::Later);
            c.direct = layer;
            return c;
        }
        return between_deposits(s, first, then);
    }

    [[nodiscard]] std::optional<Conclusion> between_deposits(const Succession& s, const Nature& first,
                                                             const Nature& then) const {
        const bool was_there = showing_of(upper(), s.then) != nullptr && edge_length(upper(), s.first, s.then) > 0.0;
        const bool flat = flat_share_into(s.first, s.then) >= kMostOfIt;
        const bool first_inside = inside_share(upper(), s.first, s.then) >= kInside;
        const bool then_inside = inside_share(was_there ? upper() : lower(), s.then, s.first) >= kInside;
        const bool gone = left_of(s.first) < 0.05;
        if (then.is_layer() && (first.is_layer() || first.is_fill())) {
            if (first.is_fill()) { // its cut lies between
                if (was_there && first_inside) return begin(s, Ground::ShrinksInside, RelationKind::Later);
                if (was_there && flat) return begin(s, Ground::FlatContact, RelationKind::Later);
                if (gone && !was_there) return begin(s, Ground::ReplacedWhole, RelationKind::Later);
                return std::nullopt;
            }
            // What grew out of the middle of a layer may be a pit, but no pit takes the whole layer along a flat
            // contact.
            const bool took_all = gone && share_of_succession(s) >= kMostOfReplaced;
            if (was_there && flat && (!then_inside || took_all)) return direct(s, Ground::FlatContact);
            if (!was_there && (gone || !then_inside) && share_of_succession(s) >= kPartReplaced) {
                if (share_of_succession(s) >= kMostOfReplaced) return direct(s, Ground::ReplacedWhole);
                return begin(s, Ground::ReplacedWhole, RelationKind::Later);
            }
            if (was_there && first_inside) return direct(s, Ground::FlatContact);
            return ask(s, was_there ? Ground::GrowsDownwards : Ground::AppearsInside);
        }
        if (then.is_fill() && first.is_fill()) {
            if (was_there && first_inside) return direct(s, Ground::ShrinksInside);
            if (gone && share_of_succession(s) >= kAllOfIt) return direct(s, Ground::ReplacedWhole);
        }
        return ask(s, was_there ? Ground::GrowsDownwards : Ground::AppearsInside);
    }

    [[nodiscard]] Conclusion direct(const Succession& s, Ground ground) const {
        Conclusion c = begin(s, ground, RelationKind::Covers);
        c.direct = true;
        return c;
    }

    const AreaHistory& history_;
    std::size_t from_;
    std::span<const KnownUnit> units_;
    const SurfaceStep& step_;
    double area_;
};

// The strongest of several conclusions about one pair; areas add up.
void merge(Conclusion& kept, const Conclusion& more) {
    const auto rank = [](const Conclusion& c) {
        return std::tuple(!c.is_question, c.direct, c.kind != RelationKind::Later, c.area);
    };
    const double area =
        kept.is_question == more.is_question ? kept.area + more.area : (kept.is_question ? more.area : kept.area);
    if (rank(more) > rank(kept)) kept = more;
    kept.area = area;
}

} // namespace

std::vector<Conclusion> conclude(const AreaHistory& history, std::span<const KnownUnit> units) {
    std::map<Pair, Conclusion> by_pair;
    for (std::size_t i = 0; i < history.steps.size(); ++i) {
        for (const Conclusion& c : Step(history, i, units).conclude()) {
            const auto [at, inserted] = by_pair.try_emplace({c.unit, c.other}, c);
            if (!inserted) merge(at->second, c);
        }
    }
    std::vector<Conclusion> all;
    for (const auto& [pair, c] : by_pair) {
        const auto back = by_pair.find({pair.second, pair.first});
        if (back != by_pair.end() && !back->second.is_question) {
            if (!c.is_question) continue; // both directions: no proposal, the checks say so
            continue;
        }
        all.push_back(c);
    }
    return all;
}

} // namespace planum::scans
