// SPDX-License-Identifier: MIT
#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "scans/surface/surface_builder.hpp"
#include "scans/surface/surface_difference.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/read_scan.hpp"
#include "tests/support/real_data.hpp"

using namespace planum;
using namespace planum::scans;

namespace {

struct CorePoint {
    double x = 0.0;
    double y = 0.0;
    double distance = 0.0;    // along the normal [m]
    double uncertainty = 0.0; // 95 % [m]
    double up = 0.0;          // of the normal
};

/// What CloudCompare found; the first line names the columns.
std::vector<CorePoint> core_points(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    std::vector<CorePoint> all;
    while (std::getline(in, line)) {
        std::istringstream fields(line);
        std::vector<double> v;
        for (std::string field; std::getline(fields, field, ',');) v.push_back(std::stod(field));
        if (v.size() == 28) all.push_back({v[0], v[1], v[24], v[23], v[27]});
    }
    return all;
}

/// The ground about a core point, with that in the middle of the middle cell: both programs judge the same place.
SurfaceGrid ground_about(const CorePoint& core, const PointBlock& points, double cell) {
    constexpr int kAside = 3; // cells beside the middle one, for the slope
    PointBlock moved = points;
    for (auto& x : moved.x) x -= core.x - 0.5 * cell;
    for (auto& y : moved.y) y -= core.y - 0.5 * cell;
    SurfaceScan scan;
    scan.name = "flight";
    scan.points = std::make_shared<BlockPoints>(std::move(moved));
    SurfaceOptions options;
    options.remove_passing = false; // flown: no station in front of which somebody stood
    return build_surface(std::vector{scan}, {-kAside, -kAside, 2 * kAside + 1, 2 * kAside + 1, cell}, options,
                         Progress::none())
        .grid;
}

} // namespace

TEST_CASE("Change of heights agrees with that of CloudCompare's M3C2 within both levels of detection") {
    const auto folder = test::real_data("scans/m3c2");
    if (!folder) return;
    const std::vector<CorePoint> cores = core_points(*folder / "autzen-bmx-cc.txt");
    REQUIRE(cores.size() == 103);
    const auto before = test::read_whole(*test::open_file(*folder / "autzen-bmx-2010.las")).points;
    const auto after = test::read_whole(*test::open_file(*folder / "autzen-bmx-2023.las")).points;
    // As much ground as the cylinders cover, by the points that are in them.
    constexpr double kCell = 4.0;
    int compared = 0;
    int agree = 0;
    for (const CorePoint& core : cores) {
        if (std::isnan(core.distance) || core.up < 0.87) continue; // heights say little of ground steeper than 30°
        const SurfaceDifference difference =
            surface_difference(ground_about(core, before, kCell), ground_about(core, after, kCell), 0.0);
        const std::size_t middle = difference.frame.cells() / 2;
        if (std::isnan(difference.change[middle])) continue;
        ++compared;
        const double ours = static_cast<double>(difference.change[middle]) * core.up;
        const double allowed = std::hypot(static_cast<double>(difference.detectable[middle]), core.uncertainty);
        if (std::abs(ours - core.distance) <= allowed) ++agree;
    }
    INFO(agree << " of " << compared);
    CHECK(compared >= 40);
    CHECK(agree >= 0.95 * compared);
}
