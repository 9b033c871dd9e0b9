// SPDX-License-Identifier: MIT
#include "app/demo/dig_outlines.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "app/demo/dig_line.hpp"
#include "app/demo/simulator_random.hpp"

namespace planum::app::demo {

namespace {

using Shown = SurfaceCell::Shown;

constexpr int kOutside = -1;
constexpr int kBaulk = -2;
constexpr int kSlump = -3;
constexpr std::size_t kSpeck = 40; ///< cells; nobody outlines less [2 cm squares]

int label_of(const SurfaceCell& cell) {
    switch (cell.shown) {
    case Shown::Nothing: return kOutside;
    case Shown::Baulk: return kBaulk;
    case Shown::Slump: return kSlump;
    case Shown::Overdug: return 2 * cell.unit + 1;
    case Shown::Top:
    case Shown::Level:
    case Shown::Cut: return 2 * cell.unit;
    }
    return kOutside;
}

// The labels of a surface with their connected patches.
class PatchMap {
  public:
    PatchMap(const SurfaceMap& map, const ColumnGrid& grid)
        : columns_(static_cast<int>(grid.columns())), rows_(static_cast<int>(grid.rows())), labels_(map.size()) {
        std::transform(map.begin(), map.end(), labels_.begin(), label_of);
        for (int pass = 0; pass < 2; ++pass) {
            find_patches();
            absorb_specks();
        }
        find_patches();
    }

    [[nodiscard]] int columns() const { return columns_; }

    [[nodiscard]] std::size_t patches() const { return cells_.size(); }

    [[nodiscard]] const std::vector<int>& cells(std::size_t patch) const { return cells_[patch]; }

    [[nodiscard]] int label(std::size_t patch) const {
        return labels_[static_cast<std::size_t>(cells_[patch].front())];
    }

    [[nodiscard]] int patch_at(int column, int row) const {
        if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return -1;
        return patch_[static_cast<std::size_t>(row * columns_ + column)];
    }

    // Lines are drawn between labels; everything outside the trench is one.
    [[nodiscard]] bool differs(int c1, int r1, int c2, int r2) const { return patch_at(c1, r1) != patch_at(c2, r2); }

  private:
    void find_patches() {
        patch_.assign(labels_.size(), -1);
        cells_.clear();
        for (std::size_t start = 0; start < labels_.size(); ++start) {
            if (patch_[start] >= 0) continue;
            const int number = static_cast<int>(cells_.size());
            std::vector<int> patch = {static_cast<int>(start)};
            patch_[start] = number;
            for (std::size_t i = 0; i < patch.size(); ++i) {
                for_neighbours(patch[i], [&](int other) {
                    const auto at = static_cast<std::size_t>(other);
                    if (patch_[at] >= 0 || labels_[at] != labels_[start]) return;
                    patch_[at] = number;
                    patch.push_back(other);
                });
            }
            std::sort(patch.begin(), patch.end());
            cells_.push_back(std::move(patch));
        }
    }

    void absorb_specks() {
        const std::vector<int> before = labels_;
        for (const auto& patch : cells_) {
            if (patch.size() >= kSpeck) continue;
            std::map<int, int> around;
            for (const int cell : patch) {
                for_neighbours(cell, [&](int other) {
                    const int label = before[static_cast<std::size_t>(other)];
                    if (label != before[static_cast<std::size_t>(cell)]) ++around[label];
                });
            }
            if (around.empty()) continue;
            const auto most = std::max_element(around.begin(), around.end(),
                                               [](const auto& a, const auto& b) { return a.second < b.second; });
            for (const int cell : patch) labels_[static_cast<std::size_t>(cell)] = most->first;
        }
    }

    template<class Visit>
    void for_neighbours(int cell, Visit visit) const {
        const int column = cell % columns_;
        if (column > 0) visit(cell - 1);
        if (column + 1 < columns_) visit(cell + 1);
        if (cell >= columns_) visit(cell - columns_);
        if (cell + columns_ < columns_ * rows_) visit(cell + columns_);
    }

    int columns_;
    int rows_;
    std::vector<int> labels_;
    std::vector<int> patch_;
    std::vector<std::vector<int>> cells_;
};

// How many lines meet in a corner of the lattice.
int lines_at(const PatchMap& map, Corner c) {
    const int x = c.x;
    const int y = c.y;
    return map.differs(x - 1, y - 1, x, y - 1) + map.differs(x - 1, y, x, y) + map.differs(x - 1, y - 1, x - 1, y) +
           map.differs(x, y - 1, x, y);
}

// Closed walks around a patch with the patch on the left: outer ones counter-clockwise, holes clockwise.
std::vector<std::vector<Corner>> rings_of(const PatchMap& map, std::size_t patch) {
    std::map<Corner, std::vector<Corner>> steps;
    for (const int cell : map.cells(patch)) {
        const int x = cell % map.columns();
        const int y = cell / map.columns();
        if (map.differs(x, y, x, y - 1)) steps[{x, y}].push_back({x + 1, y});
        if (map.differs(x, y, x + 1, y)) steps[{x + 1, y}].push_back({x + 1, y + 1});
        if (map.differs(x, y, x, y + 1)) steps[{x + 1, y + 1}].push_back({x, y + 1});
        if (map.differs(x, y, x - 1, y)) steps[{x, y + 1}].push_back({x, y});
    }
    std::vector<std::vector<Corner>> rings;
    while (!steps.empty()) {
        std::vector<Corner> ring = {steps.begin()->first};
        Corner heading{0, 0};
        do {
            const Corner here = ring.back();
            auto& next = steps[here];
            // Where two corners of the patch meet, keep to the left: they are two pieces.
            std::size_t choice = 0;
            for (std::size_t i = 1; i < next.size(); ++i) {
                const int turn = heading.x * (next[i].y - here.y) - heading.y * (next[i].x - here.x);
                if (turn > 0) choice = i;
            }
            const Corner to = next[choice];
            next.erase(next.begin() + static_cast<std::ptrdiff_t>(choice));
            if (next.empty()) steps.erase(here);
            heading = {to.x - here.x, to.y - here.y};
            ring.push_back(to);
        } while (!(ring.back() == ring.front()));
        ring.pop_back();
        rings.push_back(std::move(ring));
    }
    return rings;
}

double signed_area(const model::Ring& ring) {
    double sum = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto& a = ring[i];
        const auto& b = ring[(i + 1) % ring.size()];
        sum += (a[0] - ring[0][0]) * (b[1] - ring[0][1]) - (b[0] - ring[0][0]) * (a[1] - ring[0][1]);
    }
    return 0.5 * sum;
}

// The draughtsman's hand on one day: a shift of the whole sheet and a tremble, the same for every line that
// passes a place.
class Hand {
  public:
    Hand(std::uint64_t seed, SurfaceNo surface) : key_(mix(mix(seed, 4000), static_cast<std::uint64_t>(surface))) {
        Draw draw(key_, 1);
        shift_x_ = draw.between(-0.007, 0.007);
        shift_y_ = draw.between(-0.007, 0.007);
    }

    [[nodiscard]] std::array<double, 2> drawn(double x, double y) const {
        const auto tremble = [&](std::uint64_t axis) {
            return 0.008 * noise(mix(key_, axis), x / 0.5, y / 0.5) +
                   0.003 * noise(mix(key_, axis + 10), x / 0.11, y / 0.11);
        };
        return {x + shift_x_ + tremble(2), y + shift_y_ + tremble(3)};
    }

  private:
    std::uint64_t key_;
    double shift_x_ = 0.0;
    double shift_y_ = 0.0;
};

class Draughtsman {
  public:
    Draughtsman(const SurfaceMap& map, const ColumnGrid& grid, SurfaceNo surface, std::uint64_t seed)
        : map_(map), grid_(grid), patches_(map, grid), hand_(seed, surface), surface_(surface) {}

    std::vector<DrawnRegion> draw() const {
        std::vector<DrawnRegion> regions;
        for (std::size_t patch = 0; patch < patches_.patches(); ++patch) {
            if (patches_.label(patch) == kOutside || patches_.cells(patch).size() < kSpeck) continue;
            regions.push_back(region_of(patch));
            for (const auto& ring : rings_of(patches_, patch)) {
                model::Ring drawn = draw_ring(ring);
                if (drawn.size() < 3) continue;
                (signed_area(drawn) > 0.0 ? regions.back().outline.outer
                                          : regions.back().outline.holes.emplace_back()) = std::move(drawn);
            }
        }
        std::erase_if(regions, [](const DrawnRegion& region) { return region.outline.outer.size() < 3; });
        return regions;
    }

  private:
    [[nodiscard]] DrawnRegion region_of(std::size_t patch) const {
        DrawnRegion region;
        region.surface = surface_;
        const int label = patches_.label(patch);
        if (label == kBaulk) region.category = model::RegionCategory::Baulk;
        if (label == kSlump) region.category = model::RegionCategory::Slump;
        if (label < 0) {
            region.shows = model::RegionShows::Nothing;
            return region;
        }
        region.unit = label / 2;
        std::map<Shown, std::size_t> count;
        for (const int cell : patches_.cells(patch)) {
            const SurfaceCell& bare = map_[static_cast<std::size_t>(cell)];
            if (bare.unit == region.unit) ++count[bare.shown];
        }
        if (count[Shown::Level] > count[Shown::Top]) region.shows = model::RegionShows::Level;
        if (count[Shown::Cut] > count[Shown::Top] + count[Shown::Level]) region.shows = model::RegionShows::Cut;
        if (label % 2 == 1) {
            region.shows = model::RegionShows::Overdug;
            region.notes = "dug a little too deep here";
        }
        return region;
    }

    [[nodiscard]] std::array<double, 3> placed(const LinePoint& p) const {
        const double x = grid_.x0() + p.x * grid_.cell();
        const double y = grid_.y0() + p.y * grid_.cell();
        const auto column = std::min(static_cast<std::size_t>(std::max(p.x, 0.0)), grid_.columns() - 1);
        const auto row = std::min(static_cast<std::size_t>(std::max(p.y, 0.0)), grid_.rows() - 1);
        const auto drawn = hand_.drawn(x, y);
        const auto rounded = [](double v) { return std::round(v * 1e3) / 1e3; };
        return {rounded(drawn[0]), rounded(drawn[1]),
                rounded(static_cast<double>(map_[row * grid_.columns() + column].z))};
    }

    // A ring in pieces between the corners where three lines meet; each piece is the same from both sides.
    [[nodiscard]] model::Ring draw_ring(const std::vector<Corner>& ring) const {
        std::vector<std::size_t> nodes;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            if (lines_at(patches_, ring[i]) > 2) nodes.push_back(i);
        }
        model::Ring drawn;
        if (nodes.empty()) {
            for (const LinePoint& p : simplified_loop(ring)) drawn.push_back(placed(p));
            return drawn;
        }
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            const std::size_t from = nodes[n];
            const std::size_t to = n + 1 < nodes.size() ? nodes[n + 1] : nodes[0] + ring.size();
            std::vector<Corner> piece;
            for (std::size_t i = from; i <= to; ++i) piece.push_back(ring[i % ring.size()]);
            const std::vector<LinePoint> line = simplified_piece(piece);
            for (std::size_t i = 0; i + 1 < line.size(); ++i) drawn.push_back(placed(line[i]));
        }
        return drawn;
    }

    const SurfaceMap& map_;
    const ColumnGrid& grid_;
    PatchMap patches_;
    Hand hand_;
    SurfaceNo surface_;
};

} // namespace

std::vector<DrawnRegion> draw_outlines(const SurfaceMap& map, const ColumnGrid& grid, SurfaceNo surface,
                                       std::uint64_t seed) {
    return Draughtsman(map, grid, surface, seed).draw();
}

} // namespace planum::app::demo
