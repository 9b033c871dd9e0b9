// SPDX-License-Identifier: MIT
#include "scans/panorama/scan_extent.hpp"

#include <cmath>
#include <random>

#include "scans/panorama/panorama.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using namespace planum::scans;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

struct Sweep {
    int columns = 400;
    int rows = 150;
    double first_azimuth = 170.0; ///< [deg]
    double azimuth_step = -0.9;   ///< [deg], clockwise as most scanners turn
    double first_elevation = -55.0;
    double elevation_step = 0.6;
    double noise = 0.02;    ///< of a direction [deg]
    bool two_sided = false; ///< a dome scanner: the beam goes over the zenith, every other point is behind
};

PointBlock swept(const Sweep& sweep) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    PointBlock block;
    for (int c = 0; c < sweep.columns; ++c) {
        for (int r = 0; r < sweep.rows; ++r) {
            const double behind = sweep.two_sided && r % 2 == 1 ? 180.0 : 0.0;
            const double azimuth =
                (sweep.first_azimuth + behind + c * sweep.azimuth_step + sweep.noise * normal(random)) * kDegree;
            const double elevation =
                (sweep.first_elevation + r * sweep.elevation_step + sweep.noise * normal(random)) * kDegree;
            const double range = 4.0 + 0.001 * static_cast<double>(random() % 50);
            block.x.push_back(range * std::cos(elevation) * std::cos(azimuth));
            block.y.push_back(range * std::cos(elevation) * std::sin(azimuth));
            block.z.push_back(range * std::sin(elevation));
            block.row.push_back(static_cast<std::uint32_t>(r));
            block.column.push_back(static_cast<std::uint32_t>(c));
            block.validity.push_back(Validity::Valid);
        }
    }
    return block;
}

constexpr Columns kGrid{false, false, true, false};

} // namespace

TEST_CASE("A regular grid of the scanner is known again, and each of its cells becomes a pixel") {
    const Sweep sweep;
    const PointBlock block = swept(sweep);
    ScanExtent extent(kGrid);
    extent.add(block);
    const auto steps = extent.grid();
    REQUIRE(steps);
    CHECK(steps->azimuth_step == Approx(-0.9 * kDegree).epsilon(1e-3));
    CHECK(steps->elevation_step == Approx(0.6 * kDegree).epsilon(1e-3));

    PanoramaOptions options;
    options.projection = extent.fit(ProjectionKind::Equirectangular, 16000);
    options.gaps.most_pixels = 0;
    CHECK(options.projection.width == 400);
    CHECK(options.projection.height == 150);
    PanoramaBuilder builder(options, {});
    builder.add(block);
    const Panorama panorama = builder.finish(Progress::none());
    CHECK(panorama.points() == block.size());
    CHECK(panorama.filled() == block.size()); // one point to a pixel
}

TEST_CASE("The picture is cut where the scanner did not look") {
    Sweep sweep;
    sweep.columns = 100; // a quarter of the circle, across the seam of atan2
    sweep.first_azimuth = -140.0;
    ScanExtent extent(kGrid);
    extent.add(swept(sweep));
    const ProjectionOptions gridded = extent.fit(ProjectionKind::Equirectangular, 16000);
    CHECK((gridded.azimuth_to - gridded.azimuth_from) / kDegree == Approx(90.0).margin(0.1));
    CHECK(gridded.width == 100);

    // The same without knowing the grid: to the cells of a quarter of a degree.
    ScanExtent free(Columns{});
    free.add(swept(sweep));
    CHECK_FALSE(free.grid());
    const ProjectionOptions options = free.fit(ProjectionKind::Equirectangular, 16000);
    CHECK((options.azimuth_to - options.azimuth_from) / kDegree == Approx(90.0).margin(1.0));
    CHECK(options.elevation_from / kDegree == Approx(-55.0).margin(0.5));
    for (const ProjectionKind kind :
         {ProjectionKind::Cylindrical, ProjectionKind::Mercator, ProjectionKind::Miller, ProjectionKind::EqualArea,
          ProjectionKind::Rectilinear, ProjectionKind::Pannini, ProjectionKind::Stereographic}) {
        PanoramaOptions unrolled;
        unrolled.projection = extent.fit(kind, 16000);
        INFO(projection_name(kind));
        PanoramaBuilder builder(unrolled, {});
        builder.add(swept(sweep));
        CHECK(builder.finish(Progress::none()).points() > 14000); // of 15,000
    }
}

TEST_CASE("A grid that is none in this frame is not taken for one") {
    Sweep two_sided;
    two_sided.two_sided = true;
    two_sided.columns = 200;
    ScanExtent dome(kGrid);
    dome.add(swept(two_sided));
    CHECK_FALSE(dome.grid());

    // Coordinates that somebody levelled afterwards: rows are no longer of one elevation.
    PointBlock tilted = swept({});
    for (std::size_t i = 0; i < tilted.size(); ++i) {
        const double x = tilted.x[i];
        tilted.x[i] = std::cos(0.1) * x - std::sin(0.1) * tilted.z[i];
        tilted.z[i] = std::sin(0.1) * x + std::cos(0.1) * tilted.z[i];
    }
    ScanExtent extent(kGrid);
    extent.add(tilted);
    CHECK_FALSE(extent.grid());
    const ProjectionOptions options = extent.fit(ProjectionKind::Equirectangular, 16000);
    // About a pixel for a point; the grid had 400 x 150.
    CHECK(static_cast<double>(options.width) * options.height == Approx(60000.0).epsilon(0.3));
    CHECK(ScanExtent(kGrid).fit(ProjectionKind::Pannini, 500).width == ProjectionOptions{}.width); // no point at all
}

TEST_CASE("No picture is wider than what was asked for") {
    ScanExtent extent(kGrid);
    extent.add(swept({}));
    const ProjectionOptions options = extent.fit(ProjectionKind::Equirectangular, 300);
    CHECK(options.width == 300);
    CHECK(options.height == Approx(75).margin(1));
}

TEST_CASE("Between neighbours in the scanner's grid nothing stays empty however large the picture is") {
    Sweep sweep;
    sweep.noise = 0.0;
    const PointBlock block = swept(sweep);
    ScanExtent extent(kGrid);
    extent.add(block);
    PanoramaOptions options;
    options.projection = with_square_pixels(extent.fit(ProjectionKind::Equirectangular, 16000), 0.0, 3000);
    const auto filled = [&](Columns has) {
        PanoramaBuilder builder(options, has);
        builder.add(block);
        return builder.finish(Progress::none());
    };
    const Panorama with_grid = filled(kGrid);
    const double pixels = static_cast<double>(with_grid.width()) * with_grid.height();
    CHECK(static_cast<double>(with_grid.filled()) > 0.98 * pixels);
    CHECK(static_cast<double>(filled(Columns{}).filled()) < 0.2 * pixels);
    // What a closed pixel shows lies within a step of the grid of it.
    for (int column = 5; column < with_grid.width(); column += 97) {
        const auto points = with_grid.points_at(column, with_grid.height() / 2);
        if (points.empty()) continue;
        const auto shown = with_grid.projection().pixel_of(with_grid.place(points.front()));
        REQUIRE(shown);
        CHECK(std::abs(shown->x() - column - 0.5) < 7.5);
    }
}

TEST_CASE("Between neighbours in the grid at different ranges it stays empty") {
    Sweep sweep;
    sweep.noise = 0.0;
    PointBlock block = swept(sweep);
    // Every other column stands at double the range.
    for (std::size_t i = 0; i < block.size(); ++i) {
        if (block.column[i] % 2 == 0) continue;
        block.x[i] *= 2.0;
        block.y[i] *= 2.0;
        block.z[i] *= 2.0;
    }
    ScanExtent extent(kGrid);
    extent.add(block);
    PanoramaOptions options;
    options.projection = with_square_pixels(extent.fit(ProjectionKind::Equirectangular, 16000), 0.0, 3000);
    options.gaps.most_pixels = 1;
    PanoramaBuilder builder(options, kGrid);
    builder.add(block);
    const Panorama panorama = builder.finish(Progress::none());
    CHECK(static_cast<double>(panorama.filled()) < 0.3 * panorama.width() * panorama.height());
}
