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
    bool below_is_bare_cut = false; ///< `lower` is an emptied cut, under a fill of it or something it reaches under
    std::vector<SurfaceId> surfaces;

    friend bool operator==(const SurfaceEvidence&, const SurfaceEvidence&) = default;
};

/// Ground of a surface that does not lie where it should; from scans, given to the checks as a value.
struct GroundAlteration {
    enum class Kind {
        ChangedWithin, ///< two scans of one surface disagree
        Rose           ///< higher than on the surface before
    };

    Kind kind = Kind::Rose;
    std::string surface;       ///< as lists call it
    std::string since;         ///< the surface it rose from
    std::vector<UnitId> units; ///< that lie there, largest part first
    double x = 0.0;            ///< a place inside [m, site]
    double y = 0.0;
    double area = 0.0;       ///< [m²]
    double change = 0.0;     ///< median of how much higher it is, or one scan has it [m]
    double detectable = 0.0; ///< median of what could be told from none, 95 % [m]
    double low = 0.0;        ///< heights of the ground there [m, site]
    double high = 0.0;
    std::string lower_scan; ///< of two that disagree
    std::string higher_scan;

    friend bool operator==(const GroundAlteration&, const GroundAlteration&) = default;
};

/// Two outlines of one surface or section that claim the same ground, which so belongs to neither.
struct OutlineOverlap {
    std::string where; ///< the surface or section, as lists call it
    std::string first; ///< names of the regions
    std::string second;
    std::vector<UnitId> units; ///< that they show
    double area = 0.0;         ///< [m²]
    double x = 0.0;            ///< a place inside: in plan, or along the section and up [m]
    double y = 0.0;

    friend bool operator==(const OutlineOverlap&, const OutlineOverlap&) = default;
};

/// All that scans, sections and outlines say to the checks.
struct Measurements {
    std::vector<SurfaceEvidence> pairs;
    std::vector<GroundAlteration> alterations;
    std::vector<OutlineOverlap> overlaps;

    [[nodiscard]] bool empty() const noexcept { return pairs.empty() && alterations.empty() && overlaps.empty(); }

    friend bool operator==(const Measurements&, const Measurements&) = default;
};

} // namespace planum::model
