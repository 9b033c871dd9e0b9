// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/model/evidence.hpp"
#include "core/model/place.hpp"
#include "core/model/relation.hpp"
#include "scans/surface/surface_step.hpp"

namespace planum::scans {

/// Of a pair that lies on less in all nothing is proposed: outlines drawn a little off do as much [m²].
inline constexpr double kLeastProposed = 0.012;

/// Why something was concluded, or why it had to be asked; the sentences are made from these.
enum class Ground {
    LayBareBelow,     ///< stratigraphic: `other` lay bare where `unit` had been dug away
    EmptiedCut,       ///< what was taken out of a hollow lay on the cut that then lay bare
    BelowBareCut,     ///< what came out below the bottom of an emptied cut
    ThinUnit,         ///< as LayBareBelow, but no thicker than the heights can tell
    FlatContact,      ///< levels: the line moved into `unit` along a flat contact
    ReplacedWhole,    ///< levels: where `unit` was, `other` came out everywhere, and nothing of `unit` is left
    ShrinksInside,    ///< levels: `unit` lies inside `other` and becomes smaller downwards
    AboveNatural,     ///< natural ground came out below
    AppearsInside,    ///< question: first seen inside or below: covered, or seen too late?
    GrowsDownwards,   ///< question: grows into its surroundings: undercut, rising footing, or covered?
    StructureStands,  ///< question: a structure takes part
    RoofOfHollow,     ///< question: an emptied cut reaches under it
    OnlyAlongOutlines ///< question: as LayBareBelow, but nowhere clear of the outlines
};

/// What two surfaces or more say about one pair of units.
struct Conclusion {
    bool is_question = false;
    UnitNumber unit = kNobody; ///< the later one; of a question, the one seen first
    model::RelationKind kind = model::RelationKind::Covers;
    UnitNumber other = kNobody;
    bool direct = false; ///< the two touched, as far as surfaces can tell
    bool thin = false;
    Ground ground = Ground::LayBareBelow;
    model::EvidenceSource source = model::EvidenceSource::StratigraphicSurfaces;
    double area = 0.0;          ///< [m²]
    double contrary_area = 0.0; ///< [m²]
    double thickness = 0.0;     ///< [m]
    double tolerance = 0.0;     ///< 95 % bound of the heights [m]
    double confidence = 0.0;    ///< 0…1
    std::size_t from = 0;       ///< surface on which `unit` was seen, by position
    std::size_t to = 0;         ///< surface on which `other` came out

    friend bool operator==(const Conclusion&, const Conclusion&) = default;
};

/// All surfaces of one area in the order of time.
struct AreaHistory {
    std::vector<model::DigMethod> methods; ///< by surface
    std::vector<SurfaceSummary> summaries; ///< by surface
    std::vector<SurfaceStep> steps;        ///< from surface i to i + 1
    /// By step: units that no surface shows were opened and removed in it, and nobody knows where.
    std::vector<bool> hides_somewhere;
};

/// Draws the conclusions that docs/evidence.md lists, and no others. Sorted by unit, other; all questions,
/// of which keep_useful_questions() leaves those worth asking.
[[nodiscard]] std::vector<Conclusion> conclude(const AreaHistory& history, std::span<const KnownUnit> units);

} // namespace planum::scans
