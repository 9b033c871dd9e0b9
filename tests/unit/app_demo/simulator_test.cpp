// SPDX-License-Identifier: MIT
#include "app/demo/simulator.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include <nlohmann/json.hpp>

#include "app/demo/dig_files.hpp"
#include "app/demo/simulator_random.hpp"
#include "core/base/error.hpp"
#include "core/base/sha256.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;
using namespace planum::app::demo;
namespace fs = std::filesystem;

namespace {

DemoDig dig_of(DemoSize size, model::DigMethod method, std::uint64_t seed = 3) {
    SimulationOptions options;
    options.size = size;
    options.method = method;
    options.seed = seed;
    return simulate(options, Progress::none());
}

std::map<std::string, std::string> hashes(const fs::path& folder) {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file())
            all[fs::relative(entry.path(), folder).generic_string()] = sha256_of_file(entry.path());
    }
    return all;
}

} // namespace

TEST_CASE("The same seed writes the same bytes, in each method") {
    for (const auto method : {model::DigMethod::Stratigraphic, model::DigMethod::Planum, model::DigMethod::Mixed}) {
        const test::TemporaryFolder folder;
        static_cast<void>(write_demo(dig_of(DemoSize::Tiny, method), folder / "a", Progress::none()));
        static_cast<void>(write_demo(dig_of(DemoSize::Tiny, method), folder / "b", Progress::none()));
        const auto first = hashes(folder / "a");
        CHECK(first.size() == 3 * 2 + 3 + 1 + 2 * 9 + 1); // scans, outlines, markers, two sets of tables, truth
        CHECK(first == hashes(folder / "b"));
    }
}

TEST_CASE("Another seed is another dig") {
    const DemoDig a = dig_of(DemoSize::Tiny, model::DigMethod::Stratigraphic, 1);
    const DemoDig b = dig_of(DemoSize::Tiny, model::DigMethod::Stratigraphic, 2);
    CHECK(truth_json(a, {}) != truth_json(b, {}));
}

TEST_CASE("A folder with something in it is refused and left alone") {
    const test::TemporaryFolder folder;
    folder.write("mine.txt", "do not touch");
    CHECK_THROWS_WITH(write_demo(dig_of(DemoSize::Tiny, model::DigMethod::Planum), folder.path(), Progress::none()),
                      Catch::Matchers::Contains("is not empty"));
    CHECK(hashes(folder.path()).size() == 1);
}

TEST_CASE("A dig that is stopped leaves nothing behind") {
    const test::TemporaryFolder folder;
    const DemoDig dig = dig_of(DemoSize::Tiny, model::DigMethod::Mixed);
    std::stop_source source;
    Progress stopped(source.get_token());
    source.request_stop();
    CHECK_THROWS_AS(write_demo(dig, folder / "dig", stopped), Error);
    CHECK_FALSE(fs::exists(folder / "dig"));
}

TEST_CASE("Each size has as many units as it says") {
    CHECK(compose_site(site_shape(DemoSize::Tiny), 5).units().size() == 8);
    CHECK(compose_site(site_shape(DemoSize::Small), 5).units().size() == 12);
    CHECK(compose_site(site_shape(DemoSize::Medium), 5).units().size() == 40);
    CHECK(compose_site(site_shape(DemoSize::Large), 5).units().size() == 300);
}

TEST_CASE("A bell-shaped pit is wider below than at its mouth, which no height field can be") {
    CutShape pit;
    pit.profile = Profile::Bell;
    pit.mouth = 1.0;
    pit.base = 0.0;
    pit.radius = 0.5;
    CHECK_FALSE(pit.contains({0.42, 0.0, 0.98}));
    CHECK(pit.contains({0.42, 0.0, 0.2}));
    const DemoDig dig = dig_of(DemoSize::Small, model::DigMethod::Stratigraphic);
    // Somewhere ground lies above the fill of the pit and the same ground's cut below.
    bool undercut = false;
    for (std::size_t i = 0; i < dig.grid->size() && !undercut; ++i) {
        const auto runs = dig.grid->at(i);
        for (std::size_t k = 1; k < runs.size(); ++k) {
            undercut = undercut || (runs[k].cut > runs[k - 1].unit && runs[k].unit > runs[k - 1].unit);
        }
    }
    CHECK(undercut);
}

TEST_CASE("Scans hit the surface within their noise") {
    const DemoDig dig = dig_of(DemoSize::Tiny, model::DigMethod::Stratigraphic);
    const SurfaceNo surface = 1;
    double sum = 0.0;
    std::size_t count = 0;
    std::size_t inside = 0;
    for (const SimulatedScan& scan : scan_surface(dig, surface, Progress::none())) {
        for (int column = 0; column < scan.image.columns; ++column) {
            for (int row = 0; row < scan.image.rows; ++row) {
                const Return& back = scan.image.returns[static_cast<std::size_t>(column * scan.image.rows + row)];
                if (back.range <= 0.0F || back.mixed) continue;
                const Vec3 direction = scan.image.direction_in_scan(column, row);
                const double error = static_cast<double>(back.range - back.true_range);
                sum += error * error;
                ++count;
                // Just before the hit is air, just behind it is ground.
                const Vec3 before =
                    scan.station.pose.to_site((static_cast<double>(back.true_range) - 0.002) * direction);
                const Vec3 behind =
                    scan.station.pose.to_site((static_cast<double>(back.true_range) + 0.002) * direction);
                if (!dig.site.trench.holds(behind.x, behind.y) || behind.z > dig.site.trench.high.z - 0.3) continue;
                const auto solid = [&](const Vec3& p) {
                    const Body body = dig.formation.body_at(p);
                    return body.unit != kAir && dig.plan.gone_on(dig.formation, body.unit, p) > surface;
                };
                ++inside;
                INFO("column " << column << ", row " << row);
                CHECK(solid(behind));
                CHECK_FALSE(solid(before));
            }
        }
    }
    CHECK(inside > 300);
    CHECK(std::sqrt(sum / static_cast<double>(count)) == Approx(0.002).epsilon(0.05));
}

TEST_CASE("Every station measures five markers and more between 4 and 14 m, to a millimetre") {
    for (const DemoSize size : {DemoSize::Tiny, DemoSize::Small, DemoSize::Medium}) {
        const SiteShape site = site_shape(size);
        const DemoDig dig = dig_of(DemoSize::Tiny, model::DigMethod::Stratigraphic);
        DigPlan plan = dig.plan;
        plan.site = site;
        plan.slump = {};
        const Scene scene = make_scene(site, 3, 1.0);
        const Surroundings around(dig.formation, plan, *dig.grid, *dig.dug, 0, scene);
        for (const Station& station : stations_of(plan, 0)) {
            const auto markers = measure_markers(around, station);
            CHECK(markers.size() >= 5);
            for (const MeasuredMarker& marker : markers) {
                const auto truth = std::find_if(scene.markers.begin(), scene.markers.end(),
                                                [&](const Marker& m) { return m.name == marker.name; });
                const Vec3 off = station.pose.to_site(marker.x_in_scan) - truth->x_in_site;
                CHECK(std::sqrt(dot(off, off)) < 0.006);
                CHECK(std::sqrt(dot(marker.x_in_scan, marker.x_in_scan)) > 3.99);
                CHECK(std::sqrt(dot(marker.x_in_scan, marker.x_in_scan)) < 14.01);
            }
        }
    }
}

TEST_CASE("A gridded PTX has a line for every beam and no pose") {
    const DemoDig dig = dig_of(DemoSize::Tiny, model::DigMethod::Stratigraphic);
    const auto scans = scan_surface(dig, 0, Progress::none());
    std::istringstream text(ptx_text(scans.front().image));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    CHECK(lines[0] == std::to_string(dig.site.scan_columns));
    CHECK(lines[1] == std::to_string(dig.site.scan_rows));
    CHECK(lines[2] == "0 0 0");
    CHECK(lines[9] == "0 0 0 1");
    CHECK(lines.size() == 10 + static_cast<std::size_t>(dig.site.scan_columns * dig.site.scan_rows));
    CHECK(static_cast<double>(scans.front().image.mixed) >= 0.01 * static_cast<double>(scans.front().image.count));
}

TEST_CASE("Outlines are within 3 cm of what they enclose") {
    const DemoDig dig = dig_of(DemoSize::Small, model::DigMethod::Stratigraphic);
    REQUIRE_FALSE(dig.regions.empty());
    for (const DrawnRegion& region : dig.regions) {
        const SurfaceMap& map = dig.maps[static_cast<std::size_t>(region.surface)];
        for (const auto& p : region.outline.outer) {
            // Some cell of the region and some cell that is none within 3 cm and a cell's diagonal.
            const double reach = 0.03 + 1.42 * dig.grid->cell();
            bool mine = false;
            bool other = false;
            for (double dy = -reach; dy <= reach; dy += 0.01) {
                for (double dx = -reach; dx <= reach; dx += 0.01) {
                    if (dx * dx + dy * dy > reach * reach) continue;
                    const auto column =
                        static_cast<std::ptrdiff_t>(std::floor((p[0] + dx - dig.grid->x0()) / dig.grid->cell()));
                    const auto row =
                        static_cast<std::ptrdiff_t>(std::floor((p[1] + dy - dig.grid->y0()) / dig.grid->cell()));
                    const bool off = column < 0 || row < 0 || column >= std::ssize(map) ||
                                     static_cast<std::size_t>(column) >= dig.grid->columns() ||
                                     static_cast<std::size_t>(row) >= dig.grid->rows();
                    const bool same =
                        !off &&
                        map[static_cast<std::size_t>(row) * dig.grid->columns() + static_cast<std::size_t>(column)]
                                .unit == region.unit;
                    mine = mine || same;
                    other = other || !same;
                }
            }
            INFO("surface " << region.surface << ", unit " << region.unit << " at " << p[0] << ' ' << p[1]);
            CHECK(mine);
            if (region.shows != model::RegionShows::Overdug) CHECK((other || region.unit != kAir));
        }
    }
}

TEST_CASE("Truth says poses, order, contacts, volumes and mistakes") {
    const DemoDig dig = dig_of(DemoSize::Small, model::DigMethod::Stratigraphic);
    const auto truth = nlohmann::json::parse(truth_json(dig, {}));
    CHECK(truth.at("units").size() == 12);
    CHECK(truth.at("contacts").size() == dig.contacts.size());
    CHECK(truth.at("mistakes").size() == dig.mistakes.size());
    CHECK(truth.at("special").contains("baulk"));
    CHECK(truth.at("special").contains("half_section"));
    CHECK(truth.at("special").contains("overdug"));
    CHECK(truth.at("special").contains("slump"));
    double total = 0.0;
    for (const auto& entry : truth.at("volumes").at("by_surface")) total += entry.at("volume_m3").get<double>();
    CHECK(truth.at("volumes").at("total_m3").get<double>() == Approx(total).margin(1e-4));
}

TEST_CASE("Truth tells how far the ground sank: never more than was dug so far, and less under overhangs and slumps") {
    const DemoDig dig = dig_of(DemoSize::Small, model::DigMethod::Stratigraphic);
    const auto truth = nlohmann::json::parse(truth_json(dig, {}));
    const auto& days = truth.at("volumes").at("by_surface");
    CHECK_FALSE(days.at(0).contains("from_above_m3"));
    REQUIRE(dig.plan.slump.fell);
    double hidden = 0.0; // dug, but not to be seen from above [m³]
    for (std::size_t day = 1; day < days.size(); ++day) {
        hidden += days.at(day).at("volume_m3").get<double>() - days.at(day).at("from_above_m3").get<double>();
        CAPTURE(day);
        CHECK(hidden > -1e-3);
        if (static_cast<SurfaceNo>(day) == dig.plan.slump.surface) CHECK(hidden > 0.01);
    }
}
