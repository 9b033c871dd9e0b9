// SPDX-License-Identifier: MIT
#include "scans/surface/label_grid.hpp"

#include "tests/support/catch.hpp"

using namespace planum;

namespace {

model::Polygon square(double west, double south, double side) {
    return {{{west, south, 0}, {west + side, south, 0}, {west + side, south + side, 0}, {west, south + side, 0}}, {}};
}

model::Region region(model::Polygon polygon) {
    model::Region made;
    made.outline = {std::move(polygon)};
    return made;
}

const scans::GridFrame kMetre{0, 0, 10, 10, 0.1};

} // namespace

TEST_CASE("A region inside another cuts its own hole, whichever was drawn first") {
    const auto around = region(square(0.0, 0.0, 1.0));
    const auto inner = region(square(0.2, 0.2, 0.3));
    for (const bool first : {true, false}) {
        const std::vector<model::Region> regions = first ? std::vector{inner, around} : std::vector{around, inner};
        const auto grid = scans::label_cells(kMetre, regions);
        CHECK(grid.region[kMetre.at(3, 3)] == (first ? 0 : 1));
        CHECK(grid.region[kMetre.at(7, 7)] == (first ? 1 : 0));
        CHECK(std::count(grid.region.begin(), grid.region.end(), first ? 0 : 1) == 9);
    }
}

TEST_CASE("The distance to the nearest outline is exact, as far as it is kept") {
    const std::vector<model::Region> regions = {region(square(0.0, 0.0, 1.0))};
    const auto grid = scans::label_cells(kMetre, regions);
    CHECK(grid.outline_distance[kMetre.at(5, 0)] == Approx(0.05));
    CHECK(grid.outline_distance[kMetre.at(5, 2)] == Approx(0.25));
    CHECK(grid.outline_distance[kMetre.at(5, 5)] == scans::kFarFromOutlines);
}

TEST_CASE("Outlines outside the plan, on sections or of nothing label no cell") {
    auto on_section = region(square(0.0, 0.0, 1.0));
    on_section.section = {Uuid{1, 1}};
    const std::vector<model::Region> regions = {region(square(5.0, 5.0, 1.0)), on_section, model::Region{}};
    const auto grid = scans::label_cells(kMetre, regions);
    CHECK(std::count(grid.region.begin(), grid.region.end(), scans::kNoRegion) == 100);
}
