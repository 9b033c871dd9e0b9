// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/gpb.hpp"
#include "core/model/place.hpp"
#include "core/model/unit.hpp"

namespace planum::app {

/// The vertical plane that an outline lies on, as a file says it.
struct SectionWish {
    std::string name;
    std::optional<std::array<std::array<double, 2>, 2>> line; ///< from, to in site [m]; unset: known by name
};

/// One labelled outline as somebody drew it, by names, not ids: what all readers of outlines give.
struct DrawnOutline {
    std::string where; ///< `feature 3`, for messages
    std::string unit;  ///< number as written; empty: none
    std::string area;
    std::string day; ///< ISO date
    std::string surface;
    model::SurfaceId on_surface;        ///< known already, whatever day and name say
    std::optional<SectionWish> section; ///< set: lies on a section, not on a surface
    bool on_plane = false;              ///< points are (metres along the section, height), not site coordinates
    model::RegionCategory category = model::RegionCategory::Unit;
    model::KindAndForm kind; ///< what the category says of the unit, for units that are made
    std::optional<model::RegionShows> shows;
    std::optional<double> sigma; ///< [m]
    std::string seen_in;         ///< number of the cut whose side shows it
    std::string notes;
    std::string drawn_on = "imported";
    geometry::MultiPolygon shape; ///< z of NaN: nobody said a height
};

/// Something of a file that was not taken or not understood.
struct OutlineNote {
    std::string where;
    std::string message;
};

struct OutlineFile {
    std::vector<DrawnOutline> outlines;
    std::vector<OutlineNote> notes;
};

/// Points without height (NaN) take that of the nearest place on the lines whose height is known. False where there is
/// none: every z is 0 then, and a region of this shape has no heights.
[[nodiscard]] bool settle_heights(geometry::MultiPolygon& shape);

[[nodiscard]] geometry::MultiPolygon shape_of(const std::vector<model::Polygon>& outline);
/// The outline of a region, with NaN for every z where it has no heights.
[[nodiscard]] geometry::MultiPolygon shape_with_heights(const model::Region& region);
[[nodiscard]] std::vector<model::Polygon> outline_of(const geometry::MultiPolygon& shape);

} // namespace planum::app
