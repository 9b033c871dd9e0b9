// SPDX-License-Identifier: MIT
#include "gui/viewmodels/space_model.hpp"

#include <algorithm>
#include <utility>

#include "gui/viewmodels/region_shapes.hpp"
#include "gui/viewmodels/time_model.hpp"

namespace planum::gui {

SpaceModel::SpaceModel(Workspace& workspace, TimeModel& time, QObject* parent)
    : QObject(parent), workspace_(workspace), time_(time), scans_(std::make_shared<std::vector<app::PlacedScan>>()) {
    connect(&time_, &TimeModel::moved, this, [this] {
        if (!all_) load();
        emit outlinesChanged();
    });
    connect(&workspace_, &Workspace::snapshotChanged, this, [this] {
        load();
        emit outlinesChanged();
    });
    connect(&workspace_, &Workspace::selectionChanged, this, &SpaceModel::outlinesChanged);
    connect(&workspace_, &Workspace::proofChanged, this, &SpaceModel::outlinesChanged);
    connect(&workspace_, &Workspace::closed, this, [this] {
        scans_ = std::make_shared<std::vector<app::PlacedScan>>();
        trouble_.clear();
        stale_ = true;
        emit loaded();
        emit outlinesChanged();
    });
}

void SpaceModel::set_watched(bool watched) {
    watched_ = watched;
    if (watched_ && stale_) load();
}

void SpaceModel::set_all_surfaces(bool all) {
    if (all == all_) return;
    all_ = all;
    load();
}

void SpaceModel::load() {
    stale_ = true;
    if (!watched_ || !workspace_.is_open()) return;
    stale_ = false;
    loading_ = true;
    trouble_.clear();
    workspace_.read(
        QStringLiteral("3d"), tr("Opening the points"),
        [this, surface = time_.surface(), all = all_](app::Project& project, Progress& progress) -> JobRunner::Done {
            auto scans = std::make_shared<const std::vector<app::PlacedScan>>(app::placed_scans(
                project, [&](const model::Scan& scan) { return all || scan.surface == surface; }, progress));
            return [this, scans] {
                loading_ = false;
                const bool same =
                    scans->size() == scans_->size() &&
                    std::equal(scans->begin(), scans->end(), scans_->begin(), [](const auto& a, const auto& b) {
                        return a.scan.id == b.scan.id && a.site_from_scan == b.site_from_scan;
                    });
                if (same) return; // an edit of the record moves no point
                scans_ = scans;
                emit loaded();
            };
        },
        [this](const QString& sentence) {
            loading_ = false;
            trouble_ = sentence;
            emit loaded();
        });
}

std::vector<SpaceModel::Outline> SpaceModel::outlines() const {
    std::vector<Outline> outlines;
    if (!workspace_.is_open()) return outlines;
    for (const model::Region& region : workspace_.snapshot()->record().regions) {
        if (region.surface != time_.surface() && region.section.is_nil()) continue;
        if (!region.has_heights) continue;
        for (const model::Polygon& polygon : region.outline) outlines.push_back({region.unit, polygon.outer});
    }
    return outlines;
}

model::SurfaceId SpaceModel::surface() const { return time_.surface(); }

model::UnitId SpaceModel::unit_at(double x, double y) const {
    if (!workspace_.is_open() || time_.surface().is_nil()) return {};
    const auto shapes = regions_in_plan(*workspace_.snapshot(), time_.surface());
    const RegionShape* shape = region_under(shapes, {x, y});
    return shape == nullptr ? model::UnitId{} : shape->unit;
}

} // namespace planum::gui
