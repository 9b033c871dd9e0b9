// SPDX-License-Identifier: MIT
#include "gui/viewmodels/time_model.hpp"

#include <algorithm>

#include "app/scans/days_surface.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

TimeModel::TimeModel(Workspace& workspace, QObject* parent) : QObject(parent), workspace_(workspace) {
    connect(&workspace_, &Workspace::snapshotChanged, this, &TimeModel::refresh);
    connect(&workspace_, &Workspace::closed, this, &TimeModel::refresh);
    // A unit selected elsewhere is looked up where it was last seen.
    connect(&workspace_, &Workspace::selectionChanged, this, [this] {
        if (!workspace_.is_open() || workspace_.selected().is_nil()) return;
        const model::Record& record = workspace_.snapshot()->record();
        model::SurfaceId seen;
        for (const Stop& stop : stops_) {
            for (const model::Region& region : record.regions) {
                if (region.surface != stop.surface || region.unit != workspace_.selected()) continue;
                if (stop.surface == surface()) return;
                seen = stop.surface;
            }
        }
        if (!seen.is_nil()) go_to(seen);
    });
}

model::SurfaceId TimeModel::surface() const noexcept {
    return current_ < 0 ? model::SurfaceId{} : stops_[static_cast<std::size_t>(current_)].surface;
}

void TimeModel::refresh() {
    const model::SurfaceId before = surface();
    const bool at_end = current_ + 1 == static_cast<int>(stops_.size());
    stops_.clear();
    if (workspace_.is_open()) {
        const model::Record& record = workspace_.snapshot()->record();
        for (const model::Surface& surface : record.surfaces) {
            Stop stop;
            stop.surface = surface.id;
            stop.name = qt(app::surface_name(record, surface));
            stop.day = qt(surface.first_day);
            if (!surface.last_day.empty() && surface.last_day != surface.first_day) {
                stop.day += QStringLiteral(" – ") + qt(surface.last_day);
            }
            stop.scans = static_cast<int>(std::count_if(record.scans.begin(), record.scans.end(),
                                                        [&](const auto& s) { return s.surface == surface.id; }));
            stop.regions = static_cast<int>(std::count_if(record.regions.begin(), record.regions.end(),
                                                          [&](const auto& r) { return r.surface == surface.id; }));
            stop.detail = tr("%1 scans, %2 outlines").arg(stop.scans).arg(stop.regions);
            stops_.push_back(std::move(stop));
        }
    }
    current_ = static_cast<int>(stops_.size()) - 1; // the last one is what lies open today
    for (std::size_t i = 0; i < stops_.size() && !at_end; ++i) {
        if (stops_[i].surface == before) current_ = static_cast<int>(i);
    }
    emit changed();
    if (surface() != before) emit moved();
}

void TimeModel::go_to(int stop) {
    if (stop < 0 || stop >= static_cast<int>(stops_.size()) || stop == current_) return;
    current_ = stop;
    emit moved();
}

void TimeModel::go_to(model::SurfaceId surface) {
    for (std::size_t i = 0; i < stops_.size(); ++i) {
        if (stops_[i].surface == surface) return go_to(static_cast<int>(i));
    }
}

} // namespace planum::gui
