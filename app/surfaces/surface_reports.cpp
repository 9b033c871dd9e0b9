// SPDX-License-Identifier: MIT
#include "app/surfaces/surface_reports.hpp"

#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>

#include "app/surfaces/height_change.hpp"
#include "app/surfaces/recorded_surface.hpp"
#include "app/surfaces/surface_cache.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "scans/surface/geotiff.hpp"
#include "scans/surface/surface_difference.hpp"

namespace planum::app {

namespace {

HeightsReport report_on(const RecordedSurface& surface, const scans::BuiltSurface& built) {
    const scans::SurfaceGrid& grid = built.grid;
    const double cell_area = grid.frame.cell * grid.frame.cell;
    HeightsReport report;
    report.surface = surface.name;
    report.scans = surface.scans;
    report.raw = surface.raw;
    report.points = built.points;
    for (std::size_t cell = 0; cell < grid.frame.cells(); ++cell) {
        if (grid.state[cell] == scans::CellState::Unseen) continue;
        if (grid.state[cell] == scans::CellState::Face) {
            report.face_area += cell_area;
            continue;
        }
        const auto height = static_cast<double>(grid.height[cell]);
        report.lowest = report.area > 0.0 ? std::min(report.lowest, height) : height;
        report.highest = report.area > 0.0 ? std::max(report.highest, height) : height;
        report.area += cell_area;
    }
    for (const scans::DisputedPatch& patch : built.disputed)
        report.disputed.push_back({patch.x, patch.y, patch.area, patch.difference, patch.lower, patch.higher});
    return report;
}

void refuse_other_endings(const std::filesystem::path& file) {
    const std::string ending = file.extension().string();
    if (file.empty() || ending == ".tif" || ending == ".tiff") return;
    throw Error(ErrorCode::Usage,
                fmt::format("{}: heights are written as GeoTIFF; end the name in .tif", file.string()));
}

void write_raster(Project& project, const scans::GridFrame& frame, std::span<const scans::RasterBand> bands,
                  const std::filesystem::path& file) {
    if (file.empty()) return;
    write_file_atomically(file, scans::geotiff(frame, bands, project.record().settings.srs_id));
    std::filesystem::path world = file;
    write_file_atomically(world.replace_extension(".tfw"), scans::world_file(frame));
}

} // namespace

HeightsReport write_heights(Project& project, std::string_view surface, double cell, const std::filesystem::path& file,
                            Progress& progress) {
    refuse_other_endings(file);
    const model::Record& record = project.record();
    const model::Surface& wanted = known_surface(record, surface);
    const RecordedSurface named = surface_without_heights(record, wanted);
    scans::SurfaceOptions options;
    options.tolerance = record.settings.tolerance;
    // Made afresh: the cache keeps neither where scans disagree nor how many points there are.
    const scans::BuiltSurface built = scans::build_surface(surface_scans(project, wanted.id, progress),
                                                           frame_of_area(record, wanted.area, cell), options, progress);
    write_raster(project, built.grid.frame, std::array{scans::RasterBand{"height", built.grid.height}}, file);
    return report_on(named, built);
}

ChangeReport write_change(Project& project, std::string_view before, std::string_view after, double cell,
                          const std::filesystem::path& file, Progress& progress) {
    refuse_other_endings(file);
    const model::Surface& a = known_surface(project.record(), before);
    const model::Surface& b = known_surface(project.record(), after);
    if (a.area != b.area) {
        throw Error(
            ErrorCode::Usage,
            fmt::format("surfaces {} and {} belong to two areas; only those of one can be compared", before, after));
    }
    const RecordedSurface first = recorded_surface(project, a, cell, progress);
    const RecordedSurface second = recorded_surface(project, b, cell, progress);
    const scans::SurfaceDifference difference =
        scans::surface_difference(first.grid, second.grid, project.record().settings.tolerance);
    write_raster(project, difference.frame,
                 std::array{scans::RasterBand{"change", difference.change},
                            scans::RasterBand{"detectable", difference.detectable}},
                 file);
    ChangeReport report = report_on(difference);
    report.before = first.name;
    report.after = second.name;
    return report;
}

} // namespace planum::app
