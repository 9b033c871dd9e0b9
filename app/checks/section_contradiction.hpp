// SPDX-License-Identifier: MIT
#pragma once

#include "app/checks/contradiction_sheet.hpp"
#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "core/model/diagnostic.hpp"

namespace planum::app {

/// Whether a height contradiction was seen in a section and not between surfaces.
[[nodiscard]] bool is_seen_in_section(const model::Diagnostic& problem);

/// The section that contradicts a relation: all its outlines with both units and their contact, and the worst place
/// larger, that is the column in which the thinner of the two is thickest, so that no line drawn astray could turn the
/// order. Behind them what the scans of the section's day show of its plane, where there are any. Throws Conflict when
/// no section shows it any more.
[[nodiscard]] ContradictionSheet section_contradiction(Project& project, const model::Diagnostic& problem,
                                                       Progress& progress);

} // namespace planum::app
