// SPDX-License-Identifier: MIT
#include "scans/surface/surface_step.hpp"

#include <utility>
#include <vector>

#include "scans/surface/label_grid.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using namespace planum::scans;

namespace {

constexpr double kSigma = 0.03; // of an outline, as it is unless said otherwise

model::Region region(double west, double east) {
    model::Region made;
    made.shows = model::RegionShows::Top;
    made.sigma = kSigma;
    model::Polygon polygon;
    for (const auto& [x, y] : {std::pair{west, 0.0}, {east, 0.0}, {east, 2.0}, {west, 2.0}})
        polygon.outer.push_back({x, y, 0.0});
    made.outline = {polygon};
    return made;
}

// Flat ground of 2 × 2 m that strips of units cover from west to east.
LabelledSurface strips(double height, const std::vector<double>& ends, const std::vector<UnitNumber>& units) {
    const GridFrame frame{0, 0, 100, 100, 0.02};
    const std::size_t n = frame.cells();
    const SurfaceGrid grid{frame,
                           std::vector<float>(n, static_cast<float>(height)),
                           std::vector<float>(n, 0.003F),
                           std::vector<float>(n, 0.0F),
                           std::vector<float>(n, 0.0F),
                           std::vector<std::uint16_t>(n, 4),
                           std::vector<CellState>(n, CellState::Surface)};
    std::vector<model::Region> regions;
    for (std::size_t i = 0; i < units.size(); ++i) regions.push_back(region(i == 0 ? 0.0 : ends[i - 1], ends[i]));
    return label_surface(grid, label_cells(frame, regions), regions, units, {});
}

std::int64_t lower_cells(const LabelledSurface& upper, const LabelledSurface& lower, UnitNumber first,
                         UnitNumber then) {
    std::vector<float> floor;
    for (const Succession& s : step_between(upper, lower, {}, {}, floor).successions) {
        if (s.first == first && s.then == then) return s.lower;
    }
    return 0;
}

} // namespace

TEST_CASE("A line drawn 12 cm astray puts no unit over another") {
    // The truth is a line at 1.00 m on both days, drawn 2σ to the west on one and 2σ to the east on the other.
    const LabelledSurface upper = strips(10.0, {0.94, 2.0}, {0, 1});
    const LabelledSurface lower = strips(9.8, {1.06, 2.0}, {0, 1});
    CHECK(lower_cells(upper, lower, 1, 0) == 0);
    CHECK(lower_cells(upper, lower, 0, 1) == 0);
    CHECK(lower_cells(upper, lower, 0, 0) > 0);
}

TEST_CASE("A wall narrower than four σ that comes out in the middle of a layer lies below it") {
    const LabelledSurface upper = strips(10.0, {2.0}, {0});
    const LabelledSurface lower = strips(9.8, {0.95, 1.05, 2.0}, {0, 1, 0});
    const std::int64_t cells = lower_cells(upper, lower, 0, 1);
    CHECK(cells > 0);
    CHECK(cells < 5 * 100); // only its middle counts
}
