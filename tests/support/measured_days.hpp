// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include "app/project/project.hpp"
#include "app/records/record_kind.hpp"
#include "app/regions/outline_text.hpp"
#include "app/regions/region_import.hpp"
#include "app/scans/add_scans.hpp"
#include "tests/support/placed_scan.hpp"
#include "tests/support/temporary.hpp"

namespace planum::test {

/// Writes into `file` a project with two scanned and outlined days: a floor of 2 × 1 m whose western half was covered
/// by unit 1, 12 cm thick, on the first day and shows unit 2 on the second; unit 3 is the other half on both.
inline app::Project make_measured_days(const TemporaryFolder& folder, const std::filesystem::path& file) {
    const auto write_day = [&](const char* day, double height_in_west) {
        std::filesystem::create_directories(folder / day);
        std::ofstream out(folder / day / "s.xyz");
        for (int x = 0; x < 200; ++x) {
            for (int y = 0; y < 100; ++y)
                out << fmt::format("{:.3f} {:.3f} {}\n", 0.01 * x + 0.005, 0.01 * y + 0.005,
                                   x < 100 ? height_in_west : 5.0);
        }
    };
    const auto drawn = [](const char* unit, const char* day, const char* corners) {
        app::DrawnOutline outline;
        outline.unit = unit;
        outline.day = day;
        outline.shape = app::parse_outline(corners);
        return outline;
    };
    constexpr const char* kWest = "0 0, 1 0, 1 1, 0 1";
    constexpr const char* kEast = "1 0, 2 0, 2 1, 1 1";
    write_day("2025-06-01", 5.12);
    write_day("2025-06-02", 5.0);
    app::Project project = app::Project::create(file, {}, {"Ada"});
    for (const char* unit : {"1", "2", "3"}) app::record_kind("unit").add(project, unit, {{"kind", "layer"}});
    app::add_scans(project, {folder / "2025-06-01", folder / "2025-06-02"}, {}, Progress::none());
    app::import_outlines(project,
                         {{drawn("1", "2025-06-01", kWest), drawn("3", "2025-06-01", kEast),
                           drawn("2", "2025-06-02", kWest), drawn("3", "2025-06-02", kEast)},
                          {}},
                         {});
    place_scans(project, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    return project;
}

} // namespace planum::test
