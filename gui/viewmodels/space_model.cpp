// SPDX-License-Identifier: MIT
#include "gui/viewmodels/space_model.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "gui/viewmodels/region_shapes.hpp"
#include "gui/viewmodels/time_model.hpp"

namespace planum::gui {

SpaceModel::SpaceModel(Workspace& workspace, TimeModel& time, QObject* parent)
    : QObject(parent), workspace_(workspace), time_(time), contents_(workspace, time),
      scans_(std::make_shared<std::vector<app::PlacedScan>>()) {
    connect(&contents_, &SpaceContents::scansChanged, this, &SpaceModel::load);
    connect(&contents_, &SpaceContents::outlinesChanged, this, &SpaceModel::outlinesChanged);
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

void SpaceModel::load() {
    stale_ = true;
    if (!watched_ || !workspace_.is_open()) return;
    stale_ = false;
    loading_ = true;
    trouble_.clear();
    std::vector<model::ScanId> shown;
    for (const model::Scan& scan : workspace_.snapshot()->record().scans) {
        if (contents_.shows(scan)) shown.push_back(scan.id);
    }
    std::sort(shown.begin(), shown.end());
    workspace_.read(
        QStringLiteral("3d"), tr("Opening the points"),
        [this, shown](app::Project& project, Progress& progress) -> JobRunner::Done {
            auto scans = std::make_shared<const std::vector<app::PlacedScan>>(app::placed_scans(
                project,
                [&](const model::Scan& scan) { return std::binary_search(shown.begin(), shown.end(), scan.id); },
                progress));
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
            stale_ = true;
            scans_ =
                std::make_shared<std::vector<app::PlacedScan>>(); // those of another day would be shown as this one's
            emit loaded();
        });
}

std::vector<SpaceModel::Outline> SpaceModel::outlines() const {
    std::vector<Outline> outlines;
    if (!workspace_.is_open()) return outlines;
    for (const model::Region& region : workspace_.snapshot()->record().regions) {
        if (!contents_.shows(region)) continue;
        for (const model::Polygon& polygon : region.outline) outlines.push_back({region.unit, polygon.outer});
    }
    return outlines;
}

std::size_t SpaceModel::place_of_day(const std::string& day) const {
    std::set<std::string> days;
    if (workspace_.is_open()) {
        for (const model::Scan& scan : workspace_.snapshot()->record().scans) days.insert(scan.day);
    }
    return static_cast<std::size_t>(std::distance(days.begin(), days.lower_bound(day)));
}

model::SurfaceId SpaceModel::surface() const { return time_.surface(); }

model::UnitId SpaceModel::unit_at(double x, double y) const {
    if (!workspace_.is_open() || time_.surface().is_nil()) return {};
    const auto shapes = regions_in_plan(*workspace_.snapshot(), time_.surface());
    const RegionShape* shape = region_under(shapes, {x, y});
    return shape == nullptr ? model::UnitId{} : shape->unit;
}

} // namespace planum::gui
