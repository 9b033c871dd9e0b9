// SPDX-License-Identifier: MIT
#include "app/regions/pixel_outlines.hpp"

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "app/regions/outline_text.hpp"
#include "app/regions/region_import.hpp"
#include "app/regions/region_list.hpp"
#include "core/base/error.hpp"
#include "core/geometry/polygon_overlay.hpp"
#include "core/geometry/polygons.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/placed_scan.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;

namespace {

constexpr double kBelow = 1.6; ///< so far the floor lies below the scanner [m]

scans::ProjectionOptions whole_picture() {
    scans::ProjectionOptions options;
    options.width = 1800;
    options.height = 500;
    return options;
}

// A sloping floor, a point every 2 cm from 1 to 5 m.
std::string a_floor() {
    std::string text;
    for (int i = -250; i <= 250; ++i) {
        for (int j = -250; j <= 250; ++j) {
            const double x = 0.02 * i;
            const double y = 0.02 * j;
            const double r = std::hypot(x, y);
            if (r > 1.0 && r < 5.0) text += fmt::format("{:.3f} {:.3f} {:.4f}\n", x, y, -kBelow + 0.1 * x);
        }
    }
    return text;
}

// The pixels of a polygon of the floor: what is straight there is not in the picture, so many are needed.
std::string pixels_of(const geometry::Line3& ring) {
    const scans::Projection projection(whole_picture());
    std::string text;
    for (std::size_t i = 0; i < 20 * ring.size(); ++i) {
        const auto& a = ring[i / 20];
        const auto& b = ring[(i / 20 + 1) % ring.size()];
        const double share = static_cast<double>(i % 20) / 20.0;
        const geometry::Point3 p = {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), 0.0};
        const auto pixel = projection.pixel_of({p[0], p[1], -kBelow + 0.1 * p[0]});
        REQUIRE(pixel);
        text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", pixel->x(), pixel->y());
    }
    return text;
}

std::string file_of(const std::string& polygons) {
    return fmt::format(R"({{"scan": "2025-06-01/s", "projection": "equirectangular", "width": 1800, "height": 500,
        "azimuth_left_deg": 180, "azimuth_right_deg": -180, "elevation_top_deg": 45, "elevation_bottom_deg": -60,
        "polygons": [{}]}})",
                       polygons);
}

} // namespace

TEST_CASE("A polygon of a panorama comes to lie where its pixels lie on the ground") {
    const test::TemporaryFolder folder;
    app::Project project = test::project_with_scan(folder, a_floor());
    const geometry::Line3 outer = {{2, -1, 0}, {4, -1.2, 0}, {4, 1, 0}, {3, 1.5, 0}, {2, 1, 0}};
    const geometry::Line3 hole = {{2.5, 0, 0}, {3, 0, 0}, {3, 0.5, 0}};
    const std::string good =
        fmt::format(R"({{"category": "spoil", "rings": [[{}], [{}]]}})", pixels_of(outer), pixels_of(hole));
    const std::string sky = R"({"category": "water", "rings": [[[10, 10], [40, 10], [20, 40]]]})";
    const auto file = folder.write("drawn.json", file_of(good + ", " + sky));
    CHECK_THROWS_AS(app::import_outline_files(project, {file}, {}, Progress::none()), Error); // not registered yet
    test::place_scans(project, test::turned_pose(50.0));
    const auto report = app::import_outline_files(project, {file}, {}, Progress::none());
    CHECK(report.fresh == std::vector<std::string>{"2025-06-01/spoil#1"});
    REQUIRE(report.notes.size() == 1);
    CHECK(report.notes[0].message == "the corner at pixel 10 10 shows nothing");
    CHECK(report.surfaces.empty()); // that of the scan
    const auto& region = project.record().regions.front();
    CHECK(region.drawn_on == "panorama");
    geometry::MultiPolygon wanted = {{outer, hole}};
    for (auto& ring : wanted[0]) {
        for (auto& p : ring) p = {100.0 - p[1], 200.0 + p[0], 50.0 - kBelow + 0.1 * p[0]};
    }
    const auto shape = app::shape_of(region.outline);
    CHECK(geometry::area(shape) == Approx(geometry::area(wanted)).epsilon(0.01));
    for (const auto& ring : shape[0]) {
        for (const auto& p : ring) {
            CHECK(geometry::distance_to_outline(wanted, p[0], p[1]) < 0.02);
            CHECK(p[2] == Approx(50.0 - kBelow + 0.1 * (p[1] - 200.0)).margin(0.01));
        }
    }
}

TEST_CASE("Pixel outlines say what they lack") {
    const auto said = [](const std::string& text) -> std::string {
        try {
            (void)app::read_pixel_outlines(text);
        } catch (const Error& e) {
            return e.what();
        }
        return {};
    };
    CHECK(said(R"({"polygons": []})").find("names no scan") != std::string::npos);
    CHECK(said(R"({"scan": "s", "polygons": []})").find("projection") != std::string::npos);
    CHECK(said(R"({"scan": "s", "projection": "mercator", "polygons": []})").find("size") != std::string::npos);
    const auto read =
        app::read_pixel_outlines(file_of(R"({"unit": 5}, {"unit": 6, "rings": [[[1, 2], [3, 4], [5, 1]]]})"));
    REQUIRE(read.size() == 1);
    CHECK(read[0].notes.size() == 1);
    REQUIRE(read[0].outlines.size() == 1);
    CHECK(read[0].outlines[0].unit == "6");
}
