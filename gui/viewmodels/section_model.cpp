// SPDX-License-Identifier: MIT
#include "gui/viewmodels/section_model.hpp"

#include <algorithm>
#include <utility>

#include "app/surfaces/section_sheet.hpp"
#include "core/geometry/polygons.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

namespace {

constexpr double kBeyond = 0.5;        // [m] that a cut reaches beyond the outlines
constexpr double kAroundStation = 3.0; // [m]

// A run that is accepted or discarded moves scans without a change of any pose.
std::vector<model::ScanPose> poses_in_force(const model::Record& record) {
    std::vector<model::ScanPose> poses;
    for (const model::Scan& scan : record.scans)
        if (const model::ScanPose* pose = model::pose_in_force(record, scan.id); pose != nullptr)
            poses.push_back(*pose);
    return poses;
}

} // namespace

std::vector<model::Section> middle_cuts(const model::Record& record) {
    geometry::Extent extent;
    for (const model::Region& region : record.regions) {
        if (region.surface.is_nil()) continue;
        for (const model::Polygon& polygon : region.outline) {
            for (const auto& p : polygon.outer) extent.add(p[0], p[1]);
        }
    }
    double beyond = kBeyond;
    if (extent.is_empty()) {
        for (const model::Scan& scan : record.scans) {
            const model::ScanPose* pose = model::pose_in_force(record, scan.id);
            if (pose != nullptr) extent.add(pose->site_from_scan[3], pose->site_from_scan[7]);
        }
        beyond = kAroundStation;
    }
    if (extent.is_empty()) return {};
    const std::array<double, 2> middle = {(extent.low[0] + extent.high[0]) / 2.0,
                                          (extent.low[1] + extent.high[1]) / 2.0};
    model::Section east;
    east.from_in_site = {extent.low[0] - beyond, middle[1]};
    east.to_in_site = {extent.high[0] + beyond, middle[1]};
    model::Section north;
    north.from_in_site = {middle[0], extent.low[1] - beyond};
    north.to_in_site = {middle[0], extent.high[1] + beyond};
    return {east, north};
}

SectionModel::SectionModel(Workspace& workspace, QObject* parent) : QObject(parent), workspace_(workspace) {
    connect(&workspace_, &Workspace::snapshotChanged, this, &SectionModel::refresh);
    connect(&workspace_, &Workspace::closed, this, [this] {
        choices_.clear();
        chosen_ = -1;
        laid_.reset();
        sheet_.reset();
        seen_.reset();
        looking_ = false;
        emit changed();
    });
    refresh();
}

void SectionModel::set_watched(bool watched) {
    watched_ = watched;
    look();
}

void SectionModel::refresh() {
    if (!workspace_.is_open()) return;
    const QString before = chosen_ < 0 ? QString() : choices_[static_cast<std::size_t>(chosen_)].name;
    const model::Record& record = workspace_.snapshot()->record();
    choices_.clear();
    for (const model::Section& section : record.sections) choices_.push_back({qt(section.name), section});
    const std::vector<model::Section> cuts = middle_cuts(record);
    if (cuts.size() == 2) {
        choices_.push_back({tr("Cut, west to east"), cuts[0]});
        choices_.push_back({tr("Cut, south to north"), cuts[1]});
    }
    if (laid_) choices_.push_back(*laid_);
    chosen_ = choices_.empty() ? -1 : 0;
    for (std::size_t i = 0; i < choices_.size(); ++i) {
        if (choices_[i].name == before) chosen_ = static_cast<int>(i);
    }
    look();
    emit changed();
}

void SectionModel::choose(int choice) {
    if (choice < 0 || choice >= static_cast<int>(choices_.size()) || choice == chosen_) return;
    chosen_ = choice;
    look();
    emit changed();
}

void SectionModel::show_cut(const model::Section& cut, double depth) {
    if (!workspace_.is_open()) return;
    laid_ = Choice{tr("Cut, laid in 3D"), cut, depth};
    refresh();
    choose(static_cast<int>(choices_.size()) - 1);
}

std::optional<model::Section> SectionModel::section() const {
    if (chosen_ < 0) return std::nullopt;
    return choices_[static_cast<std::size_t>(chosen_)].section;
}

std::vector<SectionModel::Line> SectionModel::lines_in_plan() const {
    std::vector<Line> lines;
    for (std::size_t i = 0; i < choices_.size(); ++i) {
        const model::Section& section = choices_[i].section;
        const bool chosen = static_cast<int>(i) == chosen_;
        if (section.id.is_nil() && !chosen) continue; // nobody asked for it
        lines.push_back({{section.from_in_site[0], section.from_in_site[1]},
                         {section.to_in_site[0], section.to_in_site[1]},
                         choices_[i].name,
                         chosen});
    }
    return lines;
}

void SectionModel::look() {
    const auto wanted = section();
    if (!watched_ || !wanted) return;
    std::vector<model::ScanPose> poses = poses_in_force(workspace_.snapshot()->record());
    const double depth = choices_[static_cast<std::size_t>(chosen_)].depth;
    if (seen_ == wanted && seen_depth_ == depth && seen_from_ == poses) return;
    seen_depth_ = depth;
    seen_ = wanted;
    seen_from_ = std::move(poses);
    sheet_.reset();
    looking_ = !seen_from_.empty();
    if (!looking_) return;
    app::SectionRequest request;
    request.from = wanted->from_in_site;
    request.to = wanted->to_in_site;
    request.depth = depth;
    workspace_.read(
        QStringLiteral("section"), tr("Looking along the section"),
        [this, request](app::Project& project, Progress& progress) -> JobRunner::Done {
            auto sheet =
                std::make_shared<const geometry::MapSheet>(app::section_sheet(project, request, progress).sheet);
            return [this, sheet] {
                sheet_ = sheet;
                looking_ = false;
                emit changed();
            };
        },
        [this](const QString&) { // nothing lies in this plane: the outlines, if any, stand alone
            looking_ = false;
            emit changed();
        });
}

} // namespace planum::gui
