// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/project/project.hpp"
#include "app/scans/verify_scans.hpp"
#include "core/base/progress.hpp"

namespace planum::app {

/// What is proposed for one find without unit.
struct FindProposal {
    model::FindId id;
    std::string find;                    ///< its number
    std::string unit;                    ///< empty: none is proposed
    std::optional<double> z;             ///< of the surface, for a find that has no height [m]
    std::vector<std::string> candidates; ///< units that it may belong to, where it is not clear
    std::string reason;                  ///< a sentence
};

struct FindAssignment {
    std::vector<FindProposal> proposals; ///< of all finds without unit, in the order of the record
    std::vector<ScanProblem> problems;   ///< scans whose points are not there
    std::size_t applied = 0;             ///< finds that were changed
};

struct AssignOptions {
    std::string day;    ///< finds of that day only; empty: all
    bool apply = false; ///< write units and heights, as one undo step
};

/// Proposes for each find without unit the unit whose body holds it: among the units that lay bare at its place on the
/// surfaces from the last before its day to the first after it, the one whose upper face is at or above it and whose
/// lower bounding face at or below, both within the project's tolerance. Where two are possible, or a face that
/// decides is not known, none is proposed; nor a unit that the record says was dug on other days, nor one in
/// touch with a unit that no surface shows and that may have been dug then, nor on levels where there is such a unit at
/// all. A find without height gets that of the
/// surface of its day, and a unit only where those surfaces agree. Throws Usage when `day` is no day, Cancelled.
FindAssignment assign_finds(Project& project, const AssignOptions& options, Progress& progress);

} // namespace planum::app
