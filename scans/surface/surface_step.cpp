// SPDX-License-Identifier: MIT
#include "scans/surface/surface_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "core/base/error.hpp"

namespace planum::scans {

namespace {

using Pair = std::pair<UnitNumber, UnitNumber>;

constexpr double k95 = 1.96;
constexpr double kLeastSigma = 0.001; // of an outline [m]
// Edges of cells are longer than the line they follow: 4/π on the average of all directions.
constexpr double kStairs = 0.7853981633974483;

float median_of(std::vector<float>& values) {
    if (values.empty()) return 0.0F;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

void require_same_cells(const GridFrame& a, const GridFrame& b) {
    if (!(a == b)) throw Error(ErrorCode::BadInput, "surfaces lie on different cells; grid them on one frame first");
}

struct Tally {
    Succession sum;
    std::vector<float> drops;
    std::vector<float> thin_drops;
    std::vector<float> bounds;
};

bool is_level(model::RegionShows shows) {
    return shows == model::RegionShows::Level || shows == model::RegionShows::Machine;
}

void count(Tally& tally, const LabelledSurface& upper, const LabelledSurface& lower, std::size_t at, double project) {
    ++tally.sum.cells;
    if (!is_clear_of_outlines(upper, lower, at)) return;
    const double variance = static_cast<double>(upper.variance[at]) + static_cast<double>(lower.variance[at]) +
                            static_cast<double>(upper.common_variance[at]) +
                            static_cast<double>(lower.common_variance[at]);
    const double bound = std::max(project, k95 * std::sqrt(variance));
    const float drop = upper.height[at] - lower.height[at];
    if (static_cast<double>(drop) < -bound) return;
    tally.bounds.push_back(static_cast<float>(bound));
    if (static_cast<double>(drop) <= bound) {
        ++tally.sum.thin;
        tally.thin_drops.push_back(drop);
        return;
    }
    ++tally.sum.lower;
    tally.drops.push_back(drop);
    using model::RegionShows;
    if (is_level(upper.shows[at]) || is_level(lower.shows[at])) ++tally.sum.level;
    if (upper.shows[at] == RegionShows::Cut) ++tally.sum.cut_first;
    if (lower.shows[at] == RegionShows::Cut) ++tally.sum.cut_then;
    if (upper.shows[at] == RegionShows::Overdug || lower.shows[at] == RegionShows::Overdug) ++tally.sum.overdug;
}

// A hidden unit was at least as wide as a hand's breadth around what was measured of it.
void count_hidden(std::map<Pair, Tally>& tallies, const LabelledSurface& upper, const LabelledSurface& lower,
                  std::span<const std::size_t> hidden) {
    const GridFrame& frame = upper.frame;
    const auto reach = static_cast<std::int32_t>(std::lround(0.15 / frame.cell));
    for (const std::size_t at : hidden) {
        const auto row0 = static_cast<std::int32_t>(at / static_cast<std::size_t>(frame.columns));
        const auto column0 = static_cast<std::int32_t>(at % static_cast<std::size_t>(frame.columns));
        for (std::int32_t row = std::max(0, row0 - reach); row <= std::min(frame.rows - 1, row0 + reach); ++row) {
            for (std::int32_t column = std::max(0, column0 - reach);
                 column <= std::min(frame.columns - 1, column0 + reach); ++column) {
                const std::size_t i = frame.at(row, column);
                const auto found = tallies.find({upper.unit[i], lower.unit[i]});
                if (found != tallies.end()) ++found->second.sum.hidden;
            }
        }
    }
}

// Follows lines between units from one surface to the next.
class EdgeFollower {
  public:
    EdgeFollower(const LabelledSurface& upper, const LabelledSurface& lower, const HeightTolerance& tolerance)
        : upper_(upper), lower_(lower), tolerance_(tolerance) {}

    std::vector<EdgeMigration> follow() {
        const GridFrame& frame = upper_.frame;
        for (std::int32_t row = 0; row < frame.rows; ++row) {
            for (std::int32_t column = 0; column < frame.columns; ++column) {
                if (column + 1 < frame.columns) follow_edge(row, column, row, column + 1);
                if (row + 1 < frame.rows) follow_edge(row, column, row + 1, column);
            }
        }
        std::vector<EdgeMigration> edges;
        for (auto& [pair, growing] : edges_) {
            growing.edge.a = pair.first;
            growing.edge.b = pair.second;
            growing.edge.spit = static_cast<double>(median_of(growing.drops));
            edges.push_back(growing.edge);
        }
        return edges;
    }

  private:
    struct Growing {
        EdgeMigration edge;
        std::vector<float> drops;
    };

    void follow_edge(std::int32_t row1, std::int32_t column1, std::int32_t row2, std::int32_t column2) {
        const std::size_t i = upper_.frame.at(row1, column1);
        const std::size_t j = upper_.frame.at(row2, column2);
        if (upper_.unit[i] == upper_.unit[j] || upper_.unit[i] == kNobody || upper_.unit[j] == kNobody) return;
        if (upper_.unit[i] > upper_.unit[j]) {
            follow_sorted({row2, column2, j}, {row1, column1, i});
        } else {
            follow_sorted({row1, column1, i}, {row2, column2, j});
        }
    }

    struct Place {
        std::int32_t row;
        std::int32_t column;
        std::size_t at;
    };

    void follow_sorted(const Place& in_a, const Place& in_b) {
        const UnitNumber a = upper_.unit[in_a.at];
        const UnitNumber b = upper_.unit[in_b.at];
        Growing& growing = edges_[{a, b}];
        const double side = upper_.frame.cell * kStairs;
        growing.edge.length += side;
        const UnitNumber below_a = lower_.unit[in_a.at];
        const UnitNumber below_b = lower_.unit[in_b.at];
        if ((below_a != a && below_a != b) || (below_b != a && below_b != b)) return;
        const float drop =
            0.5F * (upper_.height[in_a.at] - lower_.height[in_a.at] + upper_.height[in_b.at] - lower_.height[in_b.at]);
        if (static_cast<double>(drop) < tolerance_.project) return;
        growing.edge.followed += side;
        growing.drops.push_back(drop);
        // Both outlines are uncertain by σ each.
        const double reach = std::max(static_cast<double>(drop) / std::tan(kFlatContact), kLeastMigration);
        if (below_a == b && taken_over(in_a, a, b, reach)) growing.edge.into_a += side;
        if (below_b == a && taken_over(in_b, b, a, reach)) growing.edge.into_b += side;
    }

    // Whether nothing of `gone` is left within reach, and most of what is there is `come`.
    [[nodiscard]] bool taken_over(const Place& place, UnitNumber gone, UnitNumber come, double reach) const {
        const GridFrame& frame = lower_.frame;
        const auto radius = static_cast<std::int32_t>(std::ceil(reach / frame.cell));
        std::int64_t labelled = 0;
        std::int64_t came = 0;
        for (std::int32_t dr = -radius; dr <= radius; ++dr) {
            const std::int32_t row = place.row + dr;
            if (row < 0 || row >= frame.rows) continue;
            for (std::int32_t dc = -radius; dc <= radius; ++dc) {
                const std::int32_t column = place.column + dc;
                if (column < 0 || column >= frame.columns || dr * dr + dc * dc > radius * radius) continue;
                const UnitNumber unit = lower_.unit[frame.at(row, column)];
                if (unit == gone) return false;
                labelled += unit != kNobody ? 1 : 0;
                came += unit == come ? 1 : 0;
            }
        }
        return 4 * came >= 3 * labelled;
    }

    static constexpr double kLeastMigration = 0.085; // 2σ of the difference of two outlines of σ = 3 cm [m]

    const LabelledSurface& upper_;
    const LabelledSurface& lower_;
    HeightTolerance tolerance_;
    std::map<Pair, Growing> edges_;
};

} // namespace

bool is_clear_of_outlines(const LabelledSurface& upper, const LabelledSurface& lower, std::size_t cell) noexcept {
    constexpr float kEach = 1.0F;
    constexpr float kTogether = 4.05F; // not the last cells that lines 4σ apart could have between them
    const float above = upper.from_outline[cell];
    const float below = lower.from_outline[cell];
    return std::min(above, below) >= kEach && above + below >= kTogether;
}

LabelledSurface label_surface(const SurfaceGrid& grid, const LabelGrid& labels, std::span<const model::Region> regions,
                              std::span<const UnitNumber> units, const HeightTolerance& tolerance) {
    require_same_cells(grid.frame, labels.frame);
    const std::size_t n = grid.frame.cells();
    LabelledSurface surface;
    surface.frame = grid.frame;
    surface.unit.assign(n, static_cast<std::int16_t>(kNobody));
    surface.shows.assign(n, model::RegionShows::Nothing);
    surface.from_outline.assign(n, 0.0F);
    surface.height = grid.height;
    surface.variance.assign(n, 0.0F);
    surface.common_variance.assign(n, 0.0F);
    for (std::size_t i = 0; i < n; ++i) {
        const std::int32_t region = labels.region[i];
        if (region == kNoRegion || std::isnan(grid.height[i])) continue;
        const model::Region& drawn = regions[static_cast<std::size_t>(region)];
        // The side of an emptied cut is what its outline is about; elsewhere a face belongs to nobody.
        const bool side = grid.state[i] == CellState::Face && drawn.shows == model::RegionShows::Cut;
        if (grid.state[i] != CellState::Surface && !side) continue;
        if (drawn.shows == model::RegionShows::Nothing || drawn.shows == model::RegionShows::Face) continue;
        surface.unit[i] = static_cast<std::int16_t>(units[static_cast<std::size_t>(region)]);
        surface.shows[i] = drawn.shows;
        surface.from_outline[i] = labels.outline_distance[i] / static_cast<float>(std::max(drawn.sigma, kLeastSigma));
        const double spread = std::max(static_cast<double>(grid.spread[i]), tolerance.sensor_sigma);
        const double points = std::max<double>(1.0, grid.count[i]);
        const double slope = std::isnan(grid.slope[i]) ? 0.0 : static_cast<double>(grid.slope[i]);
        // Half a cell of the outline's σ would do for heights of one and the same place; the outline decides only
        // which unit it is. What moves sideways is the scan, whose σ stands in pose_sigma, and the cell itself.
        const double sideways = (side ? 0.5 : 0.25) * grid.frame.cell * slope;
        surface.variance[i] = static_cast<float>(spread * spread / points + sideways * sideways);
        surface.common_variance[i] = grid.pose_sigma[i] * grid.pose_sigma[i] * static_cast<float>(1.0 + slope * slope);
    }
    return surface;
}

SurfaceSummary summarise(const LabelledSurface& surface) {
    struct Growing {
        Showing showing;
        std::vector<float> heights;
    };

    std::map<UnitNumber, Growing> showings;
    std::map<Pair, double> edges;
    const GridFrame& frame = surface.frame;
    const double side = frame.cell * kStairs;
    const auto meet = [&](std::size_t i, std::size_t j) {
        const UnitNumber a = surface.unit[i];
        const UnitNumber b = surface.unit[j];
        if (a == b) return;
        for (const auto& [own, other] : {Pair{a, b}, Pair{b, a}}) {
            if (own == kNobody) continue;
            showings[own].showing.perimeter += side;
            if (other == kNobody) showings[own].showing.open_edge += side;
        }
        if (a != kNobody && b != kNobody) edges[{std::min(a, b), std::max(a, b)}] += side;
    };
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column) {
            const std::size_t i = frame.at(row, column);
            if (column + 1 < frame.columns) meet(i, i + 1);
            if (row + 1 < frame.rows) meet(i, frame.at(row + 1, column));
            if (surface.unit[i] == kNobody) continue;
            Growing& growing = showings[surface.unit[i]];
            ++growing.showing.cells;
            if (is_level(surface.shows[i])) ++growing.showing.level_cells;
            if (surface.shows[i] == model::RegionShows::Cut) ++growing.showing.cut_cells;
            if (surface.shows[i] == model::RegionShows::Overdug) ++growing.showing.overdug_cells;
            growing.heights.push_back(surface.height[i]);
        }
    }
    SurfaceSummary summary;
    for (auto& [unit, growing] : showings) {
        growing.showing.unit = unit;
        growing.showing.height = static_cast<double>(median_of(growing.heights));
        summary.showings.push_back(growing.showing);
    }
    for (const auto& [pair, length] : edges) summary.edges.push_back({pair.first, pair.second, length});
    return summary;
}

SurfaceStep step_between(const LabelledSurface& upper, const LabelledSurface& lower, const HeightTolerance& tolerance,
                         std::span<const std::size_t> hidden, std::vector<float>& floor) {
    require_same_cells(upper.frame, lower.frame);
    const std::size_t n = upper.frame.cells();
    floor.resize(n, std::nanf(""));
    std::map<Pair, Tally> tallies;
    for (std::size_t i = 0; i < n; ++i) {
        // A fmin of NaN and a number is the number.
        floor[i] = std::fmin(floor[i], upper.height[i]);
        if (upper.unit[i] == kNobody || lower.unit[i] == kNobody) continue;
        const bool rose = upper.height[i] > floor[i] + static_cast<float>(2.0 * tolerance.project);
        if (rose) continue;
        count(tallies[{upper.unit[i], lower.unit[i]}], upper, lower, i, tolerance.project);
    }
    count_hidden(tallies, upper, lower, hidden);
    SurfaceStep step;
    step.cell = upper.frame.cell;
    for (auto& [pair, tally] : tallies) {
        tally.sum.first = pair.first;
        tally.sum.then = pair.second;
        tally.sum.drop = static_cast<double>(median_of(tally.drops.empty() ? tally.thin_drops : tally.drops));
        tally.sum.tolerance = static_cast<double>(median_of(tally.bounds));
        step.successions.push_back(tally.sum);
    }
    step.edges = EdgeFollower(upper, lower, tolerance).follow();
    return step;
}

} // namespace planum::scans
