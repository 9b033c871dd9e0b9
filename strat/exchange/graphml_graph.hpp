// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.hpp"
#include "strat/exchange/xml_input.hpp"

namespace planum::strat {

/// How yEd draws a node; decides what it is in an Extended Matrix.
enum class GraphmlShape { Plain, Group, Table, Parallelogram, Hexagon, Octagon, Diamond, Ellipse, Annotation, Svg };

/// A node of a yEd graph, as far as it says anything about strata.
struct GraphmlNode {
    std::string id;
    std::string parent; ///< id of the folder around it
    std::string label;
    std::string background; ///< of the label, `#CCFFFF`
    GraphmlShape shape = GraphmlShape::Plain;
    double y_centre = 0.0;                   ///< [pixels], downwards
    std::map<std::string, std::string> data; ///< values by attr.name in lower case
    std::int64_t line = 0;
};

/// One swim lane of the table node.
struct GraphmlRow {
    std::string label;
    double y_top = 0.0; ///< [pixels]
    double y_bottom = 0.0;
};

struct GraphmlEdge {
    std::string source;
    std::string target;
    std::string label;
    std::string line_type; ///< line, dashed, dotted, dashed_dotted, double_line
    bool arrow_at_source = false;
    bool arrow_at_target = false;
    std::map<std::string, std::string> data;
    std::int64_t line = 0;
};

struct GraphmlGraph {
    std::vector<GraphmlNode> nodes;
    std::vector<GraphmlEdge> edges;
    std::vector<GraphmlRow> rows;
    std::string table_label; ///< of the canvas: `Site [ID:…]`
};

/// Everything below the root, nested graphs included.
[[nodiscard]] GraphmlGraph read_graphml(const XmlInput& xml, Progress& progress);

} // namespace planum::strat
