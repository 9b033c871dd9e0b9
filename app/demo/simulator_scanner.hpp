// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "app/demo/dig_surfaces.hpp"
#include "app/demo/simulator_scene.hpp"
#include "core/base/progress.hpp"

namespace planum::app::demo {

/// Where a scanner stood: rotation row-major, x_in_site = rotation * x_in_scan + origin.
struct ScannerPose {
    std::array<double, 9> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};
    Vec3 origin;

    [[nodiscard]] Vec3 to_site(const Vec3& x_in_scan) const noexcept;
    [[nodiscard]] Vec3 turn(const Vec3& direction_in_scan) const noexcept;
    [[nodiscard]] Vec3 to_scan(const Vec3& x_in_site) const noexcept;
};

/// One set-up on one day.
struct Station {
    std::string name; ///< `2025-06-01/station1`
    SurfaceNo surface = 0;
    int number = 1;
    ScannerPose pose;
    std::uint64_t key = 0;
};

/// One return; range 0 where nothing came back.
struct Return {
    float range = 0.0F; ///< [m], as measured
    float true_range = 0.0F;
    float intensity = 0.5F; ///< 0…1
    bool mixed = false;     ///< the beam hit two things
};

/// A scan in the order of a PTX: column by column, from below upwards. Directions follow from the grid.
struct ScanImage {
    int columns = 0;
    int rows = 0;
    std::vector<Return> returns;
    std::int64_t count = 0; ///< of returns
    std::int64_t mixed = 0;
    bool people = false;

    [[nodiscard]] Vec3 direction_in_scan(int column, int row) const noexcept;
};

/// What one day's scanners look at: the trench as it stands on that surface, and what is around it.
class Surroundings {
  public:
    Surroundings(const Formation& formation, const DigPlan& plan, const ColumnGrid& grid, const DugGrid& dug,
                 SurfaceNo surface, const Scene& scene);

    [[nodiscard]] const Scene& scene() const noexcept { return scene_; }

    /// Is there earth or stone at the point, inside the trench's rectangle?
    [[nodiscard]] bool solid(const Vec3& p) const noexcept;
    /// Distance to the ground of the trench or around it; 0: none within reach.
    [[nodiscard]] double ground_hit(const Vec3& from, const Vec3& direction) const noexcept;
    /// Reflectance of the ground at a point of its surface.
    [[nodiscard]] double ground_look(const Vec3& p) const noexcept;

  private:
    [[nodiscard]] double trench_hit(const Vec3& from, const Vec3& direction, double begin, double end) const noexcept;
    [[nodiscard]] double terrain_hit(const Vec3& from, const Vec3& direction, double begin, double end) const noexcept;
    void mark_cells(const ColumnGrid& grid, const DugGrid& dug);

    const Formation& formation_;
    const DigPlan& plan_;
    SurfaceNo surface_;
    const Scene& scene_;
    double top_ = 0.0; ///< nothing of the trench is above [m, site]
    std::size_t nx_ = 0;
    std::size_t ny_ = 0;
    std::size_t nz_ = 0;
    std::vector<std::uint8_t> filled_; ///< coarse cells that may hold something
};

/// The stations of one day.
[[nodiscard]] std::vector<Station> stations_of(const DigPlan& plan, SurfaceNo surface);

[[nodiscard]] ScanImage scan(const Surroundings& around, const SiteShape& site, const Station& station,
                             Progress& progress);

/// A marker as that station measured it.
struct MeasuredMarker {
    std::string name;
    Vec3 x_in_scan;
};

/// At least five markers between 4 and 14 m, each coordinate with σ 1 mm.
[[nodiscard]] std::vector<MeasuredMarker> measure_markers(const Surroundings& around, const Station& station);

} // namespace planum::app::demo
