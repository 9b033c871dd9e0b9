// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/model/ids.hpp"

namespace planum::model {

/// Where the evidence of a pair comes from.
enum class EvidenceSource { StratigraphicSurfaces, Levels, Section };

/// What the recorded surfaces say about one pair of units; computed from scans, given to the checks as
/// a value. All areas in m², heights in m.
struct SurfaceEvidence {
    UnitId upper; ///< the unit seen first, where the other came out below it
    UnitId lower;
    EvidenceSource source = EvidenceSource::StratigraphicSurfaces;
    double area = 0.0;           ///< cells where `upper` lay above `lower`
    double contrary_area = 0.0;  ///< cells that say the opposite
    double thickness = 0.0;      ///< median height between the two faces
    double tolerance = 0.0;      ///< 95 % bound that was applied to the heights
    double contact_dip = 0.0;    ///< [rad]
    double length = 0.0;         ///< of a contact in a section; its area counts as a strip [m]
    bool both_faces_own = false; ///< both regions show `top` or `cut`
    bool testable = true;
    std::string why_not_testable;
    std::vector<SurfaceId> surfaces;

    friend bool operator==(const SurfaceEvidence&, const SurfaceEvidence&) = default;
};

} // namespace planum::model
