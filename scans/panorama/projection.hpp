// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace planum::scans {

enum class ProjectionKind : std::uint8_t {
    Equirectangular,
    Cylindrical, ///< central: straight uprights, stretched towards top and bottom
    Mercator,
    Miller,
    EqualArea, ///< Lambert's cylindrical
    Rectilinear,
    Pannini,
    Stereographic,
};

/// "equirectangular", "pannini", …; from_name is its inverse.
[[nodiscard]] std::string_view projection_name(ProjectionKind kind) noexcept;
[[nodiscard]] std::optional<ProjectionKind> projection_from_name(std::string_view name) noexcept;

/// What of the sphere around the scanner is shown, and how. Azimuth runs from x to y (to the left),
/// elevation from the x-y plane upwards.
struct ProjectionOptions {
    ProjectionKind kind = ProjectionKind::Equirectangular;
    int width = 3600;                              ///< [px]
    int height = 1000;                             ///< [px]
    double azimuth_from = -std::numbers::pi;       ///< right border [rad]
    double azimuth_to = std::numbers::pi;          ///< left border [rad]
    double elevation_from = -std::numbers::pi / 3; ///< lower border in the middle of a view [rad]
    double elevation_to = std::numbers::pi / 4;    ///< upper border [rad]
    int views = 3;         ///< rectilinear, Pannini and stereographic: so many views side by side
    double distance = 1.0; ///< Pannini's d

    friend bool operator==(const ProjectionOptions&, const ProjectionOptions&) = default;
};

/// The same extent with `step` radians to a pixel, both ways, in the middle of a view or on the horizon. At least one
/// pixel and at most `most_width` across; then pixels are larger. Throws Usage like Projection.
[[nodiscard]] ProjectionOptions with_square_pixels(ProjectionOptions options, double step, int most_width);

/// From directions to pixels and back. Pixels are continuous: the first one reaches from 0 to 1, u to the
/// right, v downwards.
class Projection {
  public:
    /// Throws Usage for an extent that the projection cannot show (a pole in Mercator, views over 170°).
    explicit Projection(const ProjectionOptions& options);

    [[nodiscard]] const ProjectionOptions& options() const noexcept { return options_; }

    /// Where a direction of any length falls; nullopt outside of the picture.
    [[nodiscard]] std::optional<Eigen::Vector2d> pixel_of(const Eigen::Vector3d& direction) const noexcept;

    /// Direction of length 1 for a place in the picture; nullopt where there is none.
    [[nodiscard]] std::optional<Eigen::Vector3d> ray_of(const Eigen::Vector2d& pixel) const noexcept;

    /// Which of the views side by side a place of the picture belongs to; 0 where there is only one.
    [[nodiscard]] int view_at(double u) const noexcept;

    /// Index (row × width + column) of the pixel for (x, y, z), or -1.
    [[nodiscard]] std::int64_t index_of(double x, double y, double z) const noexcept;

    static constexpr std::uint32_t kOutside = 0xFFFFFFFF;

    /// index_of for many points at once, kOutside for -1: what panoramas are made with. All spans have one size.
    void indices_of(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                    std::span<std::uint32_t> out) const noexcept;

  private:
    friend ProjectionOptions with_square_pixels(ProjectionOptions options, double step, int most_width);

    struct Plane {
        double x = 0.0;
        double y = 0.0;
    };

    [[nodiscard]] bool has_views() const noexcept;

    struct Pixel {
        double u = -1.0;
        double v = -1.0;
    };

    [[nodiscard]] double right_of(double x, double y) const noexcept; ///< [rad] from the left border
    template<ProjectionKind K>
    [[nodiscard]] Pixel locate_in_view(int view, const Plane& middle, double x, double y, double z) const noexcept;
    template<ProjectionKind K>
    [[nodiscard]] Pixel locate(double x, double y, double z) const noexcept;
    static constexpr std::size_t kPortion = 256; ///< points located at once
    struct Portion;
    template<ProjectionKind K>
    void locate_each(Portion& __restrict portion) const noexcept;
    template<ProjectionKind K>
    void locate_portion(Portion& portion) const noexcept;
    template<ProjectionKind K>
    void locate_portion_wide(Portion& portion) const noexcept; ///< where the processor can
    [[nodiscard]] bool holds(const Pixel& pixel) const noexcept;
    [[nodiscard]] std::uint32_t index_at(const Pixel& pixel) const noexcept; ///< or kOutside
    [[nodiscard]] double elevation_of(double height) const noexcept;
    /// Where a direction stands in the plane of its view: a towards the middle of the view, b to the left, c upwards.
    template<ProjectionKind K>
    [[nodiscard]] Plane forward(double a, double b, double c) const noexcept;
    [[nodiscard]] Eigen::Vector3d backward(const Plane& p) const noexcept;

    ProjectionOptions options_;
    int views_ = 1;
    double view_angle_ = 0.0;    ///< [rad]
    std::vector<Plane> middles_; ///< direction of each view's middle
    double plane_left_ = 0.0;    ///< of a view, in the projection's plane
    double plane_top_ = 0.0;
    double scale_x_ = 1.0; ///< [px] per unit of the plane
    double scale_y_ = 1.0;
};

} // namespace planum::scans
