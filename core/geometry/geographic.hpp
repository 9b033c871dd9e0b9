// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

namespace planum::geometry {

/// Turns places of one coordinate system into longitude and latitude of WGS 84, with PROJ's best operation for it.
class Geographic {
  public:
    /// nullopt when EPSG has no such code, or PROJ cannot relate it to WGS 84.
    [[nodiscard]] static std::optional<Geographic> of_epsg(std::int64_t code);

    Geographic(Geographic&&) noexcept;
    Geographic& operator=(Geographic&&) noexcept;
    ~Geographic();

    /// {longitude, latitude} [degrees] of an easting and northing [m, or the system's unit]; nullopt where the
    /// system ends.
    [[nodiscard]] std::optional<std::array<double, 2>> longitude_latitude(double x, double y) const;

  private:
    struct Proj;
    explicit Geographic(std::unique_ptr<Proj> proj) noexcept;
    std::unique_ptr<Proj> proj_;
};

} // namespace planum::geometry
