// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <fstream>
#include <regex>
#include <sstream>

#include "core/base/error.hpp"
#include "scans/surface/surface_builder.hpp"
#include "scans/surface/surface_difference.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/read_scan.hpp"
#include "tests/support/real_data.hpp"

using namespace planum;
using namespace planum::scans;

namespace {

geometry::Rigid3 read_pose(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::array<double, 16> numbers{};
    for (double& number : numbers) in >> number;
    return geometry::from_row_major(numbers);
}

std::vector<SurfaceScan> scans_of_day(const std::filesystem::path& folder) {
    std::vector<SurfaceScan> scans;
    for (const char* station : {"station0", "station1", "station2"}) {
        const geometry::Rigid3 pose = read_pose(folder / (std::string(station) + ".true_site_from_scan.txt"));
        const auto reader = test::open_file(folder / (std::string(station) + ".ptx"));
        PointBlock points = test::read_whole(*reader).points;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Eigen::Vector3d x = pose * Eigen::Vector3d(points.x[i], points.y[i], points.z[i]);
            points.x[i] = x.x();
            points.y[i] = x.y();
            points.z[i] = x.z();
        }
        SurfaceScan scan;
        scan.name = station;
        scan.points = std::make_shared<BlockPoints>(std::move(points));
        scan.station = pose.translation;
        scans.push_back(scan);
    }
    return scans;
}

/// Numbers of the lines "DAY -> DAY: net removed A m3 (west half B, east half C)".
std::vector<std::array<double, 3>> true_volumes(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::vector<std::array<double, 3>> all;
    const std::regex numbers(R"(net removed ([\d.]+) m3 \(west half ([\d.]+), east half ([\d.]+)\))");
    for (std::string line; std::getline(in, line);) {
        std::smatch found;
        if (std::regex_search(line, found, numbers))
            all.push_back({std::stod(found[1]), std::stod(found[2]), std::stod(found[3])});
    }
    return all;
}

} // namespace

TEST_CASE("The volumes of the three days in the trench are right within 1 %") {
    const auto trench = test::real_data("scans/trench");
    if (!trench) return;
    const std::vector<std::array<double, 3>> truth = true_volumes(*trench / "TRUE_VOLUMES.txt");
    REQUIRE(truth.size() == 2);
    const GridFrame frame = frame_around({-3.4, -2.4, 3.4, 2.4}, 0.02);
    std::vector<std::int32_t> half(frame.cells());
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column)
            half[frame.at(row, column)] = frame.x(column) < 0.0 ? 0 : 1;
    }
    std::vector<SurfaceGrid> days;
    for (const char* day : {"2012-05-01", "2012-05-02", "2012-05-03"}) {
        BuiltSurface built = build_surface(scans_of_day(*trench / day), frame, {}, Progress::none());
        CHECK(built.disputed.empty());
        days.push_back(std::move(built.grid));
    }
    for (std::size_t day = 0; day < 2; ++day) {
        const DugVolume total = dug_volumes(days[day], days[day + 1], {}, 1)[0];
        const std::vector<DugVolume> halves = dug_volumes(days[day], days[day + 1], half, 2);
        CHECK(total.net == Approx(truth[day][0]).epsilon(0.01));
        for (std::size_t i = 0; i < 2; ++i) {
            const double true_half = truth[day][i + 1];
            // A hundredth of the smallest, 0.26 m³, would be 0.2 mm over its 16 m², a tenth of the scanner's noise.
            const double allowed = true_half > 1.0 ? 0.01 * true_half : halves[i].bound();
            CHECK(std::abs(halves[i].net - true_half) < allowed);
        }
        CHECK(std::abs(total.net - truth[day][0]) < total.bound());
        CHECK(total.bound() <= std::max(0.05, 0.05 * total.net));
    }
}
