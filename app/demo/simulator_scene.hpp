// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/demo/dig_surfaces.hpp"

namespace planum::app::demo {

/// Something standing around: exact to hit, with a pattern of its own.
struct Solid {
    enum class Type { Box, Cylinder, Ellipsoid };
    enum class Look { Plain, Boards, Bricks, Windows, Corrugated, Bark, Leaves, Cloth, Target };

    Type type = Type::Box;
    Look look = Look::Plain;
    Vec3 centre;
    Vec3 half; ///< half sides; cylinder: radius, radius, half height; ellipsoid: half axes
    double cos_yaw = 1.0;
    double sin_yaw = 0.0;
    double brightness = 0.5;
    std::uint64_t key = 0; ///< of its pattern

    /// Distance along a ray to the front of the solid, or nothing.
    [[nodiscard]] std::optional<double> hit(const Vec3& from, const Vec3& direction) const noexcept;
    /// Reflectance at a point of its surface, 0…1.
    [[nodiscard]] double look_at(const Vec3& p) const noexcept;
};

struct Marker {
    std::string name;
    Vec3 x_in_site;
};

/// All that surrounds the trench on one day, and how the ground outside lies.
struct Scene {
    std::vector<Solid> standing; ///< fence, hut, container, houses, trees, marker poles: the same every day
    std::vector<Marker> markers;
    HeightTable terrain;       ///< turf and spoil heap of the day
    double spoil_volume = 0.0; ///< [m³]
};

/// `dug` is what was taken out up to that day [m³]; it lies on the spoil heap, loosened.
[[nodiscard]] Scene make_scene(const SiteShape& site, std::uint64_t seed, double dug);

/// People and vehicles during one scan; in about a third of the scans there are some.
[[nodiscard]] std::vector<Solid> passers_by(const SiteShape& site, const Scene& scene, std::uint64_t key);

} // namespace planum::app::demo
