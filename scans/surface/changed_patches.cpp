// SPDX-License-Identifier: MIT
#include "scans/surface/changed_patches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/base/error.hpp"
#include "core/geometry/polygon_overlay.hpp"
#include "core/geometry/polygons.hpp"

namespace planum::scans {

namespace {

constexpr std::array<std::array<std::int32_t, 2>, 4> kSides = {{{0, 1}, {1, 0}, {0, -1}, {-1, 0}}}; // row, column

// -1 lower, 1 higher, 0 neither.
std::vector<std::int8_t> directions(const SurfaceDifference& difference, const SurfaceGrid& after,
                                    const std::vector<std::int32_t>& after_labels) {
    const GridFrame& frame = difference.frame;
    std::vector<std::int8_t> direction(frame.cells(), 0);
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column) {
            const std::size_t at = frame.at(row, column);
            const float change = difference.change[at];
            if (after_labels[at] != kNoRegion || std::isnan(change)) continue;
            if (after.state[cell_in(after.frame, frame, row, column)] != CellState::Surface) continue;
            if (change < -difference.detectable[at]) direction[at] = -1;
            if (change > difference.detectable[at]) direction[at] = 1;
        }
    }
    return direction;
}

std::vector<std::int8_t> without_specks(const GridFrame& frame, const std::vector<std::int8_t>& direction) {
    constexpr int kMost = 5; // of eight
    std::vector<std::int8_t> kept(direction.size(), 0);
    for (std::int32_t row = 1; row + 1 < frame.rows; ++row) {
        for (std::int32_t column = 1; column + 1 < frame.columns; ++column) {
            const std::int8_t own = direction[frame.at(row, column)];
            int alike = own == 0 ? 0 : -1;
            for (std::int32_t r = row - 1; own != 0 && r <= row + 1; ++r) {
                for (std::int32_t c = column - 1; c <= column + 1; ++c) alike += direction[frame.at(r, c)] == own;
            }
            if (alike >= kMost) kept[frame.at(row, column)] = own;
        }
    }
    return kept;
}

// Cells that hang together by their sides and changed the same way.
std::vector<std::vector<std::size_t>> components(const GridFrame& frame, const std::vector<std::int8_t>& direction) {
    std::vector<bool> seen(direction.size(), false);
    std::vector<std::vector<std::size_t>> all;
    const auto columns = static_cast<std::size_t>(frame.columns);
    for (std::size_t start = 0; start < direction.size(); ++start) {
        if (direction[start] == 0 || seen[start]) continue;
        std::vector<std::size_t> cells{start};
        seen[start] = true;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const auto row = static_cast<std::int32_t>(cells[i] / columns);
            const auto column = static_cast<std::int32_t>(cells[i] % columns);
            for (const auto& side : kSides) {
                const std::int32_t r = row + side[0];
                const std::int32_t c = column + side[1];
                if (r < 0 || c < 0 || r >= frame.rows || c >= frame.columns) continue;
                const std::size_t other = frame.at(r, c);
                if (seen[other] || direction[other] != direction[start]) continue;
                seen[other] = true;
                cells.push_back(other);
            }
        }
        std::sort(cells.begin(), cells.end());
        all.push_back(std::move(cells));
    }
    return all;
}

std::vector<LabelShare> sorted_shares(const std::map<std::int32_t, double>& amounts) {
    std::vector<LabelShare> shares;
    for (const auto& [label, amount] : amounts) shares.push_back({label, amount});
    std::stable_sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) { return a.amount > b.amount; });
    return shares;
}

double median_of(std::vector<float> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return static_cast<double>(*middle);
}

/// Corners of cells joined by the edges between inside and outside, the inside to the left.
class EdgeWalk {
  public:
    EdgeWalk(const GridFrame& frame, const std::vector<std::uint8_t>& inside) : frame_(frame), inside_(inside) {
        for (std::int32_t row = 0; row < frame.rows; ++row) {
            for (std::int32_t column = 0; column < frame.columns; ++column) {
                if (is_inside(row, column)) add_edges(row, column);
            }
        }
    }

    geometry::MultiPolygon rings() {
        std::vector<geometry::Line3> outer;
        std::vector<geometry::Line3> holes;
        for (auto it = edges_.begin(); it != edges_.end(); it = edges_.begin()) {
            geometry::Line3 ring = walk(it->first);
            (geometry::signed_area(ring) > 0.0 ? outer : holes).push_back(std::move(ring));
        }
        geometry::MultiPolygon shape;
        for (geometry::Line3& ring : outer) shape.push_back({std::move(ring)});
        for (geometry::Line3& hole : holes) give_hole(shape, std::move(hole));
        return shape;
    }

  private:
    using Corner = std::pair<std::int32_t, std::int32_t>; // row, column of the corner south-west of that cell

    [[nodiscard]] bool is_inside(std::int32_t row, std::int32_t column) const {
        return row >= 0 && column >= 0 && row < frame_.rows && column < frame_.columns &&
               inside_[frame_.at(row, column)] != 0;
    }

    void add_edges(std::int32_t row, std::int32_t column) {
        if (!is_inside(row - 1, column)) edges_[{row, column}].push_back({row, column + 1});
        if (!is_inside(row, column + 1)) edges_[{row, column + 1}].push_back({row + 1, column + 1});
        if (!is_inside(row + 1, column)) edges_[{row + 1, column + 1}].push_back({row + 1, column});
        if (!is_inside(row, column - 1)) edges_[{row + 1, column}].push_back({row, column});
    }

    // Where two cells touch at a corner, the way to the left stays with its own cell.
    Corner next(const Corner& from, const Corner& at) {
        std::vector<Corner>& ways = edges_.at(at);
        std::size_t best = 0;
        if (ways.size() > 1) {
            const auto left = [&](const Corner& to) {
                return (at.second - from.second) * (to.first - at.first) -
                           (at.first - from.first) * (to.second - at.second) >
                       0;
            };
            best = left(ways[0]) ? 0 : 1;
        }
        const Corner to = ways[best];
        ways.erase(ways.begin() + static_cast<std::ptrdiff_t>(best));
        if (ways.empty()) edges_.erase(at);
        return to;
    }

    geometry::Line3 walk(Corner start) { // by value: the first step takes its edge out of the map
        geometry::Line3 ring;
        Corner before = start;
        Corner at = start;
        do {
            const Corner to = next(before, at);
            const bool straight = ring.size() > 1 && at != start &&
                                  (to.first - at.first) == (at.first - before.first) &&
                                  (to.second - at.second) == (at.second - before.second);
            if (!straight || ring.empty()) ring.push_back(place(at));
            before = at;
            at = to;
        } while (at != start);
        return ring;
    }

    [[nodiscard]] geometry::Point3 place(const Corner& corner) const {
        return {static_cast<double>(frame_.west + corner.second) * frame_.cell,
                static_cast<double>(frame_.south + corner.first) * frame_.cell, 0.0};
    }

    // To the smallest outer ring around it.
    void give_hole(geometry::MultiPolygon& shape, geometry::Line3 hole) const {
        // Half a cell off the ring's first edge, inside the hole's own cell row, so that no line is met.
        const double x = (hole[0][0] + hole[1][0]) / 2.0;
        const double y = (hole[0][1] + hole[1][1]) / 2.0;
        geometry::Rings* best = nullptr;
        double least = std::numeric_limits<double>::infinity();
        for (geometry::Rings& rings : shape) {
            const double area = geometry::signed_area(rings.front());
            const bool around = geometry::contains({{rings.front()}}, x, y) ||
                                geometry::contains({{rings.front()}}, x - frame_.cell / 2, y - frame_.cell / 2);
            if (area < least && around && area > -geometry::signed_area(hole)) {
                least = area;
                best = &rings;
            }
        }
        if (best != nullptr) best->push_back(std::move(hole));
    }

    const GridFrame& frame_;
    const std::vector<std::uint8_t>& inside_;
    std::map<Corner, std::vector<Corner>> edges_;
};

double height_near(const SurfaceGrid& grid, double x, double y) {
    const auto row = static_cast<std::int32_t>(std::floor(y / grid.frame.cell) - static_cast<double>(grid.frame.south));
    const auto column =
        static_cast<std::int32_t>(std::floor(x / grid.frame.cell) - static_cast<double>(grid.frame.west));
    constexpr std::int32_t kReach = 3;
    double best = 0.0;
    std::int32_t nearest = std::numeric_limits<std::int32_t>::max();
    for (std::int32_t r = std::max(0, row - kReach); r <= std::min(grid.frame.rows - 1, row + kReach); ++r) {
        for (std::int32_t c = std::max(0, column - kReach); c <= std::min(grid.frame.columns - 1, column + kReach);
             ++c) {
            const std::size_t at = grid.frame.at(r, c);
            const std::int32_t far = (r - row) * (r - row) + (c - column) * (c - column);
            if (grid.state[at] != CellState::Surface || far >= nearest) continue;
            nearest = far;
            best = static_cast<double>(grid.height[at]);
        }
    }
    return best;
}

// The middles of all edges of cells: what was a stair along a slanting line is straight.
geometry::Line3 through_middles(const geometry::Line3& ring, double cell) {
    geometry::Line3 line;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const geometry::Point3& a = ring[i];
        const geometry::Point3& b = ring[(i + 1) % ring.size()];
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        const auto edges = std::max<std::int64_t>(1, std::llround(length / cell));
        for (std::int64_t edge = 0; edge < edges; ++edge) {
            const double t = (static_cast<double>(edge) + 0.5) / static_cast<double>(edges);
            line.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), 0.0});
        }
    }
    return line;
}

// A ring has no ends; from its first corner and the one farthest from it it is two lines.
geometry::Line3 simplified_ring(const geometry::Line3& ring, double tolerance) {
    const auto from_first = [&](const geometry::Point3& p) { return std::hypot(p[0] - ring[0][0], p[1] - ring[0][1]); };
    const auto far = std::max_element(ring.begin(), ring.end(),
                                      [&](const auto& a, const auto& b) { return from_first(a) < from_first(b); });
    const geometry::Line3 there = geometry::simplified({ring.begin(), far + 1}, tolerance);
    geometry::Line3 back(far, ring.end());
    back.push_back(ring.front());
    back = geometry::simplified(back, tolerance);
    geometry::Line3 simple(there.begin(), there.end() - 1);
    simple.insert(simple.end(), back.begin(), back.end() - 1);
    return simple.size() >= 3 ? simple : ring;
}

// The shape made sound, where nothing of it is lost by that; else empty.
geometry::MultiPolygon whole(const geometry::MultiPolygon& shape, std::size_t parts) {
    try {
        geometry::MultiPolygon sound = geometry::make_sound(shape).shape;
        if (sound.size() == parts) return sound;
    } catch (const Error&) { // it crosses itself where it matters
    }
    return {};
}

// A ring that would meet itself keeps points there, and so do all rings where two would meet; the rest of the outline
// is as simple as it would be without.
geometry::MultiPolygon simplified_patch(const geometry::MultiPolygon& cells, double cell, double tolerance) {
    geometry::MultiPolygon middles = cells;
    for (geometry::Rings& rings : middles) {
        for (geometry::Line3& ring : rings) ring = through_middles(ring, cell);
    }
    geometry::MultiPolygon simple = middles;
    for (geometry::Rings& rings : simple) {
        for (geometry::Line3& ring : rings) {
            const geometry::MultiPolygon full = {{ring}};
            ring = simplified_ring(ring, tolerance);
            if (!whole({{ring}}, 1).empty()) continue;
            const geometry::MultiPolygon apart = geometry::simplified_apart(full, tolerance);
            ring = apart.empty() ? full.front().front() : apart.front().front();
        }
    }
    for (const geometry::MultiPolygon& one : {simple, geometry::simplified_apart(middles, tolerance), middles}) {
        geometry::MultiPolygon sound = whole(one, cells.size());
        if (!sound.empty()) return sound;
    }
    return cells;
}

geometry::MultiPolygon drawn(geometry::MultiPolygon cells, const SurfaceGrid& after, const PatchOptions& options) {
    for (geometry::Rings& rings : cells) {
        const auto small = [&](const geometry::Line3& hole) {
            return std::abs(geometry::signed_area(hole)) < options.least_hole;
        };
        rings.erase(std::remove_if(rings.begin() + 1, rings.end(), small), rings.end());
    }
    const double tolerance = options.simplify;
    geometry::MultiPolygon shape =
        tolerance > 0.0 ? simplified_patch(cells, after.frame.cell, tolerance) : std::move(cells);
    for (geometry::Rings& rings : shape) {
        for (geometry::Line3& ring : rings) {
            for (geometry::Point3& point : ring) point[2] = height_near(after, point[0], point[1]);
        }
    }
    return shape;
}

} // namespace

geometry::MultiPolygon outline_of_cells(const GridFrame& frame, const std::vector<std::uint8_t>& inside) {
    return EdgeWalk(frame, inside).rings();
}

std::vector<ChangedPatch> changed_patches(const SurfaceDifference& difference, const SurfaceGrid& after,
                                          const std::vector<std::int32_t>& before_labels,
                                          const std::vector<std::int32_t>& after_labels, const PatchOptions& options) {
    const GridFrame& frame = difference.frame;
    const double cell_area = frame.cell * frame.cell;
    const auto direction = without_specks(frame, directions(difference, after, after_labels));
    const auto columns = static_cast<std::size_t>(frame.columns);
    const auto height = [&](std::int32_t row, std::int32_t column) {
        return static_cast<double>(after.height[cell_in(after.frame, frame, row, column)]);
    };
    std::vector<std::uint8_t> inside(frame.cells(), 0);
    // The outermost cells of what changed, and those of an outline, are unsure: the first label within three cells.
    const auto label_beyond = [&](std::int32_t row, std::int32_t column, const std::array<std::int32_t, 2>& side) {
        constexpr std::int32_t kReach = 3;
        for (std::int32_t step = 1; step <= kReach; ++step) {
            const std::int32_t r = row + step * side[0];
            const std::int32_t c = column + step * side[1];
            if (r < 0 || c < 0 || r >= frame.rows || c >= frame.columns) break;
            const std::int32_t label = after_labels[frame.at(r, c)];
            if (label == kNoRegion) continue;
            return std::abs(height(r, c) - height(row, column)) <= options.step ? label : kNoRegion;
        }
        return kNoRegion;
    };
    std::vector<ChangedPatch> patches;
    for (const std::vector<std::size_t>& cells : components(frame, direction)) {
        ChangedPatch patch;
        patch.area = static_cast<double>(cells.size()) * cell_area;
        if (patch.area < options.least_area) continue;
        for (const std::size_t cell : cells) inside[cell] = 1;
        std::map<std::int32_t, double> was;
        std::map<std::int32_t, double> beside;
        std::vector<float> changes;
        for (const std::size_t cell : cells) {
            was[before_labels[cell]] += cell_area;
            changes.push_back(difference.change[cell]);
            const auto row = static_cast<std::int32_t>(cell / columns);
            const auto column = static_cast<std::int32_t>(cell % columns);
            for (const auto& side : kSides) {
                const std::int32_t r = row + side[0];
                const std::int32_t c = column + side[1];
                if (r >= 0 && c >= 0 && r < frame.rows && c < frame.columns && inside[frame.at(r, c)] != 0) continue;
                patch.edge += frame.cell;
                const std::int32_t label = label_beyond(row, column, side);
                if (label != kNoRegion) beside[label] += frame.cell;
            }
        }
        patch.change = median_of(std::move(changes));
        patch.was = sorted_shares(was);
        patch.beside = sorted_shares(beside);
        patch.shape = drawn(outline_of_cells(frame, inside), after, options);
        for (const std::size_t cell : cells) inside[cell] = 0;
        patches.push_back(std::move(patch));
    }
    std::stable_sort(patches.begin(), patches.end(), [](const auto& a, const auto& b) { return a.area > b.area; });
    return patches;
}

} // namespace planum::scans
