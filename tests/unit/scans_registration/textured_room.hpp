// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/rigid.hpp"
#include "scans/panorama/panorama.hpp"

namespace planum::test {

struct RoomOptions {
    unsigned pattern = 1;     ///< of the walls; another number is another room
    bool is_mirrored = false; ///< seen in a mirror
    double sigma = 0.002;     ///< of a range [m]
    int columns = 720;        ///< rays around
    int rows = 240;
};

/// What a scanner at site_from_scan sees of a room of 12 × 9 × 5 m with patterned walls and floor; the floor is at
/// z = 0, the middle at x = y = 0.
[[nodiscard]] scans::PointBlock textured_room(const geometry::Rigid3& site_from_scan, const RoomOptions& options = {});

[[nodiscard]] scans::Panorama room_panorama(const geometry::Rigid3& site_from_scan, const RoomOptions& options = {});

} // namespace planum::test
