// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <numbers>
#include <random>

#include "core/base/error.hpp"
#include "scans/panorama/panorama.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;
using namespace planum::scans;
using namespace planum::test;

namespace {

constexpr ProjectionKind kAll[] = {ProjectionKind::Equirectangular, ProjectionKind::Cylindrical,
                                   ProjectionKind::Mercator,        ProjectionKind::Miller,
                                   ProjectionKind::EqualArea,       ProjectionKind::Rectilinear,
                                   ProjectionKind::Pannini,         ProjectionKind::Stereographic};

ProjectionOptions small(ProjectionKind kind) {
    ProjectionOptions options;
    options.kind = kind;
    options.width = 360;
    options.height = 100;
    return options;
}

/// A room of 10 × 10 × 4 m around the scanner, seen along the middle of each pixel of an equirectangular
/// picture; every pixel for which `skip` says so is left out.
template<class Skip>
PointBlock room(const Projection& seen, Skip skip) {
    PointBlock block;
    for (int row = 0; row < seen.options().height; ++row) {
        for (int column = 0; column < seen.options().width; ++column) {
            if (skip(column, row)) continue;
            const Eigen::Vector3d ray = *seen.ray_of({column + 0.5, row + 0.5});
            const double range = std::min(
                {5.0 / std::max(std::abs(ray.x()), std::abs(ray.y())), ray.z() > 0.0 ? 2.5 / ray.z() : 1.5 / -ray.z()});
            block.x.push_back(range * ray.x());
            block.y.push_back(range * ray.y());
            block.z.push_back(range * ray.z());
            block.validity.push_back(Validity::Valid);
            block.intensity.push_back(static_cast<std::uint16_t>(100 * row));
            block.colour.push_back({static_cast<std::uint8_t>(row), 7, 9});
        }
    }
    return block;
}

Panorama unroll(const PointBlock& block, const PanoramaOptions& options) {
    PanoramaBuilder builder(options, {true, true, false, false});
    builder.add(block);
    return builder.finish(Progress::none());
}

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

TEST_CASE("From pixel to ray and back is where it started, in every projection") {
    std::mt19937 random(1);
    for (const ProjectionKind kind : kAll) {
        INFO(projection_name(kind));
        const Projection projection(small(kind));
        int tried = 0;
        double worst = 0.0;
        for (int i = 0; i < 5000; ++i) {
            const Eigen::Vector2d pixel(0.01 * static_cast<double>(random() % 35998 + 1),
                                        0.01 * static_cast<double>(random() % 9998 + 1));
            const auto ray = projection.ray_of(pixel);
            if (!ray) continue;
            ++tried;
            CHECK(ray->norm() == Approx(1.0));
            const auto back = projection.pixel_of(*ray * 3.7);
            REQUIRE(back);
            worst = std::max(worst, (*back - pixel).norm());
        }
        CHECK(tried > 4000);
        CHECK(worst < 1e-7);
    }
}

TEST_CASE("Every direction of the horizon is in the picture, left is left and up is up") {
    for (const ProjectionKind kind : kAll) {
        INFO(projection_name(kind));
        const Projection projection(small(kind));
        for (int degrees = -179; degrees < 180; ++degrees) {
            const double azimuth = degrees * std::numbers::pi / 180.0;
            const auto pixel = projection.pixel_of({std::cos(azimuth), std::sin(azimuth), 0.0});
            REQUIRE(pixel);
            const auto higher = projection.pixel_of({std::cos(azimuth), std::sin(azimuth), 0.2});
            CHECK(higher->y() < pixel->y());
        }
        // y is to the left of x.
        CHECK(projection.pixel_of({1.0, 0.3, 0.0})->x() < projection.pixel_of({1.0, 0.0, 0.0})->x());
    }
}

TEST_CASE("A projection that cannot show its extent is refused") {
    ProjectionOptions options = small(ProjectionKind::Mercator);
    options.elevation_to = std::numbers::pi / 2.0;
    CHECK_THROWS_WITH(Projection(options), Catch::Contains("mercator panorama cannot show elevations up to 90.0"));
    options = small(ProjectionKind::Rectilinear);
    options.views = 1;
    CHECK_THROWS_WITH(Projection(options), Catch::Contains("at least 3"));
    options = small(ProjectionKind::Miller);
    options.width = 0;
    CHECK_THROWS_AS(Projection(options), Error);
    CHECK(projection_from_name("pannini") == ProjectionKind::Pannini);
    CHECK_FALSE(projection_from_name("flat"));
}

TEST_CASE("Many directions at once fall where each falls alone, and what is no direction falls nowhere") {
    std::mt19937_64 random(5);
    std::normal_distribution<double> part(0.0, 3.0);
    std::vector<double> x(1000); // no multiple of what is done at once
    std::vector<double> y(x.size());
    std::vector<double> z(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] = part(random);
        y[i] = part(random);
        z[i] = part(random);
    }
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const std::vector<std::array<double, 3>> none = {
        {kNone, 1.0, 1.0}, {1.0, kNone, 1.0}, {1.0, 1.0, kNone}, {kInfinity, kInfinity, 1.0}, {kNone, kNone, kNone}};
    for (std::size_t i = 0; i < none.size(); ++i) {
        x[300 + i] = none[i][0];
        y[300 + i] = none[i][1];
        z[300 + i] = none[i][2];
    }
    for (const ProjectionKind kind : kAll) {
        INFO(projection_name(kind));
        const Projection projection(small(kind));
        std::vector<std::uint32_t> all(x.size());
        projection.indices_of(x, y, z, all);
        for (std::size_t i = 0; i < x.size(); ++i) {
            const std::int64_t alone = projection.index_of(x[i], y[i], z[i]);
            REQUIRE(alone == (all[i] == Projection::kOutside ? -1 : std::int64_t{all[i]}));
        }
        for (std::size_t i = 0; i < none.size(); ++i) CHECK(all[300 + i] == Projection::kOutside);
    }
}

TEST_CASE("Each point is in the list of its pixel and in no other, in every projection") {
    const PointBlock block = room(Projection(small(ProjectionKind::Equirectangular)), [](int, int) { return false; });
    for (const ProjectionKind kind : kAll) {
        INFO(projection_name(kind));
        PanoramaOptions options;
        options.projection = small(kind);
        options.projection.height = 60; // fewer pixels than points, so that lists are long
        options.gaps.most_pixels = 0;
        const Panorama panorama = unroll(block, options);
        std::size_t listed = 0;
        for (int row = 0; row < 60; ++row) {
            for (int column = 0; column < 360; ++column) {
                double last = 0.0;
                for (const std::uint32_t point : panorama.points_at(column, row)) {
                    ++listed;
                    const std::uint64_t n = panorama.source(point);
                    REQUIRE(panorama.projection().index_of(block.x[n], block.y[n], block.z[n]) == row * 360 + column);
                    REQUIRE(panorama.place(point).norm() >= last * (1.0 - 1e-6));
                    last = panorama.place(point).norm();
                }
            }
        }
        CHECK(listed == panorama.points());
        CHECK(panorama.points() > block.size() / 2);
    }
}

TEST_CASE("Many points in one pixel are all found") {
    PanoramaOptions options;
    options.projection = small(ProjectionKind::Equirectangular);
    PointBlock block;
    block.resize(1000, {true, true, false, false});
    for (std::size_t i = 0; i < 1000; ++i) {
        block.x[i] = 5.0 - 0.001 * static_cast<double>(i);
        block.y[i] = 0.01;
        block.z[i] = 0.01;
    }
    const Panorama panorama = unroll(block, options);
    const auto pixel = panorama.projection().pixel_of({5, 0.01, 0.01});
    const auto points = panorama.points_at(static_cast<int>(pixel->x()), static_cast<int>(pixel->y()));
    CHECK(points.size() == 1000);
    CHECK(panorama.source(points.front()) == 999);
}

TEST_CASE("Small holes are closed where both sides agree in range, and have the points of their neighbours") {
    PanoramaOptions options;
    options.projection = small(ProjectionKind::Equirectangular);
    const Projection seen(options.projection);
    const PointBlock holed = room(seen, [](int column, int row) {
        return column % 50 == 7 || (column > 200 && column < 230 && row > 40 && row < 70);
    });
    const Panorama panorama = unroll(holed, options);
    std::size_t empty_small = 0;
    for (int row = 0; row < 100; ++row) empty_small += panorama.points_at(57, row).empty() ? 1U : 0U;
    CHECK(empty_small <= 4);                    // where wall and floor or ceiling meet
    CHECK(panorama.points_at(215, 55).empty()); // larger than what is closed
    options.gaps.most_pixels = 0;
    CHECK(unroll(holed, options).points_at(57, 50).empty());
    // A step in depth stays open.
    PointBlock step;
    step.resize(2, {true, true, false, false});
    const Eigen::Vector3d left = 5.0 * *seen.ray_of({100.5, 50.5});
    const Eigen::Vector3d right = 8.0 * *seen.ray_of({102.5, 50.5});
    step.x = {left.x(), right.x()};
    step.y = {left.y(), right.y()};
    step.z = {left.z(), right.z()};
    options.gaps.most_pixels = 3;
    CHECK(unroll(step, options).filled() == 2);
}

TEST_CASE("Flat ground far away is closed between the rows of the grid, a step behind a wall is not") {
    // Ground 1.7 m below the scanner in rows 0.3° apart: at 30 m the next row is 3 m further. In columns 40 to 59 a
    // wall 12 m away hides what lies below -4°.
    PanoramaOptions options;
    options.projection = small(ProjectionKind::Equirectangular);
    const double degree = std::numbers::pi / 180.0;
    options.projection.elevation_from = -7.0 * degree;
    options.projection.elevation_to = -2.0 * degree; // 0.05° to a pixel
    const auto wall = [](std::uint32_t column) { return column >= 40 && column < 60; };
    PointBlock block;
    for (std::uint32_t row = 0; row < 16; ++row) {
        for (std::uint32_t column = 0; column < 360; ++column) {
            const double elevation = (-2.125 - 0.3 * row) * degree;
            const double azimuth = (179.5 - column) * degree;
            const bool hidden = wall(column) && elevation < -4.0 * degree;
            const double range = hidden ? 12.0 / std::cos(elevation) : 1.7 / -std::sin(elevation);
            block.x.push_back(range * std::cos(elevation) * std::cos(azimuth));
            block.y.push_back(range * std::cos(elevation) * std::sin(azimuth));
            block.z.push_back(range * std::sin(elevation));
            block.validity.push_back(Validity::Valid);
            block.row.push_back(row);
            block.column.push_back(column);
        }
    }
    PanoramaBuilder builder(options, {false, false, true, false});
    builder.add(block);
    const Panorama panorama = builder.finish(Progress::none());
    const auto empty = [&](int column, int from, int to) {
        int count = 0;
        for (int row = from; row < to; ++row) count += panorama.points_at(column, row).empty() ? 1 : 0;
        return count;
    };
    // Rows 2 and 90 of the picture have the outermost rows of the grid.
    CHECK(empty(100, 3, 90) == 0);
    // Between the wall's last row (at -4.225°, row 44) and the ground behind it (-3.925°, row 38).
    CHECK(empty(50, 39, 44) == 5);
    CHECK(empty(50, 45, 90) == 0);
}

TEST_CASE("A sub-pixel shows its place on the surface") {
    PanoramaOptions options;
    options.projection = small(ProjectionKind::Equirectangular);
    const Panorama panorama = unroll(room(Projection(options.projection), [](int, int) { return false; }), options);
    // On the wall x = 5 and on the floor z = -1.5, away from the edges.
    for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(180.3, 40.7), Eigen::Vector2d(170.1, 38.2)}) {
        const auto place = panorama.surface_at(pixel);
        REQUIRE(place);
        CHECK(place->x() == Approx(5.0).margin(0.002));
        CHECK((place->normalized() - *panorama.projection().ray_of(pixel)).norm() < 1e-9);
    }
    const auto floor = panorama.surface_at({180.3, 85.9});
    REQUIRE(floor);
    CHECK(floor->z() == Approx(-1.5).margin(0.002));
    CHECK_FALSE(panorama.surface_at({-1.0, 5.0}));
}

TEST_CASE("Pictures show what the front points are, 0 where there is nothing") {
    PanoramaOptions options;
    options.projection = small(ProjectionKind::Equirectangular);
    const Panorama panorama =
        unroll(room(Projection(options.projection), [](int column, int) { return column < 100; }), options);
    const Picture colour = panorama.picture(Channel::Colour);
    CHECK(colour.values[(50 * 360 + 200) * 3] == 50);
    CHECK(colour.values[(50 * 360 + 50) * 3] == 0);
    const Picture reflectance = panorama.picture(Channel::Reflectance);
    CHECK(reflectance.values[90 * 360 + 200] > reflectance.values[10 * 360 + 200]);
    const Picture normals = panorama.picture(Channel::Normals);
    // Straight at the wall is bright, along the wall is dark.
    CHECK(normals.values[44 * 360 + 180] > 240);
    CHECK(normals.values[44 * 360 + 220] < normals.values[44 * 360 + 180]);
    // Near is bright, and the farthest corner of the room is far from the black of nothing.
    const Picture range = panorama.picture(Channel::Range);
    CHECK(range.values[44 * 360 + 180] > range.values[44 * 360 + 225]);
    CHECK(range.values[44 * 360 + 225] > 30);
    CHECK(range.values[44 * 360 + 50] == 0);
    PanoramaBuilder bare(options, {});
    CHECK_THROWS_WITH(static_cast<void>(bare.finish(Progress::none()).picture(Channel::Colour)),
                      Catch::Contains("no colour"));
}

TEST_CASE("A panorama is written as PNG with its frame beside it, the same bytes every time") {
    const TemporaryFolder folder;
    PanoramaOptions options;
    options.projection = small(ProjectionKind::Pannini);
    const PointBlock block = room(Projection(small(ProjectionKind::Equirectangular)), [](int, int) { return false; });
    const Panorama panorama = unroll(block, options);
    write_panorama(panorama, Channel::Colour, folder / "a.png", "2025-06-01/\"one\"", Eigen::Isometry3d::Identity());
    write_panorama(panorama, Channel::Colour, folder / "b.png", "2025-06-01/\"one\"", Eigen::Isometry3d::Identity());
    const std::string png = bytes_of(folder / "a.png");
    CHECK(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
    CHECK(png.substr(16, 8) == std::string("\0\0\x01\x68\0\0\0\x64", 8)); // 360 × 100
    CHECK(png == bytes_of(folder / "b.png"));
    const std::string json = bytes_of(folder / "a.json");
    CHECK_THAT(json, Catch::Contains("\"projection\": \"pannini\"") && Catch::Contains("\\\"one\\\"") &&
                         Catch::Contains("[1, 0, 0, 0, 0, 1"));
}
