// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "core/model/evidence.hpp"
#include "scans/surface/conclusions.hpp"

namespace planum::app {

/// A surface from which nothing is concluded, and why.
struct UnseenSurface {
    model::SurfaceId surface;
    std::string why;

    friend bool operator==(const UnseenSurface&, const UnseenSurface&) = default;
};

/// What the surfaces of one area say. Unit numbers of the conclusions are positions in `units`, surface
/// numbers positions in `surfaces`.
struct AreaEvidence {
    model::AreaId area;
    std::vector<model::SurfaceId> surfaces; ///< in the order of time
    std::vector<scans::KnownUnit> units;    ///< in the order of the record
    scans::GridFrame frame;                 ///< the cells that were compared
    scans::AreaHistory history;
    std::vector<scans::Conclusion> conclusions; ///< with all questions, see scans::keep_useful_questions()
    std::vector<UnseenSurface> unseen;          ///< outlined, but of no use
};

/// Compares all surfaces of all areas that have outlines and registered scans. What was found about two surfaces comes
/// from the cache where their scans, poses and outlines are as they were. Never throws for missing points or outlines
/// that lie astray; what could not be judged stands in `unseen`.
[[nodiscard]] std::vector<AreaEvidence> gather_evidence(Project& project, Progress& progress);

/// Whether gather_evidence() finds the same in both: surfaces, outlines, scans, their poses, and what it needs to know
/// of the units are alike. What the surfaces say of one record then holds for the other.
[[nodiscard]] bool same_sources(const model::Record& a, const model::Record& b);

/// The proven pairs as the checks take them; questions prove nothing and are left out, but for those of a bare cut
/// below something, which are not testable and tell only that the cut does not lie on it.
[[nodiscard]] std::vector<model::SurfaceEvidence> surface_evidence(const std::vector<AreaEvidence>& areas);

} // namespace planum::app
