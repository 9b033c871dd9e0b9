// SPDX-License-Identifier: MIT
#include "strat/layout/dot_writer.hpp"

#include <fmt/format.h>

#include <iterator>
#include <map>

#include "core/base/text.hpp"
#include "strat/layout/drawing_colours.hpp"
#include "strat/layout/drawing_style.hpp"

namespace planum::strat {

namespace {

std::string_view dot_shape(BoxShape shape) {
    switch (shape) {
    case BoxShape::Deposit: return "box";
    case BoxShape::Cut: return "invtrapezium";
    case BoxShape::Structure: return "box3d";
    case BoxShape::Interface: return "hexagon";
    case BoxShape::Feature: return "component";
    case BoxShape::Skeleton: return "house";
    case BoxShape::Natural: return "underline";
    case BoxShape::Void: return "plaintext";
    case BoxShape::Unknown: return "box";
    case BoxShape::Folded: return "tab";
    }
    return "box";
}

// Unit names where they are unique among the boxes, ids where not.
std::vector<std::string> node_names(const DrawnGraph& graph) {
    std::map<std::string, int> count;
    for (const GraphBox& b : graph.boxes) ++count[b.name];
    std::vector<std::string> names;
    names.reserve(graph.boxes.size());
    for (const GraphBox& b : graph.boxes) names.push_back(dot_quoted(count[b.name] == 1 ? b.name : b.box.id));
    return names;
}

} // namespace

std::string dot_quoted(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (c == '\n') {
            out += "\\n";
        } else if (c != '\0') {
            out += c;
        }
    }
    return out + "\"";
}

std::string write_dot(const DrawnGraph& graph) {
    std::string out;
    const auto to = std::back_inserter(out);
    const std::vector<std::string> names = node_names(graph);
    fmt::format_to(to, "digraph {} {{\n", dot_quoted(graph.title));
    out += "  graph [splines=ortho, rankdir=TB, ranksep=0.35, nodesep=0.2, fontname=\"DejaVu Sans\"];\n"
           "  node [shape=box, fontname=\"DejaVu Sans\", fontsize=9, height=0.28, margin=\"0.08,0.03\"];\n"
           "  edge [arrowhead=none];\n";
    for (std::size_t i = 0; i < graph.boxes.size(); ++i) {
        const DrawnBox& box = graph.boxes[i].box;
        std::string label;
        for (const std::string& line : box.lines) label += (label.empty() ? "" : "\n") + line;
        fmt::format_to(to, "  {} [label={}, shape={}, id={}{}];\n", names[i], dot_quoted(label), dot_shape(box.shape),
                       dot_quoted(box.id), box.in_cycle ? ", color=red, fontcolor=red" : "");
    }
    for (const Order& pair : graph.contemporaries) {
        fmt::format_to(to, "  {{ rank=same; {}; {}; }}\n", names[pair.later], names[pair.earlier]);
    }
    for (const GraphOrder& order : graph.orders) {
        fmt::format_to(to, "  {} -> {} [id={}{}{}];\n", names[order.later], names[order.earlier],
                       dot_quoted(order.line.id),
                       order.line.uncertain ? ", style=dashed"
                       : order.line.through ? ", style=dotted"
                                            : "",
                       order.line.in_cycle ? ", color=red" : "");
    }
    out += "}\n";
    return out;
}

std::string write_layout_dot(const DrawnGraph& graph, std::string_view splines) {
    constexpr double kPointsPerInch = 72.0;
    std::string out;
    const auto to = std::back_inserter(out);
    fmt::format_to(to, "digraph g {{\n  graph [splines={}, ranksep={:.3f}, nodesep={:.3f}];\n", splines,
                   style::kChannelMin * 1.4 / kPointsPerInch, style::kBoxGap / kPointsPerInch);
    out += "  node [shape=box, fixedsize=true, label=\"\"];\n  edge [dir=none];\n";
    for (std::size_t i = 0; i < graph.boxes.size(); ++i) {
        const DrawnBox& box = graph.boxes[i].box;
        if (box.isolated) continue;
        fmt::format_to(to, "  n{} [width={:.4f}, height={:.4f}];\n", i, box.rect.width / kPointsPerInch,
                       box.rect.height / kPointsPerInch);
    }
    for (const Order& pair : graph.contemporaries) {
        if (graph.boxes[pair.later].box.isolated || graph.boxes[pair.earlier].box.isolated) continue;
        fmt::format_to(to, "  {{ rank=same; n{}; n{}; }}\n", pair.later, pair.earlier);
    }
    for (std::size_t i = 0; i < graph.orders.size(); ++i) {
        fmt::format_to(to, "  n{} -> n{} [comment={}];\n", graph.orders[i].later, graph.orders[i].earlier, i);
    }
    out += "}\n";
    return out;
}

} // namespace planum::strat
