// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/model/record.hpp"
#include "strat/exchange/write_support.hpp"

namespace planum::strat {

/// One thing with a place, as maps and CAD programs want it: a point, a line or an outline in the site grid [m].
struct MapFeature {
    enum class Shape { Point, Line, Outline };

    std::string layer; ///< `region`, `find`, `level`, `scan`, `section`
    Shape shape = Shape::Point;
    std::vector<std::array<double, 3>> points; ///< of a point or line
    bool has_height = true;                    ///< whether z means anything
    std::vector<model::Polygon> outline;
    std::string kind;  ///< region: form or kind of its unit, or its category; else the layer's own type
    std::string label; ///< what a plan writes beside it
    std::vector<std::pair<std::string, std::string>> fields;
};

struct MapFeatures {
    std::vector<MapFeature> features; ///< in the order of the record
    std::vector<std::string> lost;    ///< what has no place, or none in plan
};

/// Regions on surfaces, finds, levels, scan stations (accepted poses) and section lines. Everything else of the record
/// is no map feature and is said by the caller.
[[nodiscard]] MapFeatures map_features(const RecordNames& names);

} // namespace planum::strat
