// SPDX-License-Identifier: MIT
#include "scans/surface/changed_patches.hpp"

#include <cmath>
#include <random>

#include "core/geometry/polygon_overlay.hpp"
#include "core/geometry/polygons.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using namespace planum::scans;

namespace {

GridFrame frame_of(std::int32_t columns, std::int32_t rows) { return {-10, 40, columns, rows, 0.1}; }

SurfaceGrid flat(const GridFrame& frame, float z) {
    SurfaceGrid grid;
    grid.frame = frame;
    grid.height.assign(frame.cells(), z);
    grid.spread.assign(frame.cells(), 0.002F);
    grid.pose_sigma.assign(frame.cells(), 0.0F);
    grid.slope.assign(frame.cells(), 0.0F);
    grid.count.assign(frame.cells(), 10);
    grid.state.assign(frame.cells(), CellState::Surface);
    return grid;
}

void dig(SurfaceGrid& grid, std::int32_t row, std::int32_t column, std::int32_t rows, std::int32_t columns, float by) {
    for (std::int32_t r = row; r < row + rows; ++r) {
        for (std::int32_t c = column; c < column + columns; ++c) grid.height[grid.frame.at(r, c)] -= by;
    }
}

std::vector<std::int32_t> no_labels(const GridFrame& frame) {
    return std::vector<std::int32_t>(frame.cells(), kNoRegion);
}

} // namespace

TEST_CASE("The outline of cells holds exactly these cells, whatever their shape") {
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        INFO("seed " << seed);
        std::mt19937 random(seed);
        const GridFrame frame = frame_of(12, 9);
        std::vector<std::uint8_t> inside(frame.cells());
        std::size_t count = 0;
        for (std::uint8_t& cell : inside) {
            cell = random() % 3 != 0 ? 1 : 0;
            count += cell;
        }
        const geometry::MultiPolygon shape = outline_of_cells(frame, inside);
        CHECK(geometry::area(shape) == Approx(static_cast<double>(count) * 0.01));
        std::size_t wrong = 0;
        for (std::int32_t row = 0; row < frame.rows; ++row) {
            for (std::int32_t column = 0; column < frame.columns; ++column) {
                const bool there = geometry::contains(shape, frame.x(column), frame.y(row));
                wrong += there != (inside[frame.at(row, column)] != 0);
            }
        }
        CHECK(wrong == 0);
        for (const geometry::Rings& rings : shape) {
            CHECK(geometry::signed_area(rings.front()) > 0.0);
            for (std::size_t i = 1; i < rings.size(); ++i) {
                CHECK(geometry::signed_area(rings[i]) < 0.0);
                CHECK(geometry::contains({{rings.front()}}, (rings[i][0][0] + rings[i][1][0]) / 2,
                                         (rings[i][0][1] + rings[i][1][1]) / 2 - 1e-6));
            }
        }
    }
}

TEST_CASE("What was dug and not outlined is a patch; what was outlined, or did not change, is none") {
    const GridFrame frame = frame_of(40, 30);
    const SurfaceGrid before = flat(frame, 10.0F);
    SurfaceGrid after = before;
    dig(after, 5, 5, 10, 12, 0.2F);
    dig(after, 5, 25, 10, 10, 0.3F);
    std::vector<std::int32_t> was = no_labels(frame);
    std::vector<std::int32_t> is = no_labels(frame);
    for (std::int32_t r = 0; r < frame.rows; ++r) {
        for (std::int32_t c = 0; c < frame.columns; ++c) was[frame.at(r, c)] = c < 12 ? 7 : 8;
        for (std::int32_t c = 20; c < frame.columns; ++c) is[frame.at(r, c)] = 9; // the second hole was outlined
    }
    PatchOptions options;
    options.simplify = 0.0;
    const auto patches = changed_patches(surface_difference(before, after, 0.02), after, was, is, options);
    REQUIRE(patches.size() == 1);
    const ChangedPatch& patch = patches.front();
    CHECK(patch.change == Approx(-0.2).margin(1e-4));
    // All but the four corners, of whose neighbours only three changed.
    CHECK(patch.area == Approx(1.2 - 4 * 0.01));
    CHECK(geometry::area(patch.shape) == Approx(patch.area));
    REQUIRE(patch.was.size() == 2);
    CHECK(patch.was[0].label == 7);
    CHECK(patch.was[0].amount == Approx(0.7 - 2 * 0.01));
    CHECK(patch.beside.empty());
    for (const geometry::Point3& corner : patch.shape.front().front()) CHECK(corner[2] == Approx(9.8).margin(0.21));
}

TEST_CASE("A patch goes on where an outlined neighbour lies at its own height, not where there is a step") {
    const GridFrame frame = frame_of(40, 30);
    const SurfaceGrid before = flat(frame, 10.0F);
    SurfaceGrid after = before;
    dig(after, 5, 5, 10, 20, 0.2F);
    std::vector<std::int32_t> is = no_labels(frame);
    for (std::int32_t r = 0; r < frame.rows; ++r) {
        for (std::int32_t c = 15; c < frame.columns; ++c) is[frame.at(r, c)] = c < 25 ? 3 : 4;
    }
    const auto patches = changed_patches(surface_difference(before, after, 0.02), after, no_labels(frame), is);
    REQUIRE(patches.size() == 1);
    REQUIRE(patches[0].beside.size() == 1);
    CHECK(patches[0].beside[0].label == 3);
    CHECK(patches[0].beside[0].amount == Approx(1.0).margin(0.21));
}

TEST_CASE("Sides part the bottom of a pit from the ground around it, and specks are no patches") {
    const GridFrame frame = frame_of(40, 40);
    const SurfaceGrid before = flat(frame, 10.0F);
    SurfaceGrid after = before;
    dig(after, 2, 2, 36, 36, 0.1F);
    dig(after, 15, 15, 10, 10, 0.5F);
    for (std::int32_t r = 14; r < 26; ++r) {
        for (std::int32_t c = 14; c < 26; ++c) {
            if (r == 14 || r == 25 || c == 14 || c == 25) after.state[frame.at(r, c)] = CellState::Face;
        }
    }
    const auto patches =
        changed_patches(surface_difference(before, after, 0.02), after, no_labels(frame), no_labels(frame));
    REQUIRE(patches.size() == 2);
    CHECK(patches[0].change == Approx(-0.1).margin(1e-4));
    CHECK(patches[0].shape.front().size() == 2); // a hole where the pit is
    CHECK(patches[1].change == Approx(-0.6).margin(1e-4));

    SurfaceGrid speckled = before;
    for (std::int32_t c = 3; c < 38; c += 2) dig(speckled, 10, c, 1, 1, 0.4F);
    CHECK(changed_patches(surface_difference(before, speckled, 0.02), speckled, no_labels(frame), no_labels(frame))
              .empty());
}

TEST_CASE("No outline of a patch runs along the corners of cells, however ragged it is, and all are sound") {
    std::size_t patches = 0;
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        INFO("seed " << seed);
        std::mt19937 random(seed);
        const GridFrame frame = frame_of(60, 40);
        const SurfaceGrid before = flat(frame, 10.0F);
        SurfaceGrid after = before;
        for (int i = 0; i < 40; ++i) { // pits that run into each other, by necks of a few cells
            const auto row = static_cast<std::int32_t>(random() % 32);
            const auto column = static_cast<std::int32_t>(random() % 52);
            dig(after, row, column, 2 + static_cast<std::int32_t>(random() % 6),
                2 + static_cast<std::int32_t>(random() % 6), 0.2F);
        }
        PatchOptions options;
        options.least_area = 0.1;
        options.least_hole = 0.01;
        options.simplify = 0.04;
        for (const ChangedPatch& patch : changed_patches(surface_difference(before, after, 0.02), after,
                                                         no_labels(frame), no_labels(frame), options)) {
            ++patches;
            CHECK(geometry::make_sound(patch.shape).repairs.empty());
            CHECK(geometry::area(patch.shape) ==
                  Approx(patch.area).epsilon(0.12).margin(0.02)); // small ones lose their corners
            std::size_t corners = 0;
            for (const geometry::Rings& rings : patch.shape) {
                for (const geometry::Line3& ring : rings) {
                    for (const geometry::Point3& p : ring) {
                        const auto on_line = [](double v) { return std::abs(v / 0.1 - std::round(v / 0.1)) < 1e-6; };
                        corners += on_line(p[0]) && on_line(p[1]);
                    }
                }
            }
            CHECK(corners == 0);
        }
    }
    CHECK(patches > 60);
}
