// SPDX-License-Identifier: MIT
#include <array>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "strat/exchange/write_support.hpp"
#include "strat/exchange/writers.hpp"
#include "strat/exchange/xml_output.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::strat {

namespace {

using model::RelationKind;
using model::UnitKind;

constexpr std::string_view kHead = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n"
                                   "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\" "
                                   "xmlns:y=\"http://www.yworks.com/xml/graphml\">\n"
                                   "  <key id=\"d0\" for=\"node\" yfiles.type=\"nodegraphics\"/>\n"
                                   "  <key id=\"d1\" for=\"edge\" yfiles.type=\"edgegraphics\"/>\n";

/// Data of nodes and edges beside the drawing, so that programs need not guess from shapes.
constexpr std::array<std::string_view, 11> kNodeKeys = {"uuid",  "number",      "area",  "kind",   "form", "status",
                                                        "title", "description", "phase", "period", "group"};
constexpr std::array<std::string_view, 3> kEdgeKeys = {"uuid", "relation", "certainty"};

struct Shape {
    std::string_view shape;
    std::string_view fill;
};

Shape shape_of(UnitKind kind) {
    switch (kind) {
    case UnitKind::Cut: return {"trapezoid", "#FFE0B2"};
    case UnitKind::Structure: return {"rectangle", "#D7CCC8"};
    case UnitKind::Interface: return {"roundrectangle", "#E1F5FE"};
    case UnitKind::Skeleton: return {"ellipse", "#FFFFFF"};
    case UnitKind::Feature: return {"octagon", "#FFF9C4"};
    case UnitKind::Natural: return {"rectangle", "#C8E6C9"};
    case UnitKind::Void: return {"rectangle", "#EEEEEE"};
    case UnitKind::Unknown:
    case UnitKind::Deposit: return {"rectangle", "#FFFFFF"};
    }
    return {"rectangle", "#FFFFFF"};
}

struct Line {
    std::string_view type;
    std::string_view arrow;
};

Line line_of(RelationKind kind) {
    switch (kind) {
    case RelationKind::Covers:
    case RelationKind::Cuts:
    case RelationKind::Fills:
    case RelationKind::Abuts: return {"line", "standard"};
    case RelationKind::Later: return {"dashed", "standard"};
    case RelationKind::SameAs:
    case RelationKind::BondsWith: return {"line", "none"};
    case RelationKind::Contemporary: return {"dashed", "none"};
    case RelationKind::Borders: return {"dotted", "none"};
    }
    return {"line", "standard"};
}

std::string data(std::string_view prefix, std::string_view key, std::string_view value) {
    if (value.empty()) return {};
    return fmt::format("<data key=\"{}_{}\">{}</data>", prefix, key, xml_escape(value));
}

/// Nodes in folders of groups, edges after them.
class GraphmlDocument {
  public:
    GraphmlDocument(const RecordNames& names, std::vector<std::string>& lost)
        : names_(names), record_(names.record()), lost_(lost), matrix_(HarrisMatrix::build(names.record())) {}

    std::string write() {
        out_ = kHead;
        for (const std::string_view key : kNodeKeys) write_key("node", 'n', key);
        for (const std::string_view key : kEdgeKeys) write_key("edge", 'e', key);
        out_ += "  <graph edgedefault=\"directed\" id=\"G\">\n";
        sort_into_groups();
        for (const std::size_t unit : loose_units_) write_unit(unit);
        for (const std::size_t group : top_groups_) write_group(group);
        write_edges();
        out_ += "  </graph>\n</graphml>\n";
        return std::move(out_);
    }

  private:
    void write_key(std::string_view what, char prefix, std::string_view key) {
        out_ += fmt::format("  <key id=\"{}_{}\" for=\"{}\" attr.name=\"{}\" attr.type=\"string\"/>\n", prefix, key,
                            what, key);
    }

    // A unit lies in its first group. Groups whose parents go round in a circle stand on top.
    void sort_into_groups() {
        std::unordered_map<model::GroupId, std::size_t> place;
        for (std::size_t i = 0; i < record_.groups.size(); ++i) place.emplace(record_.groups[i].id, i);
        inner_groups_.resize(record_.groups.size());
        members_.resize(record_.groups.size());
        for (std::size_t i = 0; i < record_.groups.size(); ++i) {
            const auto parent = place.find(record_.groups[i].parent);
            if (parent == place.end() || leads_back(i, place)) {
                top_groups_.push_back(i);
            } else {
                inner_groups_[parent->second].push_back(i);
            }
        }
        std::unordered_map<model::UnitId, std::size_t> group_of;
        std::size_t further = 0;
        for (std::size_t i = 0; i < record_.groups.size(); ++i) {
            for (const model::UnitId member : record_.groups[i].members)
                further += group_of.emplace(member, i).second ? 0U : 1U;
        }
        for (std::size_t i = 0; i < record_.units.size(); ++i) {
            const auto group = group_of.find(record_.units[i].id);
            (group == group_of.end() ? loose_units_ : members_[group->second]).push_back(i);
        }
        add_loss(lost_, further, "further groups of a unit, of which only the first is written");
    }

    bool leads_back(std::size_t group, const std::unordered_map<model::GroupId, std::size_t>& place) const {
        auto at = place.find(record_.groups[group].parent);
        for (std::size_t steps = 0; at != place.end(); ++steps) {
            if (steps > kMaxDepth || at->second == group) return true;
            at = place.find(record_.groups[at->second].parent);
        }
        return false;
    }

    void write_group(std::size_t index) {
        const model::UnitGroup& group = record_.groups[index];
        out_ += fmt::format("    <node id=\"g{}\" yfiles.foldertype=\"group\">{}{}{}", index,
                            data("n", "number", group.number), data("n", "title", group.title),
                            data("n", "kind", group.type));
        out_ += fmt::format("<data key=\"d0\"><y:GroupNode><y:NodeLabel>{}</y:NodeLabel><y:State "
                            "closed=\"false\"/></y:GroupNode></data>\n"
                            "    <graph edgedefault=\"directed\" id=\"g{}:\">\n",
                            xml_escape(group.number), index);
        for (const std::size_t unit : members_[index]) write_unit(unit);
        for (const std::size_t inner : inner_groups_[index]) write_group(inner);
        out_ += "    </graph></node>\n";
    }

    void write_unit(std::size_t index) {
        const model::StratigraphicUnit& unit = record_.units[index];
        const Shape shape = shape_of(unit.kind);
        const auto layer = matrix_.rank_from_top(matrix_.component_of(matrix_.node_of(static_cast<UnitIndex>(index))));
        const std::string area = names_.area(unit.area);
        out_ += fmt::format("    <node id=\"n{}\">{}{}{}{}{}{}{}{}{}{}", index, data("n", "uuid", unit.id.to_string()),
                            data("n", "number", unit.number), data("n", "area", area),
                            data("n", "kind", model::to_word(unit.kind)), data("n", "form", model::to_word(unit.form)),
                            data("n", "status", model::to_word(unit.status)), data("n", "title", unit.title),
                            data("n", "description", unit.description), data("n", "phase", names_.phase(unit.phase)),
                            data("n", "period", names_.period(unit.period)));
        out_ += fmt::format(
            "<data key=\"d0\"><y:ShapeNode><y:Geometry height=\"30.0\" width=\"60.0\" x=\"{}.0\" y=\"{}.0\"/>"
            "<y:Fill color=\"{}\" transparent=\"false\"/><y:BorderStyle color=\"#000000\" type=\"line\" "
            "width=\"1.0\"/>"
            "<y:NodeLabel>{}</y:NodeLabel><y:Shape type=\"{}\"/></y:ShapeNode></data></node>\n",
            80 * columns_[layer]++, 80 * layer, shape.fill, xml_escape(names_.unit(unit.id)), shape.shape);
    }

    void write_edges() {
        std::unordered_map<model::UnitId, std::size_t> place;
        for (std::size_t i = 0; i < record_.units.size(); ++i) place.emplace(record_.units[i].id, i);
        std::size_t number = 0;
        for (const std::size_t i : complete_relations(names_)) {
            const model::PhysicalRelation& r = record_.relations[i];
            const Line line = line_of(r.kind);
            const bool uncertain = r.certainty == model::Certainty::Uncertain;
            out_ += fmt::format("    <edge id=\"e{}\" source=\"n{}\" target=\"n{}\">{}{}{}", number++,
                                place.at(r.subject), place.at(r.object), data("e", "uuid", r.id.to_string()),
                                data("e", "relation", model::to_word(r.kind)),
                                data("e", "certainty", uncertain ? "uncertain" : ""));
            out_ += fmt::format(
                "<data key=\"d1\"><y:PolyLineEdge><y:LineStyle color=\"#000000\" type=\"{}\" width=\"1.0\"/>"
                "<y:Arrows source=\"none\" target=\"{}\"/></y:PolyLineEdge></data></edge>\n",
                line.type, line.arrow);
        }
    }

    static constexpr std::size_t kMaxDepth = 64;
    const RecordNames& names_;
    const model::Record& record_;
    std::vector<std::string>& lost_;
    HarrisMatrix matrix_;
    std::string out_;
    std::vector<std::size_t> loose_units_;
    std::vector<std::size_t> top_groups_;
    std::vector<std::vector<std::size_t>> inner_groups_;
    std::vector<std::vector<std::size_t>> members_;
    std::unordered_map<std::uint32_t, std::size_t> columns_;
};

} // namespace

Written write_graphml(const model::Record& record, const WriteOptions& /*options*/) {
    Carries carries;
    carries.kind = [](const model::StratigraphicUnit&) { return true; };
    carries.all_areas = carries.status = carries.title = carries.description = true;
    carries.phases = carries.periods = carries.groups = true;
    carries.contact_kinds = carries.later = carries.same_as = carries.bonds = carries.contemporary = true;
    carries.borders = carries.certainty = true;
    Written written;
    written.lost = losses(record, carries);
    const RecordNames names(record);
    std::string bytes = GraphmlDocument(names, written.lost).write();
    written.files.push_back({{}, std::move(bytes)});
    return written;
}

} // namespace planum::strat
