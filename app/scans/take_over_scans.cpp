// SPDX-License-Identifier: MIT
#include "app/scans/take_over_scans.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/scans/days_surface.hpp"
#include "app/scans/scan_stores.hpp"
#include "core/base/error.hpp"

namespace planum::app {

namespace fs = std::filesystem;

namespace {

// Scans by their name in `from`, as they are to stand in `into`.
std::vector<model::Scan> lacking(Project& into, Project& from) {
    std::set<std::pair<std::string, std::int64_t>> there;
    std::set<std::string> names;
    for (const model::Scan& scan : into.record().scans) {
        there.emplace(scan.sha256, scan.cloud);
        names.insert(scan.name);
    }
    std::vector<model::Scan> scans;
    for (model::Scan scan : from.record().scans) {
        if (there.contains({scan.sha256, scan.cloud})) continue;
        if (names.contains(scan.name)) {
            throw Error(ErrorCode::Conflict,
                        fmt::format("the project has another scan {} with other content", scan.name));
        }
        scan.path = path_to_keep(into.path(), original_path(from.path(), scan));
        scans.push_back(std::move(scan));
    }
    return scans;
}

void check_runs(Project& into, Project& from) {
    for (const model::RegistrationRun& run : from.record().runs) {
        for (const model::RegistrationRun& own : into.record().runs) {
            if (own.name == run.name)
                throw Error(ErrorCode::Conflict,
                            fmt::format("the project has a registration run {} already", run.name));
        }
    }
}

// The area of that scan's surface, by its name; nil where `into` has none of that name.
model::AreaId area_of(Project& into, Project& from, const model::Scan& scan) {
    std::string name;
    for (const model::Surface& surface : from.record().surfaces) {
        if (surface.id != scan.surface) continue;
        for (const model::Area& area : from.record().areas) {
            if (area.id == surface.area) name = area.name;
        }
    }
    for (const model::Area& area : into.record().areas) {
        if (!name.empty() && area.name == name) return area.id;
    }
    return {};
}

// A link to the other project's store. None is no harm: see open_store.
void link_store(const fs::path& store, const fs::path& other) {
    std::error_code ignored;
    if (fs::exists(store, ignored)) return;
    fs::create_directories(store.parent_path(), ignored);
    fs::create_hard_link(other, store, ignored);
}

} // namespace

std::size_t take_over_scans(Project& into, Project& from, Progress& progress) {
    progress.check();
    const std::vector<model::Scan> scans = lacking(into, from);
    check_runs(into, from);
    std::vector<model::AreaId> areas;
    for (const model::Scan& scan : scans) areas.push_back(area_of(into, from, scan));
    const std::vector<model::RegistrationRun> runs = from.record().runs;
    const std::vector<model::ScanPose> poses = from.record().poses;
    std::vector<model::Surface> surfaces = into.record().surfaces;
    into.change(fmt::format("Take over {} scans", scans.size()), [&] {
        std::map<model::ScanId, model::ScanId> scan_there;
        std::map<model::RegistrationRunId, model::RegistrationRunId> run_there;
        for (std::size_t i = 0; i < scans.size(); ++i) {
            model::Scan scan = scans[i];
            scan.id = {};
            scan.surface = surface_of_day(into, surfaces, areas[i], scan.day);
            scan_there[scans[i].id] = into.file().insert(scan);
        }
        for (model::RegistrationRun run : runs) {
            const model::RegistrationRunId id = std::exchange(run.id, {});
            run_there[id] = into.file().insert(run);
        }
        for (model::ScanPose pose : poses) {
            const auto scan = scan_there.find(pose.scan);
            const auto run = run_there.find(pose.run);
            if (scan == scan_there.end() || run == run_there.end()) continue;
            pose.scan = scan->second;
            pose.run = run->second;
            into.file().insert(pose);
        }
    });
    for (const model::Scan& scan : scans) link_store(store_path(into.path(), scan), store_path(from.path(), scan));
    return scans.size();
}

} // namespace planum::app
