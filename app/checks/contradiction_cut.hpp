// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "app/checks/contradicting_faces.hpp"

namespace planum::app {

/// A cross-section through two faces: from A, `length` long, in the direction given.
struct FaceCut {
    std::array<double, 2> from{}; ///< [m, site]
    std::array<double, 2> way{};  ///< unit vector
    double length = 0.0;          ///< [m]
    double worst = 0.0;           ///< where the worst place lies along it [m]
    double scale = 10.0;          ///< at which it is drawn, 1 : scale

    [[nodiscard]] std::array<double, 2> at(double along) const noexcept {
        return {from[0] + along * way[0], from[1] + along * way[1]};
    }
};

/// What a cross-section meets, cell by cell; heights that are not known are NaN.
struct FaceSample {
    double along = 0.0; ///< [m]
    float before = 0.0F;
    float after = 0.0F;
    scans::UnitNumber first = scans::kNobody;
    scans::UnitNumber then = scans::kNobody;
    bool clash = false;
};

[[nodiscard]] std::vector<FaceSample> samples_along(const ContradictingFaces& faces, const FaceCut& cut);

/// Through that place, in the direction in which both faces are met most, no farther than a little beyond them, at the
/// largest scale at which both lines stand apart and their height has room.
[[nodiscard]] FaceCut choose_cut(const ContradictingFaces& faces, const std::array<double, 2>& worst, double thickness);

} // namespace planum::app
