// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"

namespace planum::app {

/// A volume with its uncertainty.
struct Earth {
    double net = 0.0;   ///< gone less added [m³]
    double bound = 0.0; ///< 95 % [m³]
    double area = 0.0;  ///< in plan [m²]
};

/// What was dug where one unit lay bare.
struct EarthOfUnit {
    std::string unit;     ///< its number; of ground that is no unit the category; empty: outside all outlines
    bool is_unit = false; ///< a unit of the record
    Earth earth;
};

/// Between two successive surfaces.
struct EarthStep {
    std::string before;
    std::string after;
    Earth total;
    double gone = 0.0;              ///< where the ground is lower now [m³]
    double added = 0.0;             ///< where it is higher [m³]
    double overhung = 0.0;          ///< of the total: from under overhangs, as their sides were seen to begin [m³]
    double filled = 0.0;            ///< of the area counted: sides, and what no scan saw but ground near it [m²]
    double unseen = 0.0;            ///< not counted: no ground was seen near [m²]
    std::vector<EarthOfUnit> units; ///< that lay bare on `before`; in the order of their names
};

struct PassedSurface {
    std::string name;
    std::string why; ///< no registered scan shows it
};

struct EarthReport {
    std::vector<EarthStep> steps;
    std::vector<EarthOfUnit> units; ///< over all steps
    Earth total;                    ///< over all steps
    std::vector<PassedSurface> unseen;
    std::vector<std::string> out_of_order; ///< model::is_in_clash(); passed over where the order says what is next
};

struct EarthQuery {
    std::string before; ///< surface; empty: all steps of all areas
    std::string after;  ///< surface; both or none
    std::string area;   ///< only this area
    double cell = 0.02; ///< [m]
};

/// Earth dug from surface to surface inside the outlines of an area and 10 cm around them, so that a wall drawn a few
/// centimetres too far in loses nothing; where an area has no outlines, everywhere. A cell counts for the unit that lay
/// bare before. Bounds over several steps add as if the steps were independent; a surface between two steps errs with
/// opposite signs, so they are rather too wide. Throws as known_surface() and recorded_surface(), Usage for two areas.
[[nodiscard]] EarthReport dug_earth(Project& project, const EarthQuery& query, Progress& progress);

} // namespace planum::app
