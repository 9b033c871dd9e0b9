// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "core/geometry/sheet_group.hpp"

namespace planum::app {

/// A height contradiction to look at.
struct ContradictionSheet {
    /// Seen between surfaces: a plan of both faces, a cross-section through the worst place. Seen in a section: that
    /// section, the worst place larger.
    geometry::SheetGroup group;
    std::string upper;   ///< the unit that was seen first, or on top
    std::string lower;   ///< the unit that came out below it
    std::string before;  ///< surface on which `upper` was seen; empty for a section
    std::string after;   ///< surface on which `lower` was seen
    std::string section; ///< empty for surfaces
    double x = 0.0;      ///< the worst place [m, site]
    double y = 0.0;
    double z_upper = 0.0; ///< of the face of `upper`; in a section of its lower line
    double z_lower = 0.0; ///< of the face of `lower`; in a section of its upper line
    double area = 0.0;    ///< over which `lower` is lower than can be told from level [m²]
    double length = 0.0;  ///< in a section: along which `upper` lies on `lower` [m]
};

/// The height contradiction with that id, among the undecided and the accepted ones of the field record or of an
/// interpretation. Fits A4 upright. Never writes. Throws NotFound when no problem has the id, Usage when it is one of
/// another kind, Conflict when scans or outlines do not show it any more.
[[nodiscard]] ContradictionSheet contradiction_sheet(Project& project, std::string_view id,
                                                     const std::string& interpretation, Progress& progress);

} // namespace planum::app
