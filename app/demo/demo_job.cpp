// SPDX-License-Identifier: MIT
#include "app/demo/demo_job.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "app/checks/daily_check.hpp"
#include "app/drawing/draw_matrix.hpp"
#include "app/import/import_service.hpp"
#include "app/regions/region_import.hpp"
#include "app/registration/import_markers.hpp"
#include "app/registration/register_scans.hpp"
#include "app/reports/report.hpp"
#include "app/scans/add_scans.hpp"
#include "app/scans/days_surface.hpp"
#include "app/scans/list_scans.hpp"
#include "app/scans/panorama_file.hpp"
#include "app/scans/take_over_scans.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/whole_progress.hpp"
#include "strat/layout/svg_writer.hpp"

namespace planum::app {

namespace {

namespace fs = std::filesystem;

Project project_of(const fs::path& file, const fs::path& sheets, model::DigMethod method, const Session& session,
                   Progress& progress) {
    model::ProjectSettings settings;
    settings.name = "Sample dig";
    settings.method = method;
    Project project = Project::create(file, settings, session);
    import_files(project, {sheets}, {}, progress);
    return project;
}

std::vector<fs::path> day_folders(const fs::path& folder) {
    std::vector<fs::path> days;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.is_directory() && is_day(entry.path().filename().string())) days.push_back(entry.path());
    }
    return days;
}

std::size_t register_all(Project& project, Progress& progress) {
    const RegistrationReport report = register_scans(project, {}, progress);
    return static_cast<std::size_t>(
        std::count_if(report.scans.begin(), report.scans.end(),
                      [](const ReportedScan& scan) { return scan.status == "registered"; }));
}

// What the draughtsman drew, day by day.
std::size_t import_outlines_of(Project& project, const fs::path& folder, Progress& progress) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder / "outlines")) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return import_outline_files(project, files, {}, progress).fresh.size();
}

// One scan of the last day, unrolled: there most lies bare.
fs::path write_panorama_of(Project& project, const fs::path& folder, Progress& progress) {
    const std::vector<ListedScan> scans = list_scans(project);
    fs::path file = folder / "panorama.png";
    write_scan_panorama(project, scans.back().scan, file, {}, progress);
    return file;
}

/// When each part of the work is through, as a share of all of it; measured, to tell the time left.
struct DemoShares {
    double simulated = 0.06;
    double written = 0.82;
    double sheets = 0.825;
    double scans_added = 0.97;
    double registered = 0.97;
    double checked = 0.985;
};

DemoShares shares_of(demo::DemoSize size) {
    if (size == demo::DemoSize::Small) return {0.02, 0.06, 0.06, 0.08, 0.96, 0.98}; // registration takes most of it
    return {};
}

// Where the folder will be made: the deepest of its parents that is there.
std::uintmax_t room_for(const fs::path& folder) {
    fs::path there = fs::absolute(folder);
    while (there.has_relative_path() && !fs::exists(there)) there = there.parent_path();
    std::error_code unknown;
    const std::uintmax_t available = fs::space(there, unknown).available;
    return unknown ? std::numeric_limits<std::uintmax_t>::max() : available; // then writing will tell
}

} // namespace

void require_room_for_demo(demo::DemoSize size, std::uintmax_t available) {
    constexpr std::uintmax_t kMegabyte = 1'000'000;
    // Measured over the three methods (small 70 MB, medium 420 MB, large 11 GB), with a tenth to spare.
    std::uintmax_t need = 100 * kMegabyte;
    if (size == demo::DemoSize::Medium) need = 600 * kMegabyte;
    if (size == demo::DemoSize::Large) need = 12'000 * kMegabyte;
    if (available >= need) return;
    throw Error(
        ErrorCode::Io,
        fmt::format("a sample dig of this size needs about {} MB and the disk has {} MB free; nothing was made. "
                    "Free some space, choose another folder or a smaller --size",
                    need / kMegabyte, available / kMegabyte));
}

DemoJob run_demo_job(const fs::path& folder, const demo::SimulationOptions& options, const Session& session,
                     const strat::TextMeasure& measure, Progress& outer) {
    require_room_for_demo(options.size, room_for(folder));
    DemoJob job;
    WholeProgress progress(outer, "making the sample dig " + folder.filename().string());
    const DemoShares shares = shares_of(options.size);
    {
        progress.part(shares.simulated, 5);
        const demo::DemoDig dig = demo::simulate(options, progress);
        progress.part(shares.written, 1 + dig.plan.surfaces * dig.site.stations);
        job.points = demo::write_demo(dig, folder, progress).points;
        job.scans = static_cast<std::size_t>(dig.plan.surfaces * dig.site.stations);
        job.mistakes = dig.mistakes.size();
    }
    progress.part(shares.sheets, 6);
    progress.step("importing the sheets");
    job.project = folder / "demo.gpkg";
    Project project = project_of(job.project, folder / "record", options.method, session, progress);
    job.units = project.record().units.size();
    progress.part(shares.scans_added);
    add_scans(project, day_folders(folder), {}, progress);
    progress.part(shares.registered);
    import_markers(project, folder / "markers.csv", {});
    if (options.size <= demo::DemoSize::Small) job.registered = register_all(project, progress);
    progress.part(shares.checked, 12);
    progress.step("taking the outlines in");
    job.regions = import_outlines_of(project, folder, progress);
    const DailyCheck check = check_project(project, {}, progress);
    job.errors = check.count(model::Severity::Error);
    job.warnings = check.count(model::Severity::Warning);

    job.mistaken_project = folder / "with-mistakes.gpkg";
    Project mistaken = project_of(job.mistaken_project, folder / "with-mistakes", options.method, session, progress);
    // The scans are the same; only what stands on the sheets is wrong.
    take_over_scans(mistaken, project, progress);
    import_outlines_of(mistaken, folder, progress);
    const DailyCheck found = check_project(mistaken, {}, progress);
    job.errors_mistaken = found.count(model::Severity::Error);
    job.warnings_mistaken = found.count(model::Severity::Warning);

    progress.part(1.0, 6);
    progress.step("drawing and reporting");
    job.drawings = {folder / "matrix.svg", folder / "report.html", folder / "report.xml"};
    DrawRequest request;
    request.titles = true;
    write_file_atomically(job.drawings[0], strat::write_svg(draw_matrix(project, request, measure, progress)));
    write_report(project, job.drawings[1], ReportRequest{}, measure, progress);
    write_report(project, job.drawings[2], ReportRequest{}, measure, progress);
    job.drawings.push_back(write_panorama_of(project, folder, progress));
    return job;
}

} // namespace planum::app
