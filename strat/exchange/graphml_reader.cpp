// SPDX-License-Identifier: MIT

// GraphML as yEd writes it: any drawn matrix, and the Extended Matrix with its swim lanes and shapes.

#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/graphml_graph.hpp"
#include "strat/exchange/readers.hpp"
#include "strat/exchange/record_builder.hpp"
#include "strat/exchange/unit_fields.hpp"

namespace planum::strat {

namespace {

constexpr std::string_view kWhat = "a GraphML matrix";

// "Imperial [start:-50;end:120]": the number behind a word.
std::optional<model::Year> year_behind(std::string_view label, std::string_view word) {
    const std::size_t at = label.find(word);
    if (at == std::string_view::npos) return std::nullopt;
    const std::string_view rest = label.substr(at + word.size());
    return year_from_text(text::trim(rest.substr(0, rest.find_first_of(";]"))));
}

std::string_view before_bracket(std::string_view label) { return text::trim(label.substr(0, label.find('['))); }

std::string_view shape_word(GraphmlShape shape) {
    switch (shape) {
    case GraphmlShape::Parallelogram: return "USVs";
    case GraphmlShape::Hexagon: return "USVn";
    case GraphmlShape::Octagon: return "special find";
    case GraphmlShape::Ellipse: return "series";
    case GraphmlShape::Plain:
    case GraphmlShape::Group:
    case GraphmlShape::Table:
    case GraphmlShape::Diamond:
    case GraphmlShape::Annotation:
    case GraphmlShape::Svg: return {};
    }
    return {};
}

class GraphmlReader {
  public:
    GraphmlReader(RecordBuilder& builder, std::string_view file, GraphmlGraph graph)
        : builder_(builder), file_(file), graph_(std::move(graph)) {
        // Swim lanes with years, or simply a table: only the Extended Matrix has them.
        extended_ = !graph_.rows.empty();
    }

    void read() {
        for (std::size_t i = 0; i < graph_.nodes.size(); ++i) at_.emplace(graph_.nodes[i].id, i);
        if (builder_.record.project_name.empty()) builder_.record.project_name = before_bracket(graph_.table_label);
        read_rows();
        read_groups();
        for (const GraphmlNode& node : graph_.nodes) read_node(node);
        for (const GraphmlEdge& edge : graph_.edges) read_edge(edge);
        note_left_out();
    }

  private:
    void read_rows() {
        for (const GraphmlRow& row : graph_.rows) {
            const std::string name(before_bracket(row.label));
            if (name.empty()) continue;
            ImportedPhase& phase = builder_.record.phases.emplace_back();
            phase.values.number = name;
            phase.values.from = year_behind(row.label, "start:");
            phase.values.to = year_behind(row.label, "end:");
        }
    }

    [[nodiscard]] const GraphmlNode* find(const std::string& id) const {
        const auto found = at_.find(id);
        return found == at_.end() ? nullptr : &graph_.nodes[found->second];
    }

    // Folders of the Extended Matrix are told apart by the colour of their label; those of paradata hold no units.
    [[nodiscard]] std::string_view group_type(const GraphmlNode& node) const {
        if (node.shape != GraphmlShape::Group) return {};
        const std::string colour = text::fold_case(node.background);
        if (extended_ && colour.starts_with("#ffcc99")) return {};
        if (colour.starts_with("#ccffff")) return "activity";
        if (colour.starts_with("#99cc00")) return "time branch";
        return "group";
    }

    void read_groups() {
        for (const GraphmlNode& node : graph_.nodes) {
            const std::string_view type = group_type(node);
            if (type.empty()) continue;
            const std::string own = datum(node.data, "number");
            std::string name = !own.empty() ? own : node.label.empty() ? node.id : node.label;
            if (!used_groups_.insert(name).second) {
                name += " (" + node.id + ")";
                used_groups_.insert(name);
            }
            group_names_[node.id] = name;
            model::UnitGroup& group = builder_.group(name).values;
            const std::string own_type = datum(node.data, "kind");
            group.type = own_type.empty() ? type : own_type;
            group.title = datum(node.data, "title");
            group.description = datum(node.data, "description");
        }
        for (const auto& [id, name] : group_names_) {
            if (const std::string outer = group_around(*find(id)); outer != name) builder_.group(name).parent = outer;
        }
    }

    [[nodiscard]] std::string group_around(const GraphmlNode& node) const {
        const auto found = group_names_.find(node.parent);
        return found == group_names_.end() ? std::string{} : found->second;
    }

    [[nodiscard]] bool is_unit(const GraphmlNode& node) const {
        switch (node.shape) {
        case GraphmlShape::Group:
        case GraphmlShape::Table: return false;
        case GraphmlShape::Diamond:
        case GraphmlShape::Annotation:
        case GraphmlShape::Svg: return !extended_;
        case GraphmlShape::Plain:
        case GraphmlShape::Parallelogram:
        case GraphmlShape::Hexagon:
        case GraphmlShape::Octagon:
        case GraphmlShape::Ellipse: return true;
        }
        return true;
    }

    static std::string datum(const std::map<std::string, std::string>& data, std::string_view key) {
        const auto found = data.find(std::string(key));
        return found == data.end() ? std::string{} : found->second;
    }

    void read_node(const GraphmlNode& node) {
        if (!is_unit(node)) {
            const bool paradata = node.shape != GraphmlShape::Group && node.shape != GraphmlShape::Table;
            if (paradata) ++left_out_nodes_;
            return;
        }
        // The first line of a label is the number, what follows the title; a number of its own comes first.
        const std::string own = datum(node.data, "number");
        const std::size_t line_end = node.label.find('\n');
        const std::string_view first = text::trim(std::string_view(node.label).substr(0, line_end));
        const Place place{file_, node.line, node.label};
        UnitName name = own.empty() ? builder_.name(first.empty() ? std::string_view(node.id) : first)
                                    : builder_.name(datum(node.data, "area"), own);
        if (first.empty() && own.empty()) {
            builder_.note(place, "unnamed", fmt::format("a node without label; named by its id, {}", node.id));
        }
        if (name.number.empty()) return;
        if (builder_.has_unit(name)) {
            builder_.note(place, "repeated-unit",
                          fmt::format("two nodes are called {}; they are taken for one", name.number));
        }
        names_[node.id] = name;
        ImportedUnit& unit = builder_.unit(name, place);
        read_fields(node, unit);
        if (own.empty() && line_end != std::string::npos && unit.values.title.empty()) {
            unit.values.title = text::trim(std::string_view(node.label).substr(line_end));
        }
        if (const std::string group = group_around(node); !group.empty()) builder_.add_member(group, name);
    }

    void read_fields(const GraphmlNode& node, ImportedUnit& unit) {
        const auto get = [&node](std::string_view key) { return datum(node.data, key); };
        if (const auto kind = model::kind_from_any_word(get("kind"))) {
            unit.values.kind = kind->kind;
            unit.values.form = kind->form;
        }
        if (const auto form = model::from_word<model::UnitForm>(get("form"))) unit.values.form = *form;
        if (const auto status = model::from_word<model::UnitStatus>(get("status"))) unit.values.status = *status;
        if (unit.values.title.empty()) unit.values.title = get("title");
        if (unit.values.description.empty()) unit.values.description = get("description");
        unit.phase = get("phase");
        unit.period = get("period");
        if (!extended_) return;
        if (const std::string_view type = shape_word(node.shape); !type.empty())
            add_custom_field(unit, "unit_type", type);
        for (const GraphmlRow& row : graph_.rows) {
            const bool inside = row.y_top <= node.y_centre && node.y_centre < row.y_bottom;
            if (inside && unit.phase.empty()) unit.phase = before_bracket(row.label);
        }
    }

    [[nodiscard]] std::optional<model::DirectedKind> kind_of(const GraphmlEdge& edge) const {
        for (const std::string& word : {datum(edge.data, "relation"), edge.label}) {
            if (const auto kind = model::relation_from_any_word(word)) return kind;
        }
        const bool same_time = edge.line_type == "double_line" || edge.line_type == "double" ||
                               (edge.arrow_at_source && edge.arrow_at_target);
        if (same_time) return model::DirectedKind{model::RelationKind::Contemporary, false};
        const bool backwards = edge.arrow_at_source && !edge.arrow_at_target && !extended_;
        if (!extended_) {
            // A broken line is how Harris Matrix Composer's exports draw order without contact.
            const bool contact = edge.line_type.empty() || edge.line_type == "line";
            return model::DirectedKind{contact ? model::RelationKind::Covers : model::RelationKind::Later, backwards};
        }
        // Solid: is after; dotted: changed from. Dashed: provenance; dash-dot: contrasts, neither an order.
        const bool order = edge.line_type.empty() || edge.line_type == "line" || edge.line_type == "dotted";
        return order ? std::optional(model::DirectedKind{model::RelationKind::Later, backwards}) : std::nullopt;
    }

    void read_edge(const GraphmlEdge& edge) {
        const auto source = names_.find(edge.source);
        const auto target = names_.find(edge.target);
        const std::string raw = fmt::format("{} {} {}", edge.source, edge.label, edge.target);
        const Place place{file_, edge.line, raw};
        if (source == names_.end() || target == names_.end()) {
            const GraphmlNode* from = find(edge.source);
            const GraphmlNode* to = find(edge.target);
            if (from == nullptr || to == nullptr) {
                builder_.note(place, "unknown-target", "an edge ends at a node that is not in the file; left out");
            } else if (from->shape == GraphmlShape::Group || to->shape == GraphmlShape::Group) {
                builder_.note(place, "group-relation", "an edge of a group was left out; only units have relations");
            } else {
                ++left_out_edges_;
            }
            return;
        }
        const auto kind = kind_of(edge);
        if (!kind) {
            ++left_out_edges_;
            return;
        }
        const std::string said = fmt::format("{} {} {}", source->second.number, edge.label, target->second.number);
        StatedRelation* relation = builder_.relate(source->second, *kind, target->second, {file_, edge.line, said});
        if (relation == nullptr) return;
        // A drawing says a relation once; no sheet of either unit stands behind it.
        relation->side = model::StatementSide::Neither;
        if (datum(edge.data, "certainty") == "uncertain") relation->certainty = model::Certainty::Uncertain;
    }

    void note_left_out() {
        if (left_out_nodes_ + left_out_edges_ == 0) return;
        builder_.note({file_, 0, {}}, "extended-matrix-link",
                      fmt::format("{} nodes and {} links of the Extended Matrix that argue for a reconstruction "
                                  "(documents, properties, extractors, continuity) were left out",
                                  left_out_nodes_, left_out_edges_));
    }

    RecordBuilder& builder_;
    std::string_view file_;
    GraphmlGraph graph_;
    bool extended_ = false;
    std::map<std::string, std::size_t> at_;
    std::map<std::string, UnitName> names_; ///< units by id of their node
    std::map<std::string, std::string> group_names_;
    std::set<std::string> used_groups_;
    std::size_t left_out_nodes_ = 0;
    std::size_t left_out_edges_ = 0;
};

Recognition recognise(std::span<const InputFile> files) {
    Recognition out;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::string_view bytes = files[i].bytes;
        if (files[i].is_database || !is_probably_text(bytes)) continue;
        const bool xml = text::trim(bytes.substr(0, 4096)).find('<') != std::string_view::npos;
        if (!xml || bytes.substr(0, 1U << 16U).find("graphml") == std::string_view::npos) continue;
        if (bytes.find("hmcnode") != std::string_view::npos) continue; // Harris Matrix Composer's own
        out.files.push_back(i);
        out.confidence = Confidence::Certain;
        out.why = "GraphML without HMC nodes";
    }
    return out;
}

Imported<ImportedRecord> read(std::span<const InputFile* const> files, const ReadOptions& options, Progress& progress) {
    RecordBuilder builder(options);
    for (const InputFile* file : files) {
        progress.check();
        if (file->is_database) {
            throw Error(ErrorCode::BadInput, fmt::format("{}: an SQLite database, not {}", file->name, kWhat));
        }
        const XmlInput xml(file->bytes, file->name, kWhat);
        builder.add_notes(xml.notes());
        if (local_name(xml.root()) != "graphml") {
            throw Error(ErrorCode::BadInput, fmt::format("{}: XML of another kind, not {}", file->name, kWhat));
        }
        GraphmlReader(builder, file->name, read_graphml(xml, progress)).read();
    }
    return builder.finish();
}

} // namespace

const Reader& graphml_reader() {
    static const Reader reader = {"graphml", "GraphML of yEd or the Extended Matrix (.graphml)", recognise, read};
    return reader;
}

} // namespace planum::strat
