// SPDX-License-Identifier: MIT
#include "scans/surface/section_columns.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/geometry/polygons.hpp"

namespace planum::scans {

namespace {

/// One piece of a region in a column.
struct Piece {
    double bottom = 0.0;
    double top = 0.0;
    std::size_t region = 0;
};

/// What was seen of an ordered pair: `first` on `second`.
struct Seen {
    double length = 0.0;
    double from = 0.0;
    double to = 0.0;
};

using Pairs = std::map<std::pair<UnitNumber, UnitNumber>, Seen>;

// Columns run along what geometry::spans_at() calls y.
std::vector<geometry::MultiPolygon> turned(std::span<const SectionRegion> regions) {
    std::vector<geometry::MultiPolygon> all;
    for (const SectionRegion& region : regions) {
        geometry::MultiPolygon shape = region.shape;
        for (geometry::Rings& rings : shape) {
            for (geometry::Line3& ring : rings) {
                for (geometry::Point3& point : ring) std::swap(point[0], point[1]);
            }
        }
        all.push_back(std::move(shape));
    }
    return all;
}

// Calls visit(along, below, above) for every two pieces of two units that touch in a column.
template<class Visit>
void for_contacts(std::span<const SectionRegion> regions, double column, const Visit& visit) {
    geometry::Extent extent;
    for (const SectionRegion& region : regions) extent.add(geometry::extent(region.shape));
    if (extent.is_empty()) return;
    const std::vector<geometry::MultiPolygon> shapes = turned(regions);
    std::vector<Piece> pieces;
    for (double along = extent.low[0] + column / 2.0; along < extent.high[0]; along += column) {
        pieces.clear();
        for (std::size_t r = 0; r < shapes.size(); ++r) {
            for (const auto& [bottom, top] : geometry::spans_at(shapes[r], along)) pieces.push_back({bottom, top, r});
        }
        std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
            return std::pair(a.bottom + a.top, a.region) < std::pair(b.bottom + b.top, b.region);
        });
        for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
            const SectionRegion& lower = regions[pieces[i].region];
            const SectionRegion& upper = regions[pieces[i + 1].region];
            if (lower.unit == upper.unit || lower.unit == kNobody || upper.unit == kNobody) continue;
            const double apart = std::abs(pieces[i + 1].bottom - pieces[i].top);
            if (apart <= 2.0 * std::hypot(lower.sigma, upper.sigma)) visit(along, pieces[i], pieces[i + 1]);
        }
    }
}

// Heights of a unit over all its regions: lowest and highest.
std::map<UnitNumber, std::pair<double, double>> heights(std::span<const SectionRegion> regions) {
    std::map<UnitNumber, std::pair<double, double>> found;
    for (const SectionRegion& region : regions) {
        const geometry::Extent extent = geometry::extent(region.shape);
        if (extent.is_empty()) continue;
        const auto [it, fresh] = found.try_emplace(region.unit, extent.low[1], extent.high[1]);
        it->second.first = std::min(it->second.first, extent.low[1]);
        it->second.second = std::max(it->second.second, extent.high[1]);
    }
    return found;
}

double greatest_sigma(std::span<const SectionRegion> regions) {
    double sigma = 0.0;
    for (const SectionRegion& region : regions) sigma = std::max(sigma, region.sigma);
    return sigma;
}

bool is_fill(const KnownUnit& unit) { return unit.form == model::UnitForm::Fill; }

} // namespace

std::vector<SectionContact> section_contacts(std::span<const SectionRegion> regions, double column) {
    Pairs pairs;
    for_contacts(regions, column, [&](double along, const Piece& below, const Piece& above) {
        const std::pair pair{regions[above.region].unit, regions[below.region].unit};
        const auto [it, fresh] = pairs.try_emplace(pair, Seen{0.0, along - column / 2.0, 0.0});
        it->second.length += column;
        it->second.to = along + column / 2.0;
    });
    const auto reach = heights(regions);
    const double slack = 2.0 * greatest_sigma(regions);
    std::vector<SectionContact> contacts;
    for (const auto& [pair, seen] : pairs) {
        const auto other = pairs.find({pair.second, pair.first});
        const double contrary = other == pairs.end() ? 0.0 : other->second.length;
        const bool is_lesser = contrary > seen.length || (contrary == seen.length && pair.second < pair.first);
        if (other != pairs.end() && is_lesser) continue; // the other way round says it
        SectionContact contact{pair.first, pair.second, seen.length, contrary, seen.from, seen.to, false};
        contact.upper_reaches_below = reach.at(pair.first).first < reach.at(pair.second).second - slack;
        contacts.push_back(contact);
    }
    return contacts;
}

std::vector<ContactColumn> contact_columns(std::span<const SectionRegion> regions, UnitNumber upper, UnitNumber lower,
                                           double column) {
    std::vector<ContactColumn> columns;
    for_contacts(regions, column, [&](double along, const Piece& below, const Piece& above) {
        if (regions[above.region].unit == upper && regions[below.region].unit == lower)
            columns.push_back({along, below.bottom, below.top, above.bottom, above.top});
    });
    return columns;
}

SectionVerdict judge_contact(const SectionContact& contact, const KnownUnit& upper, const KnownUnit& lower) {
    constexpr double kStray = 0.1; // of the length: lines of two hands never quite agree
    SectionVerdict verdict;
    if (contact.length < kLeastContact) return verdict;
    if (contact.contrary > std::max(kStray * contact.length, 0.04)) {
        verdict.why = SectionVerdict::Why::BothWays;
        return verdict;
    }
    // A pit that was dug under its surroundings, or a footing that rises through a layer, shows the older unit on top.
    const bool may_be_later = (is_fill(lower) && !is_fill(upper)) || lower.kind == model::UnitKind::Structure;
    if (may_be_later && contact.upper_reaches_below) {
        verdict.why = SectionVerdict::Why::ReachesBelow;
        return verdict;
    }
    verdict.why = SectionVerdict::Why::LiesOn;
    // Between a fill and what it was filled into there is a cut, which a section shows as a line.
    const bool over_a_cut = (is_fill(upper) && !is_fill(lower)) || upper.kind == model::UnitKind::Structure;
    verdict.kind = over_a_cut ? model::RelationKind::Later : model::RelationKind::Covers;
    verdict.direct = !over_a_cut;
    return verdict;
}

} // namespace planum::scans
