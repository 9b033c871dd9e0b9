// SPDX-License-Identifier: MIT
#include "app/surfaces/height_change.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "app/scans/days_surface.hpp"
#include "app/surfaces/recorded_surface.hpp"
#include "core/base/error.hpp"
#include "scans/surface/surface_difference.hpp"

namespace planum::app {

namespace {

const model::Surface& surface_of(const model::Record& record, model::SurfaceId id) {
    const auto found =
        std::find_if(record.surfaces.begin(), record.surfaces.end(), [&](const auto& s) { return s.id == id; });
    if (found == record.surfaces.end()) throw Error(ErrorCode::NotFound, "the surface is no longer in the record");
    return *found;
}

// Points a cell on what was seen. Cells with too few points are no ground, so a thin cloud leaves dense cells here and
// there: it takes twice of what a cell needs on the whole.
bool is_dense(const scans::SurfaceGrid& grid) {
    double points = 0.0;
    double seen = 0.0;
    for (std::size_t cell = 0; cell < grid.frame.cells(); ++cell) {
        if (grid.state[cell] == scans::CellState::Unseen) continue;
        points += grid.count[cell];
        seen += 1.0;
    }
    return points >= 2.0 * kDensePoints * seen;
}

} // namespace

ChangeReport report_on(const scans::SurfaceDifference& difference) {
    ChangeReport report;
    const double cell_area = difference.frame.cell * difference.frame.cell;
    std::vector<float> detectable;
    for (std::size_t cell = 0; cell < difference.frame.cells(); ++cell) {
        if (std::isnan(difference.change[cell])) continue;
        detectable.push_back(difference.detectable[cell]);
        report.compared_area += cell_area;
        if (difference.change[cell] < -difference.detectable[cell]) report.lowered_area += cell_area;
        if (difference.change[cell] > difference.detectable[cell]) report.raised_area += cell_area;
    }
    if (detectable.empty()) return report;
    const auto middle = detectable.begin() + static_cast<std::ptrdiff_t>(detectable.size() / 2);
    std::nth_element(detectable.begin(), middle, detectable.end());
    report.detectable = static_cast<double>(*middle);
    return report;
}

HeightChange height_change(Project& project, model::SurfaceId before, model::SurfaceId after, Progress& progress) {
    const model::Record& record = project.record();
    const model::Surface& first = surface_of(record, before);
    const model::Surface& second = surface_of(record, after);
    if (first.area != second.area) {
        throw Error(ErrorCode::Usage,
                    fmt::format("surfaces {} and {} belong to two areas; only those of one can be compared",
                                surface_name(record, first), surface_name(record, second)));
    }
    scans::SurfaceDifference difference;
    for (const double cell : kComparedCells) {
        const RecordedSurface a = recorded_surface(project, first, cell, progress);
        const RecordedSurface b = recorded_surface(project, second, cell, progress);
        difference = scans::surface_difference(a.grid, b.grid, record.settings.tolerance);
        if (is_dense(a.grid) && is_dense(b.grid)) break;
    }
    HeightChange result;
    const scans::GridFrame& frame = difference.frame;
    result.low_x = static_cast<double>(frame.west) * frame.cell;
    result.low_y = static_cast<double>(frame.south) * frame.cell;
    result.cell = frame.cell;
    result.columns = frame.columns;
    result.rows = frame.rows;
    result.report = report_on(difference);
    result.report.before = surface_name(record, first);
    result.report.after = surface_name(record, second);
    result.change = std::move(difference.change);
    result.detectable = std::move(difference.detectable);
    return result;
}

} // namespace planum::app
