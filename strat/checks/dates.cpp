// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "strat/checks/families.hpp"

namespace planum::strat {

namespace {

using model::DatingKind;
using model::Severity;
using model::Year;

// A lower bound on its way up: which unit's dating it comes from and over which order it came.
struct Carried {
    Year from = 0;
    UnitIndex origin = model::kNoUnit;
    std::uint32_t order = 0; ///< in matrix.orders(); unused where the bound is the node's own
    bool own = false;
};

// A range of years that somebody wrote down for the unit itself.
bool is_range(const model::Dating& d) { return d.kind == DatingKind::Typed && d.from && d.to && *d.from < *d.to; }

// The strongest few bounds of a node, latest first. More than one, because a bound that has met its
// contradiction goes no further, and the next one must then be known.
constexpr std::size_t kCarried = 4;

struct CarriedBounds {
    std::array<Carried, kCarried> bounds{};
    std::size_t count = 0;

    void add(const Carried& bound) {
        for (std::size_t i = 0; i < count; ++i) {
            if (bounds[i].origin == bound.origin) return;
        }
        std::size_t at = count;
        while (at > 0 && later(bound, bounds[at - 1])) --at;
        if (at == kCarried) return;
        const std::size_t last = std::min(count, kCarried - 1);
        for (std::size_t i = last; i > at; --i) bounds[i] = bounds[i - 1];
        bounds[at] = bound;
        count = last + 1;
    }

    static bool later(const Carried& a, const Carried& b) {
        return a.from != b.from ? a.from > b.from : a.origin < b.origin;
    }
};

std::string dating_name(const CheckContext& c, std::uint32_t dating) {
    const model::Dating& d = c.record.datings[dating];
    std::string what;
    switch (d.kind) {
    case DatingKind::Typed: what = "dated"; break;
    case DatingKind::Find: what = "find"; break;
    case DatingKind::Coin: what = "coin"; break;
    case DatingKind::Radiocarbon: what = "radiocarbon"; break;
    case DatingKind::PostQuem: what = "terminus post quem"; break;
    case DatingKind::AnteQuem: what = "terminus ante quem"; break;
    }
    return d.label.empty() ? what : fmt::format("{} {}", what, d.label);
}

// What a digger would think of first, by the kind of evidence below.
std::string_view advice(DatingKind below) {
    switch (below) {
    case DatingKind::Find:
    case DatingKind::Coin: return "the find may be intrusive, or the relation wrong";
    case DatingKind::Radiocarbon: return "the sample may be intrusive, or the relation wrong";
    case DatingKind::Typed:
    case DatingKind::PostQuem:
    case DatingKind::AnteQuem: return "one of the dates or the relation is wrong";
    }
    return {};
}

class DateCheck {
  public:
    DateCheck(const CheckContext& context, Findings& findings)
        : c_(context), findings_(findings), bounds_(date_bounds(context)) {}

    void run() {
        for (UnitIndex u = 0; u < bounds_.size(); ++u) add_own(u);
        add_direct();
        carry();
    }

  private:
    const CheckContext& c_;
    Findings& findings_;
    std::vector<DateBounds> bounds_;
    std::set<std::pair<UnitIndex, UnitIndex>> reported_; // later, earlier
    std::vector<CarriedBounds> carried_;                 // by node

    // "Not later than" of the one lies before "not earlier than" of the other. Where one range ends in the
    // year in which the other begins they follow each other: that excludes it too.
    [[nodiscard]] bool excluded(UnitIndex later, UnitIndex earlier) const {
        const DateBounds& above = bounds_[later];
        const DateBounds& below = bounds_[earlier];
        if (!above.to || !below.from || *above.to > *below.from) return false;
        if (*above.to < *below.from) return true;
        return is_range(c_.record.datings[above.to_dating]) && is_range(c_.record.datings[below.from_dating]);
    }

    model::Diagnostic described(UnitIndex later, UnitIndex earlier, const std::string& relation) {
        const DateBounds& above = bounds_[later];
        const DateBounds& below = bounds_[earlier];
        auto d = make_diagnostic(Severity::Error, "date-contradiction",
                                 fmt::format("{}, but {} is not later than {} ({}) and {} not earlier than {} ({}): {}",
                                             relation, c_.name(later), year_text(*above.to),
                                             dating_name(c_, above.to_dating), c_.name(earlier), year_text(*below.from),
                                             dating_name(c_, below.from_dating),
                                             advice(c_.record.datings[below.from_dating].kind)));
        d.units = {c_.unit(later).id, c_.unit(earlier).id};
        d.evidence["later_not_after"] = *above.to;
        d.evidence["earlier_not_before"] = *below.from;
        d.evidence["years"] = *below.from - *above.to;
        return d;
    }

    void add_own(UnitIndex u) {
        const DateBounds& b = bounds_[u];
        if (!b.from || !b.to || *b.from <= *b.to) return;
        auto d = make_diagnostic(
            Severity::Error, "date-contradiction",
            fmt::format("{} holds dates that exclude each other: not earlier than {} ({}), not later than {} ({}); {}",
                        c_.name(u), year_text(*b.from), dating_name(c_, b.from_dating), year_text(*b.to),
                        dating_name(c_, b.to_dating), advice(c_.record.datings[b.from_dating].kind)));
        d.units = {c_.unit(u).id};
        d.evidence["not_before"] = *b.from;
        d.evidence["not_after"] = *b.to;
        d.evidence["years"] = *b.from - *b.to;
        findings_.push_back(std::move(d));
    }

    void add_direct() {
        for (RelationIndex r = 0; r < c_.subject.size(); ++r) {
            if (!c_.states_order(r)) continue;
            const UnitIndex later = c_.subject[r];
            const UnitIndex earlier = c_.object[r];
            if (later == earlier || !excluded(later, earlier)) continue;
            if (!reported_.emplace(later, earlier).second) continue;
            auto d = described(later, earlier, c_.sentence(r));
            d.relations = {c_.named(r)};
            d.evidence["direct"] = std::int64_t{1};
            findings_.push_back(std::move(d));
        }
    }

    // Bounds go up the condensed graph from the earliest; through a cycle group nothing is carried, for
    // there the orders themselves are in doubt.
    void carry() {
        const HarrisMatrix& m = c_.matrix;
        carried_.assign(m.node_count(), {});
        for (std::uint32_t component = static_cast<std::uint32_t>(m.component_count()); component-- > 0;) {
            const auto nodes = m.component(component);
            if (nodes.size() == 1) carry_into(nodes.front());
        }
    }

    void carry_into(NodeIndex node) {
        const HarrisMatrix& m = c_.matrix;
        CarriedBounds from_below;
        for (const std::uint32_t order : m.orders_below(node)) {
            const CarriedBounds& below = carried_[m.orders()[order].earlier];
            for (std::size_t i = 0; i < below.count; ++i) {
                from_below.add({below.bounds[i].from, below.bounds[i].origin, order, false});
            }
        }
        CarriedBounds& here = carried_[node];
        for (std::size_t i = 0; i < from_below.count; ++i) {
            const Carried& bound = from_below.bounds[i];
            bool met = false;
            for (const UnitIndex u : m.members(node)) {
                if (!excluded(u, bound.origin)) continue;
                met = true;
                add_transitive(u, node, bound);
            }
            if (!met) here.add(bound);
        }
        for (const UnitIndex u : m.members(node)) {
            if (!bounds_[u].from) continue;
            here.add({*bounds_[u].from, u, 0, true});
            for (const UnitIndex other : m.members(node)) {
                if (other != u && bounds_[other].to && *bounds_[other].to < *bounds_[u].from) add_same_as(other, u);
            }
        }
    }

    void add_transitive(UnitIndex later, NodeIndex node, const Carried& bound) {
        if (reported_.contains({later, bound.origin})) return;
        const std::vector<std::uint32_t> path = path_down(node, bound);
        // A direct pair on the way, stated between other members of the nodes, is the shorter story.
        for (const std::uint32_t order : path) {
            for (const RelationIndex r : c_.matrix.because(order)) {
                if (reported_.contains({c_.subject[r], c_.object[r]})) return;
            }
        }
        if (!reported_.emplace(later, bound.origin).second) return;
        auto d = described(later, bound.origin, path_text(c_, path, 6, {later, bound.origin}));
        d.relations = path_relations(c_, path);
        d.evidence["direct"] = std::int64_t{0};
        d.evidence["steps"] = static_cast<std::int64_t>(path.size());
        findings_.push_back(std::move(d));
    }

    void add_same_as(UnitIndex later, UnitIndex earlier) {
        if (!reported_.emplace(later, earlier).second) return;
        auto d = described(later, earlier, fmt::format("{} is the same as {}", c_.name(later), c_.name(earlier)));
        d.evidence["direct"] = std::int64_t{0};
        findings_.push_back(std::move(d));
    }

    std::vector<std::uint32_t> path_down(NodeIndex node, Carried bound) {
        std::vector<std::uint32_t> path;
        while (!bound.own) {
            path.push_back(bound.order);
            node = c_.matrix.orders()[bound.order].earlier;
            const CarriedBounds& below = carried_[node];
            for (std::size_t i = 0; i < below.count; ++i) {
                if (below.bounds[i].origin == bound.origin) {
                    bound = below.bounds[i];
                    break;
                }
            }
        }
        return path;
    }
};

} // namespace

std::vector<DateBounds> date_bounds(const CheckContext& context) {
    std::vector<DateBounds> bounds(context.record.units.size());
    const auto& datings = context.record.datings;
    std::unordered_map<model::FindId, model::UnitId> unit_of_find;
    for (const model::Find& find : context.record.finds) unit_of_find.emplace(find.id, find.unit);
    for (std::uint32_t i = 0; i < datings.size(); ++i) {
        const model::Dating& d = datings[i];
        model::UnitId unit = d.unit;
        if (const auto it = unit_of_find.find(d.find); unit.is_nil() && it != unit_of_find.end()) unit = it->second;
        const UnitIndex u = context.index.find(unit);
        if (u == model::kNoUnit) continue;
        std::optional<Year> from = d.from;
        std::optional<Year> to;
        switch (d.kind) {
        case DatingKind::Typed: to = d.to; break;
        case DatingKind::Find:
        case DatingKind::Coin:
        case DatingKind::Radiocarbon: break;
        case DatingKind::PostQuem:
            if (!from) from = d.to;
            break;
        case DatingKind::AnteQuem:
            to = d.to ? d.to : d.from;
            from.reset();
            break;
        }
        DateBounds& b = bounds[u];
        if (from && (!b.from || *from > *b.from)) {
            b.from = from;
            b.from_dating = i;
        }
        if (to && (!b.to || *to < *b.to)) {
            b.to = to;
            b.to_dating = i;
        }
    }
    return bounds;
}

void check_dates(const CheckContext& context, Findings& findings) {
    if (context.record.datings.empty()) return;
    DateCheck(context, findings).run();
}

} // namespace planum::strat
