// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "core/model/evidence.hpp"
#include "core/model/record.hpp"
#include "scans/surface/section_columns.hpp"

namespace planum::app {

/// Two units that a section shows one upon the other.
struct SectionEvidence {
    model::SectionId section;
    model::UnitId upper;
    model::UnitId lower;
    scans::SectionContact contact;
    scans::SectionVerdict verdict;
};

/// The regions of one section that may be compared, laid over each other, in its plane. Units are numbered by their
/// place in `units`.
struct ShownSection {
    std::vector<scans::KnownUnit> units;
    std::vector<scans::SectionRegion> regions;
};

/// Without regions of no unit, of cuts and of units no longer in the record.
[[nodiscard]] ShownSection shown_in_section(const model::Record& record, const model::RecordIndex& index,
                                            const model::Section& section);

/// What the outlines on all sections say, in the order of the record's sections. Outlines that overlap are laid over
/// each other first (layout_regions); regions of no unit, of cuts and of units no longer in the record are passed over.
[[nodiscard]] std::vector<SectionEvidence> section_evidence(const model::Record& record);

/// A contact in a section counts as a strip so deep, where areas are asked for [m].
inline constexpr double kSectionStrip = 0.2;

/// Those that prove an order, one a pair, of the longest contact. Pairs that two sections show both ways round are left
/// out.
[[nodiscard]] std::vector<SectionEvidence> proven_by_sections(const std::vector<SectionEvidence>& sections);

/// The evidence of surfaces with that of sections, which outweighs levels: what levels say of the same pair goes.
[[nodiscard]] std::vector<model::SurfaceEvidence> with_sections(std::vector<model::SurfaceEvidence> surfaces,
                                                                const model::Record& record);

/// All that is measured of a project, as the checks take it: gather_evidence() with the sections, and altered_ground().
/// Throws Cancelled.
[[nodiscard]] model::Measurements measured_evidence(Project& project, Progress& progress);

/// "in section W1 1017 lies on 1042 along 1.2 m", or the question.
[[nodiscard]] std::string reason_of(const model::Record& record, const model::RecordIndex& index,
                                    const SectionEvidence& evidence);

} // namespace planum::app
