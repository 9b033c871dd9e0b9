// SPDX-License-Identifier: MIT
#include "app/scans/panorama_file.hpp"

#include <numbers>

#include "app/scans/list_scans.hpp"
#include "app/scans/scan_panorama.hpp"
#include "app/scans/scan_stores.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/geometry/rigid.hpp"

namespace planum::app {

namespace {

std::optional<Eigen::Isometry3d> pose_of(const model::Record& record, model::ScanId scan) {
    const model::ScanPose* pose = model::pose_in_force(record, scan);
    if (pose == nullptr) return std::nullopt;
    const geometry::Rigid3 rigid = geometry::from_row_major(pose->site_from_scan);
    Eigen::Isometry3d site_from_scan = Eigen::Isometry3d::Identity();
    site_from_scan.linear() = rigid.rotation;
    site_from_scan.translation() = rigid.translation;
    return site_from_scan;
}

std::optional<std::array<double, 16>> numbers_of(const std::optional<Eigen::Isometry3d>& pose) {
    if (!pose) return std::nullopt;
    return geometry::to_row_major({pose->linear(), pose->translation()});
}

} // namespace

WrittenPanorama write_scan_panorama(Project& project, std::string_view name, const std::filesystem::path& png,
                                    const PanoramaRequest& request, Progress& progress) {
    if (text::fold_case(png.extension().string()) != ".png") {
        throw Error(ErrorCode::Usage, png.string() + ": a panorama is written as .png");
    }
    const model::Scan& scan = scan_named(project, name);
    const auto store = open_store(project.path(), scan, progress);
    const scans::Channel channel = panorama_channel(*store, request.channel);
    const scans::ScanExtent extent = scan_extent(*store, progress);
    const scans::Panorama panorama = scan_panorama(*store, extent, request, progress);
    const scans::ProjectionOptions& shown = panorama.projection().options();
    const auto pose = pose_of(project.record(), scan.id);
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    WrittenPanorama written;
    written.scan = scan.name;
    written.picture = png;
    written.description = png;
    written.description.replace_extension(".json");
    written.channel = scans::channel_name(channel);
    written.width = shown.width;
    written.height = shown.height;
    written.azimuth_left_deg = shown.azimuth_to * kDegrees;
    written.azimuth_right_deg = shown.azimuth_from * kDegrees;
    written.elevation_top_deg = shown.elevation_to * kDegrees;
    written.elevation_bottom_deg = shown.elevation_from * kDegrees;
    written.points = panorama.points();
    written.outside = store->points() - panorama.points();
    written.filled = panorama.filled();
    written.from_grid = request.width == 0 && shown.kind == scans::ProjectionKind::Equirectangular && extent.grid();
    written.site_from_scan = numbers_of(pose);
    progress.step("writing " + png.filename().string());
    scans::write_panorama(panorama, channel, png, scan.name, pose);
    return written;
}

} // namespace planum::app
