// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <fstream>
#include <string>

#include "app/project/project.hpp"
#include "app/scans/add_scans.hpp"
#include "tests/support/temporary.hpp"

namespace planum::test {

/// A project in `folder` with one scan `2025-06-01/s` of these points (`x y z`, a line each), not registered yet.
inline app::Project project_with_scan(const TemporaryFolder& folder, const std::string& points) {
    std::filesystem::create_directories(folder / "2025-06-01");
    std::ofstream(folder / "2025-06-01/s.xyz") << points;
    app::Project project = app::Project::create(folder / "site.gpkg", {}, {});
    app::add_scans(project, {folder / "2025-06-01"}, {}, Progress::none());
    return project;
}

/// A scanner turned by 90° about the vertical at (100, 200, `height`): x_in_site = (100 − y, 200 + x, height + z).
inline std::array<double, 16> turned_pose(double height) {
    return {0, -1, 0, 100, 1, 0, 0, 200, 0, 0, 1, height, 0, 0, 0, 1};
}

/// Gives all scans of the project one accepted pose, in a run of this name; of several the last name holds.
inline void place_scans(app::Project& project, const std::array<double, 16>& site_from_scan, const char* name = "1") {
    project.change("place", [&] {
        model::RegistrationRun run;
        run.name = name;
        run.made_at = "2025-06-02T10:00:00Z";
        run.state = "accepted";
        run.id = project.file().insert(run);
        for (const model::Scan& scan : project.record().scans) {
            model::ScanPose pose;
            pose.scan = scan.id;
            pose.run = run.id;
            pose.site_from_scan = site_from_scan;
            project.file().insert(pose);
        }
    });
}

} // namespace planum::test
