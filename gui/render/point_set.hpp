// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.hpp"
#include "core/geometry/rigid.hpp"
#include "gui/render/camera.hpp"
#include "gui/render/point_colour.hpp"
#include "gui/render/scene_cut.hpp"
#include "scans/cloud/point_store.hpp"

namespace planum::gui {

/// A scan as the 3D view shows it.
struct ShownScan {
    std::shared_ptr<const scans::PointStore> store;
    geometry::Rigid3 site_from_scan;
    std::uint32_t tint = 0x808080; ///< of the day or surface, 0xRRGGBB
};

/// Colours of the ground in plan, cell by cell: which unit lies there, or how far it is from another surface. 0 where
/// nothing is known.
struct TintGrid {
    double low_x = 0.0; ///< site [m]
    double low_y = 0.0;
    double cell = 0.02; ///< [m]
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> rgb; ///< row by row from the south, 0xRRGGBB

    [[nodiscard]] std::uint32_t at(double x, double y) const noexcept;
};

/// One point ready for the graphics card, relative to PointSet::origin.
struct PointVertex {
    float x = 0.0F;
    float y = 0.0F;
    float z = 0.0F;
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    std::uint8_t alpha = 255;
};

static_assert(sizeof(PointVertex) == 16);

/// Points chosen for one look. Coordinates are relative to an origin near them, because floats have no room for those
/// of a national grid.
struct PointSet {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    std::vector<PointVertex> points;
};

struct PointQuery {
    Camera camera;
    double aspect = 1.6;
    bool everywhere = false; ///< a share of all there is, whatever the camera sees: for moving about
    std::uint64_t budget = 300'000;
    PointColour colour = PointColour::Intensity;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    /// (normal, offset) in site: nothing is chosen where normal · x + offset < 0, whatever the camera sees.
    std::vector<Eigen::Vector4d> cuts;
    std::shared_ptr<const TintGrid> tints; ///< for Unit and Difference; null: nothing is known of any ground
    double height_low = 0.0;               ///< colours of heights run from here … [m]
    double height_high = 1.0;
};

/// At most `budget` points, from coarse to fine, near the eye first; shared between the scans by what they hold. Throws
/// Cancelled.
[[nodiscard]] PointSet choose_points(const std::vector<ShownScan>& scans, const PointQuery& query, Progress& progress);

/// Ball around all scans of the list: middle and radius [m]; radius 0 where there are none.
struct SceneBounds {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    double radius = 0.0;
};

[[nodiscard]] SceneBounds bounds_of(const std::vector<ShownScan>& scans);

/// Box around all scans of the list, in site coordinates [m]; both at the origin where there are none.
struct SceneCorners {
    Eigen::Vector3d low = Eigen::Vector3d::Zero();
    Eigen::Vector3d high = Eigen::Vector3d::Zero();
};

[[nodiscard]] SceneCorners corners_of(const std::vector<ShownScan>& scans);

/// The point under a part of a line of sight: the nearest of all scans; nullopt where there is none. `spread` is how
/// much wider the sight gets with each metre from the eye.
[[nodiscard]] std::optional<Eigen::Vector3d> pick_point(const std::vector<ShownScan>& scans, const SightPart& part,
                                                        double spread);

/// Colours of heights: violet, blue, green to yellow, brighter with every step.
[[nodiscard]] std::uint32_t height_colour(double share) noexcept;

} // namespace planum::gui
