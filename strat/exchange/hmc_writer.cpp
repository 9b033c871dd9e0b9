// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "strat/exchange/delimited_table.hpp"
#include "strat/exchange/hmc_nodes.hpp"
#include "strat/exchange/write_support.hpp"
#include "strat/exchange/writers.hpp"
#include "strat/exchange/xml_output.hpp"
#include "strat/exchange/zip_archive.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::strat {

namespace {

using model::PeriodId;
using model::PhaseId;
using model::RelationKind;

bool keeps_kind(const model::StratigraphicUnit& unit) {
    const bool known = unit.kind == model::UnitKind::Deposit || unit.kind == model::UnitKind::Interface ||
                       unit.kind == model::UnitKind::Natural;
    return known && unit.form == model::UnitForm::None;
}

struct Edge {
    std::string source;
    std::string type; ///< ABOVE, LATER, CONTEMPORARY
    std::string target;
};

/// What both HMC files say: nodes with their groups, edges, and the rank that HMC draws from.
struct HmcDocument {
    std::vector<HmcNode> groups; ///< periods, then phases
    std::vector<HmcNode> units;
    std::vector<std::uint32_t> layers; ///< of the units
    std::vector<Edge> edges;
};

// Group ids share one space with units in HMC.
class HmcIds {
  public:
    explicit HmcIds(const RecordNames& names) {
        const model::Record& record = names.record();
        for (const auto& unit : record.units) units_.emplace(unit.id, take(names.unit(unit.id), "unit"));
        for (const auto& period : record.periods) periods_.emplace(period.id, take(period.number, "period"));
        for (const auto& phase : record.phases) phases_.emplace(phase.id, take(names.phase(phase.id), "phase"));
    }

    [[nodiscard]] std::string unit(model::UnitId id) const { return units_.at(id); }

    [[nodiscard]] std::string period(PeriodId id) const { return find(periods_, id); }

    [[nodiscard]] std::string phase(PhaseId id) const { return find(phases_, id); }

    [[nodiscard]] std::size_t renamed() const { return renamed_; }

    [[nodiscard]] std::size_t with_commas() const { return with_commas_; }

  private:
    template<class Map, class Key>
    static std::string find(const Map& map, const Key& key) {
        const auto it = map.find(key);
        return it == map.end() ? std::string{} : it->second;
    }

    std::string take(const std::string& name, std::string_view what) {
        with_commas_ += name.find(',') != std::string::npos ? 1U : 0U;
        // An empty id would be the same as having no group.
        if (!name.empty() && taken_.insert(name).second) return name;
        ++renamed_;
        std::string id = fmt::format("{} {}", what, name);
        while (!taken_.insert(id).second) id += "'";
        return id;
    }

    std::set<std::string> taken_;
    std::unordered_map<model::UnitId, std::string> units_;
    std::unordered_map<PeriodId, std::string> periods_;
    std::unordered_map<PhaseId, std::string> phases_;
    std::size_t renamed_ = 0;
    std::size_t with_commas_ = 0;
};

std::vector<Edge> edges_of(const RecordNames& names, const HmcIds& ids) {
    std::vector<Edge> edges;
    for (const std::size_t i : complete_relations(names)) {
        const model::PhysicalRelation& r = names.record().relations[i];
        const auto add = [&](const char* type) { edges.push_back({ids.unit(r.subject), type, ids.unit(r.object)}); };
        switch (r.kind) {
        case RelationKind::Covers:
        case RelationKind::Cuts:
        case RelationKind::Fills:
        case RelationKind::Abuts: add("ABOVE"); break;
        case RelationKind::Later: add("LATER"); break;
        case RelationKind::BondsWith:
        case RelationKind::Contemporary: add("CONTEMPORARY"); break;
        case RelationKind::SameAs:
        case RelationKind::Borders: break;
        }
    }
    return edges;
}

HmcNode group_node(std::string id, std::string type, const std::string& name, const std::string& description,
                   std::string parent) {
    return {std::move(id), std::move(type), name, description, std::move(parent), true, 0};
}

HmcDocument document_of(const RecordNames& names, std::vector<std::string>& lost) {
    const model::Record& record = names.record();
    const HmcIds ids(names);
    HmcDocument document;
    for (const auto& period : record.periods) {
        document.groups.push_back(
            group_node(ids.period(period.id), "PERIOD_GROUP", period.title, period.description, ""));
    }
    for (const auto& phase : record.phases) {
        document.groups.push_back(
            group_node(ids.phase(phase.id), "PHASE_GROUP", phase.title, phase.description, ids.period(phase.period)));
    }
    const HarrisMatrix matrix = HarrisMatrix::build(record);
    std::size_t torn = 0;
    for (std::size_t i = 0; i < record.units.size(); ++i) {
        const model::StratigraphicUnit& unit = record.units[i];
        const std::string phase = ids.phase(unit.phase);
        const std::string period = ids.period(unit.period);
        torn += !phase.empty() && ids.period(names.period_of(unit.phase)) != period ? 1U : 0U;
        HmcNode node{ids.unit(unit.id),
                     std::string{hmc_type_of(unit)},
                     unit.title,
                     unit.description,
                     phase.empty() ? period : phase,
                     true,
                     0};
        document.units.push_back(std::move(node));
        document.layers.push_back(matrix.rank_from_top(matrix.component_of(matrix.node_of(static_cast<UnitIndex>(i)))));
    }
    document.edges = edges_of(names, ids);
    add_loss(lost, torn, "units without their period, which is not that of their phase");
    add_loss(lost, ids.renamed(), "phases and periods renamed, as HMC knows one series of numbers for all");
    return document;
}

std::string node_data(const HmcNode& node, std::uint32_t layer, std::size_t index) {
    return fmt::format("<data key=\"d2\"><hmcnode xmlns=\"\" id=\"{}\" name=\"{}\" description=\"{}\" type=\"{}\" "
                       "layer=\"{}\" index=\"{}\" valid=\"true\" bookmarked=\"false\"{}/></data>",
                       xml_escape(node.id), xml_escape(node.name), xml_escape(node.description), node.type, layer,
                       index, is_hmc_group(node.type) ? " open=\"true\"" : "");
}

/// Writes the nested graphs; two levels at most, so a walk over parents is enough.
class MatrixXml {
  public:
    explicit MatrixXml(const HmcDocument& document) : document_(document) {
        for (std::size_t i = 0; i < document.groups.size(); ++i) groups_in_[document.groups[i].parent].push_back(i);
        for (std::size_t i = 0; i < document.units.size(); ++i) units_in_[document.units[i].parent].push_back(i);
    }

    std::string write() {
        out_ = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n"
               "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns/graphml\">\n"
               "  <key extension.type=\"hmc\" for=\"node\" id=\"d0\"/>\n"
               "  <key extension.type=\"hmc\" for=\"edge\" id=\"d1\"/>\n"
               "  <key extension.type=\"hmc\" for=\"graph\" id=\"d2\"/>\n"
               "  <graph edgedefault=\"directed\" id=\"g1\">\n";
        write_inside("");
        std::size_t number = 0;
        for (const Edge& edge : document_.edges) {
            out_ += fmt::format("    <edge id=\"e{}\" source=\"{}\" target=\"{}\"><data key=\"d2\"><hmcedge xmlns=\"\" "
                                "type=\"{}\" valid=\"true\"/></data></edge>\n",
                                ++number, xml_escape(edge.source), xml_escape(edge.target), edge.type);
        }
        out_ += "  </graph>\n</graphml>\n";
        return std::move(out_);
    }

  private:
    void write_inside(const std::string& parent) {
        for (const std::size_t i : units_in_[parent]) {
            const HmcNode& node = document_.units[i];
            out_ += fmt::format("    <node id=\"{}\">{}</node>\n", xml_escape(node.id),
                                node_data(node, document_.layers[i], index_++));
        }
        for (const std::size_t i : groups_in_[parent]) {
            const HmcNode& node = document_.groups[i];
            out_ += fmt::format("    <node id=\"{}\"><graph edgedefault=\"directed\" id=\"g{}\">\n",
                                xml_escape(node.id), ++graphs_ + 1);
            write_inside(node.id);
            out_ += fmt::format("    </graph>{}</node>\n", node_data(node, 0, index_++));
        }
    }

    const HmcDocument& document_;
    std::unordered_map<std::string, std::vector<std::size_t>> groups_in_;
    std::unordered_map<std::string, std::vector<std::size_t>> units_in_;
    std::string out_;
    std::size_t index_ = 0;
    std::size_t graphs_ = 0;
};

/// The lists of one row, by column name.
struct RowLists {
    std::vector<std::string> above, below, earlier, later, contemporary, children;
};

std::unordered_map<std::string, RowLists> lists_of(const HmcDocument& document) {
    std::unordered_map<std::string, RowLists> lists;
    const auto add = [](std::vector<std::string>& list, const std::string& id) {
        if (std::find(list.begin(), list.end(), id) == list.end()) list.push_back(id);
    };
    for (const Edge& edge : document.edges) {
        RowLists& source = lists[edge.source];
        if (edge.type == "ABOVE") add(source.above, edge.target);
        if (edge.type == "LATER") add(source.later, edge.target);
        if (edge.type == "CONTEMPORARY") add(source.contemporary, edge.target);
        RowLists& target = lists[edge.target];
        if (edge.type == "ABOVE") add(target.below, edge.source);
        if (edge.type == "LATER") add(target.earlier, edge.source);
        if (edge.type == "CONTEMPORARY") add(target.contemporary, edge.source);
    }
    for (const HmcNode& unit : document.units) lists[unit.parent].children.push_back(unit.id);
    for (const HmcNode& group : document.groups) lists[group.parent].children.push_back(group.id);
    return lists;
}

std::string comma_list(const std::vector<std::string>& ids) {
    std::string list;
    for (const std::string& id : ids) list += (list.empty() ? "" : ",") + id;
    return list;
}

Carries hmc_carries() {
    Carries carries;
    carries.kind = keeps_kind;
    carries.title = carries.description = true;
    carries.phases = carries.periods = true;
    carries.later = carries.contemporary = true;
    return carries;
}

} // namespace

Written write_hmcx(const model::Record& record, const WriteOptions& /*options*/) {
    Written written;
    written.lost = losses(record, hmc_carries());
    const RecordNames names(record);
    const HmcDocument document = document_of(names, written.lost);
    const std::string project = fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ProjectProperties "
                                            "Name=\"{}\" Description=\"\" ExcavationSite=\"\"/>\n",
                                            xml_escape(record.settings.name));
    const std::array members = {std::pair{std::string{"project.xml"}, project},
                                std::pair{std::string{"matrix.xml"}, MatrixXml(document).write()}};
    written.files.push_back({{}, write_zip(members)});
    return written;
}

Written write_hmc_csv(const model::Record& record, const WriteOptions& /*options*/) {
    Written written;
    written.lost = losses(record, hmc_carries());
    const RecordNames names(record);
    const HmcDocument document = document_of(names, written.lost);
    add_loss(written.lost, HmcIds(names).with_commas(), "numbers with a comma, which will be read as lists");
    const RowWriter plain{';', "\r\n", false, false};
    const RowWriter quoted{';', "\r\n", true, false};
    std::string out = plain.write(std::array<std::string, 4>{"HEADER", "NAME", "DESCRIPTION", "SITE"});
    out += quoted.write(std::array<std::string, 4>{"PROJECT", record.settings.name, "", ""});
    out += plain.write(std::array<std::string, 14>{"HEADER", "ID", "TYPE", "NAME", "DESCRIPTION", "LAYER", "VALID",
                                                   "ABOVE", "BELOW", "EARLIER", "LATER", "CONTEMPORARY", "PARENT",
                                                   "CHILDREN"});
    const auto lists = lists_of(document);
    const auto write_row = [&](const HmcNode& node, std::uint32_t layer) {
        const auto found = lists.find(node.id);
        const RowLists empty;
        const RowLists& row = found == lists.end() ? empty : found->second;
        out += quoted.write(std::array<std::string, 14>{
            "UNIT", node.id, node.type, node.name, node.description, std::to_string(layer), "true",
            comma_list(row.above), comma_list(row.below), comma_list(row.earlier), comma_list(row.later),
            comma_list(row.contemporary), node.parent, comma_list(row.children)});
    };
    for (const HmcNode& group : document.groups) write_row(group, 0);
    for (std::size_t i = 0; i < document.units.size(); ++i) write_row(document.units[i], document.layers[i]);
    written.files.push_back({{}, std::move(out)});
    return written;
}

} // namespace planum::strat
