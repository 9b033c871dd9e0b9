// SPDX-License-Identifier: MIT
#include "strat/exchange/graphml_graph.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "core/base/text.hpp"

namespace planum::strat {

namespace {

using Keys = std::map<std::string, std::string>; // key id to attr.name, in lower case

constexpr std::array<std::pair<std::string_view, GraphmlShape>, 7> kShapes = {
    std::pair{"parallelogram", GraphmlShape::Parallelogram},
    {"hexagon", GraphmlShape::Hexagon},
    {"octagon", GraphmlShape::Octagon},
    {"diamond", GraphmlShape::Diamond},
    {"ellipse", GraphmlShape::Ellipse},
    {"trapezoid", GraphmlShape::Parallelogram},
    {"parallelogram2", GraphmlShape::Parallelogram},
};

double number(pugi::xml_node node, const char* name) {
    const auto value = text::parse_double(attribute(node, name));
    return value && std::isfinite(*value) ? *value : 0.0;
}

// Numbers of real files are screen positions; anything wilder is nonsense.
double bounded(double value) { return std::abs(value) < 1e9 ? value : 0.0; }

// The drawing of a node or edge: the first element below a data child that is no text.
template<class Use>
void for_each_graphic(pugi::xml_node element, Use&& use) {
    for (const pugi::xml_node data : element.children()) {
        if (local_name(data) != "data") continue;
        for (const pugi::xml_node graphic : data.children()) {
            if (graphic.type() == pugi::node_element) use(graphic);
        }
    }
}

// A folder keeps its drawings one level deeper: ProxyAutoBoundsNode, Realizers, GroupNode.
pugi::xml_node realizer(pugi::xml_node graphic) {
    if (local_name(graphic) != "ProxyAutoBoundsNode") return graphic;
    for (const pugi::xml_node child : child_named(graphic, "Realizers").children()) {
        if (child.type() == pugi::node_element) return child;
    }
    return graphic;
}

GraphmlShape shape_of(pugi::xml_node graphic) {
    const std::string_view name = local_name(graphic);
    if (name == "TableNode") return GraphmlShape::Table;
    if (name == "ProxyAutoBoundsNode" || name == "GroupNode") return GraphmlShape::Group;
    if (name == "GenericNode") {
        const std::string configuration = attribute(graphic, "configuration");
        return configuration.find("bpmn") == std::string::npos ? GraphmlShape::Plain : GraphmlShape::Annotation;
    }
    if (name == "SVGNode" || name == "ImageNode") return GraphmlShape::Svg;
    const std::string type = attribute(child_named(graphic, "Shape"), "type");
    for (const auto& [word, shape] : kShapes) {
        if (word == type) return shape;
    }
    return GraphmlShape::Plain;
}

void read_label(pugi::xml_node graphic, GraphmlNode& node) {
    for (const pugi::xml_node child : graphic.children()) {
        if (local_name(child) != "NodeLabel") continue;
        std::string text = text_of(child);
        if (text.empty()) continue;
        node.label = std::move(text);
        node.background = attribute(child, "backgroundColor");
        return;
    }
}

// Rows are as high as they say, one under the other, below the head of the table.
void read_table(pugi::xml_node graphic, GraphmlGraph& graph) {
    std::map<std::string, std::string> labels;
    for (const pugi::xml_node child : graphic.children()) {
        if (local_name(child) != "NodeLabel") continue;
        std::string row;
        for (pugi::xml_node at = child; at; at = next_in_document(at, child)) {
            if (local_name(at) == "RowNodeLabelModelParameter") row = attribute(at, "id");
        }
        if (!row.empty()) {
            labels.emplace(row, text_of(child));
        } else if (graph.table_label.empty()) {
            graph.table_label = text_of(child);
        }
    }
    const pugi::xml_node table = child_named(graphic, "Table");
    double y =
        bounded(number(child_named(graphic, "Geometry"), "y")) + bounded(number(child_named(table, "Insets"), "top"));
    for (const pugi::xml_node row : child_named(table, "Rows").children()) {
        if (local_name(row) != "Row") continue;
        const double height = bounded(number(row, "height"));
        const auto label = labels.find(attribute(row, "id"));
        graph.rows.push_back({label == labels.end() ? std::string{} : label->second, y, y + height});
        y += height;
    }
}

std::map<std::string, std::string> read_data(pugi::xml_node element, const Keys& keys) {
    std::map<std::string, std::string> out;
    for (const pugi::xml_node data : element.children()) {
        if (local_name(data) != "data") continue;
        const auto key = keys.find(attribute(data, "key"));
        std::string text = text_of(data);
        if (key != keys.end() && !key->second.empty() && !text.empty()) out.emplace(key->second, std::move(text));
    }
    return out;
}

GraphmlNode read_node(pugi::xml_node element, const XmlInput& xml, const Keys& keys, GraphmlGraph& graph) {
    GraphmlNode node;
    node.id = attribute(element, "id");
    node.line = xml.line_of(element);
    node.data = read_data(element, keys);
    const pugi::xml_node around = element.parent();
    if (local_name(around) == "graph" && local_name(around.parent()) == "node")
        node.parent = attribute(around.parent(), "id");
    for_each_graphic(element, [&](pugi::xml_node graphic) {
        const pugi::xml_node drawn = realizer(graphic);
        const pugi::xml_node geometry = child_named(drawn, "Geometry");
        node.y_centre = bounded(number(geometry, "y")) + bounded(number(geometry, "height")) / 2.0;
        node.shape = shape_of(graphic);
        if (local_name(drawn) == "TableNode") {
            node.shape = GraphmlShape::Table;
            read_table(drawn, graph);
        } else {
            read_label(drawn, node);
        }
    });
    const bool has_graph = static_cast<bool>(child_named(element, "graph"));
    if (has_graph && node.shape != GraphmlShape::Table) node.shape = GraphmlShape::Group;
    return node;
}

GraphmlEdge read_edge(pugi::xml_node element, const XmlInput& xml, const Keys& keys) {
    GraphmlEdge edge;
    edge.source = attribute(element, "source");
    edge.target = attribute(element, "target");
    edge.line = xml.line_of(element);
    edge.data = read_data(element, keys);
    for_each_graphic(element, [&](pugi::xml_node graphic) {
        edge.line_type = attribute(child_named(graphic, "LineStyle"), "type");
        const pugi::xml_node arrows = child_named(graphic, "Arrows");
        const auto has_arrow = [&](const char* end) {
            const std::string arrow = attribute(arrows, end);
            return !arrow.empty() && arrow != "none";
        };
        edge.arrow_at_source = has_arrow("source");
        edge.arrow_at_target = has_arrow("target");
        edge.label = text_of(child_named(graphic, "EdgeLabel"));
    });
    return edge;
}

} // namespace

GraphmlGraph read_graphml(const XmlInput& xml, Progress& progress) {
    GraphmlGraph graph;
    Keys keys;
    const pugi::xml_node root = xml.root();
    std::size_t count = 0;
    for (pugi::xml_node at = root; at; at = next_in_document(at, root)) {
        if (++count % 65536 == 0) progress.check();
        const std::string_view name = local_name(at);
        if (name == "key") keys.emplace(attribute(at, "id"), text::fold_case(attribute(at, "attr.name")));
        if (name == "node") graph.nodes.push_back(read_node(at, xml, keys, graph));
        if (name == "edge") graph.edges.push_back(read_edge(at, xml, keys));
    }
    return graph;
}

} // namespace planum::strat
