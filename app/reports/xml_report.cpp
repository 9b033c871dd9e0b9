// SPDX-License-Identifier: MIT
#include "app/reports/xml_report.hpp"

#include <sstream>
#include <string>
#include <variant>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "app/reports/xml_nodes.hpp"
#include "app/reports/xml_scan_nodes.hpp"
#include "core/base/text.hpp"

namespace planum::app {

namespace {

using pugi::xml_node;

using xml::attribute;
using xml::clean;
using xml::element;
using xml::optional;
using xml::reference;
using xml::required;

void write_project(xml_node root, const ReportInput& input) {
    const model::ProjectSettings& settings = input.record->settings;
    xml_node node = root.append_child("project");
    required(node, "name", settings.name);
    required(node, "srs", fmt::format("{}", settings.srs_id));
    required(node, "numbers", to_word(settings.numbers));
    required(node, "method", to_word(settings.method));
    required(node, "tolerance", fmt::format("{}", settings.tolerance));
    attribute(node, "interpretation", input.interpretation);
    attribute(node, "day", input.day);
}

void write_places(xml_node root, const model::Record& record) {
    xml_node areas = root.append_child("areas");
    for (const model::Area& area : record.areas) {
        xml_node node = areas.append_child("area");
        required(node, "id", area.id.to_string());
        required(node, "name", area.name);
        attribute(node, "title", area.title);
        attribute(node, "method", to_word(area.method));
    }
    xml_node surfaces = root.append_child("surfaces");
    for (const model::Surface& surface : record.surfaces) {
        xml_node node = surfaces.append_child("surface");
        required(node, "id", surface.id.to_string());
        reference(node, "area", surface.area);
        attribute(node, "name", surface.name);
        attribute(node, "method", to_word(surface.method));
        attribute(node, "first-day", surface.first_day);
        attribute(node, "last-day", surface.last_day);
    }
}

void write_chronology(xml_node root, const model::Record& record) {
    xml_node periods = root.append_child("periods");
    for (const model::Period& period : record.periods) {
        xml_node node = periods.append_child("period");
        required(node, "id", period.id.to_string());
        required(node, "number", period.number);
        attribute(node, "title", period.title);
        optional(node, "from", period.from);
        optional(node, "to", period.to);
        optional(node, "rank", period.rank);
        element(node, "description", period.description);
    }
    xml_node phases = root.append_child("phases");
    for (const model::Phase& phase : record.phases) {
        xml_node node = phases.append_child("phase");
        required(node, "id", phase.id.to_string());
        required(node, "number", phase.number);
        attribute(node, "title", phase.title);
        reference(node, "period", phase.period);
        optional(node, "from", phase.from);
        optional(node, "to", phase.to);
        optional(node, "rank", phase.rank);
        element(node, "description", phase.description);
    }
    xml_node groups = root.append_child("groups");
    for (const model::UnitGroup& group : record.groups) {
        xml_node node = groups.append_child("group");
        required(node, "id", group.id.to_string());
        required(node, "number", group.number);
        attribute(node, "type", group.type);
        attribute(node, "title", group.title);
        reference(node, "parent", group.parent);
        element(node, "description", group.description);
        for (const model::UnitId member : group.members) {
            required(node.append_child("member"), "unit", member.to_string());
        }
    }
}

std::string_view label_of_field(std::string_view name) {
    for (const model::UnitFieldInfo& info : model::kUnitFields) {
        if (info.name == name) return info.label;
    }
    return name;
}

void write_units(xml_node root, const ReportInput& input) {
    const model::Record& record = *input.record;
    xml_node units = root.append_child("units");
    for (const model::StratigraphicUnit& unit : record.units) {
        xml_node node = units.append_child("unit");
        required(node, "id", unit.id.to_string());
        required(node, "number", unit.number);
        reference(node, "area", unit.area);
        required(node, "kind", to_word(unit.kind));
        attribute(node, "form", to_word(unit.form));
        required(node, "status", to_word(unit.status));
        required(node, "origin", to_word(unit.origin));
        reference(node, "phase", unit.phase);
        reference(node, "period", unit.period);
        reference(node, "parent", unit.parent);
        attribute(node, "excavated-from", unit.excavated_from);
        attribute(node, "excavated-on", unit.excavated_on);
        attribute(node, "recorded-by", unit.recorded_by);
        attribute(node, "recorded-on", unit.recorded_on);
        if (input.of_day.contains(unit.id)) attribute(node, "of-day", "true");
        element(node, "title", unit.title);
        element(node, "description", unit.description);
        element(node, "interpretation", unit.interpretation);
        for (const auto& [name, value] : unit.details) {
            xml_node field = node.append_child("field");
            required(field, "name", name);
            required(field, "label", label_of_field(name));
            field.text().set(clean(value).c_str());
        }
    }
}

void write_relations(xml_node root, const model::Record& record) {
    xml_node sources = root.append_child("sources");
    for (const model::Source& source : record.sources) {
        xml_node node = sources.append_child("source");
        required(node, "id", source.id.to_string());
        required(node, "name", source.name);
        attribute(node, "format", source.format);
        attribute(node, "sha256", source.sha256);
        attribute(node, "imported-at", source.imported_at);
    }
    xml_node relations = root.append_child("relations");
    std::size_t at = 0; // statements stand in the order of their relations
    for (const model::PhysicalRelation& relation : record.relations) {
        xml_node node = relations.append_child("relation");
        required(node, "id", relation.id.to_string());
        required(node, "subject", relation.subject.to_string());
        required(node, "kind", to_word(relation.kind));
        required(node, "object", relation.object.to_string());
        required(node, "certainty", to_word(relation.certainty));
        if (relation.correlation) attribute(node, "correlation", "true");
        for (; at < record.statements.size() && record.statements[at].relation == relation.id; ++at) {
            const model::RelationStatement& statement = record.statements[at];
            xml_node said = node.append_child("statement");
            required(said, "side", to_word(statement.side));
            reference(said, "source", statement.source);
            if (statement.line > 0) attribute(said, "line", fmt::format("{}", statement.line));
            attribute(said, "person", statement.person);
            attribute(said, "stated-at", statement.stated_at);
            said.text().set(clean(statement.raw_text).c_str());
        }
    }
}

std::string unit_list(const model::Record& record, std::span<const model::UnitIndex> members) {
    std::vector<std::string> ids;
    for (const model::UnitIndex unit : members) ids.push_back(record.units[unit].id.to_string());
    return text::join(ids, " ");
}

// Only the immediate orders, as in the drawing; the rest follows from them.
void write_orders(xml_node root, const ReportInput& input) {
    const strat::HarrisMatrix& matrix = *input.matrix;
    const model::Record& record = *input.whole;
    xml_node orders = root.append_child("orders");
    for (const std::uint32_t at : input.orders) {
        const strat::Order& order = matrix.orders()[at];
        xml_node node = orders.append_child("order");
        required(node, "later", unit_list(record, matrix.members(order.later)));
        required(node, "earlier", unit_list(record, matrix.members(order.earlier)));
        std::vector<std::string> because;
        for (const strat::RelationIndex relation : matrix.because(at)) {
            because.push_back(record.relations[relation].id.to_string());
        }
        required(node, "because", text::join(because, " "));
        if (matrix.component_of(order.later) == matrix.component_of(order.earlier)) attribute(node, "in-cycle", "true");
    }
}

void write_measured(xml_node root, const model::Record& record) {
    xml_node levels = root.append_child("levels");
    for (const model::Level& level : record.levels) {
        xml_node node = levels.append_child("level");
        required(node, "id", level.id.to_string());
        reference(node, "unit", level.unit);
        required(node, "role", to_word(level.role));
        optional(node, "x", level.x);
        optional(node, "y", level.y);
        required(node, "z", fmt::format("{}", level.z));
        attribute(node, "label", level.label);
    }
    xml_node finds = root.append_child("finds");
    for (const model::Find& find : record.finds) {
        xml_node node = finds.append_child("find");
        required(node, "id", find.id.to_string());
        required(node, "number", find.number);
        reference(node, "unit", find.unit);
        optional(node, "x", find.x);
        optional(node, "y", find.y);
        optional(node, "z", find.z);
        attribute(node, "type", find.type);
        attribute(node, "material", find.material);
        optional(node, "count", find.count);
        optional(node, "weight", find.weight);
        attribute(node, "found-on", find.found_on);
        element(node, "description", find.description);
    }
    xml_node samples = root.append_child("samples");
    for (const model::Sample& sample : record.samples) {
        xml_node node = samples.append_child("sample");
        required(node, "id", sample.id.to_string());
        required(node, "number", sample.number);
        reference(node, "unit", sample.unit);
        attribute(node, "type", sample.type);
        attribute(node, "laboratory-number", sample.laboratory_number);
        attribute(node, "state", sample.state);
        element(node, "description", sample.description);
    }
    xml_node datings = root.append_child("datings");
    for (const model::Dating& dating : record.datings) {
        xml_node node = datings.append_child("dating");
        required(node, "id", dating.id.to_string());
        attribute(node, "label", dating.label);
        reference(node, "unit", dating.unit);
        reference(node, "find", dating.find);
        required(node, "kind", to_word(dating.kind));
        optional(node, "from", dating.from);
        optional(node, "to", dating.to);
        optional(node, "bp", dating.bp);
        optional(node, "bp-error", dating.bp_error);
    }
    xml_node documents = root.append_child("documents");
    for (const model::Document& document : record.documents) {
        xml_node node = documents.append_child("document");
        required(node, "id", document.id.to_string());
        required(node, "number", document.number);
        attribute(node, "type", document.type);
        attribute(node, "title", document.title);
        reference(node, "unit", document.unit);
        attribute(node, "path", document.path);
    }
}

struct WriteSuspect {
    xml_node node;

    void relation(const model::NamedRelation& named) const {
        if (!named.relation.is_nil()) required(node, "relation", named.relation.to_string());
        required(node, "unit", named.unit.to_string());
        required(node, "kind", to_word(named.kind));
        required(node, "other", named.other.to_string());
    }

    void operator()(const model::SuspectRelation& suspect) const {
        required(node, "what", "relation");
        relation(suspect.relation);
    }

    void operator()(const model::SuspectSameAs& suspect) const {
        required(node, "what", "same-as");
        relation(suspect.same_as);
    }

    void operator()(const model::SuspectNumber& suspect) const {
        required(node, "what", "number");
        relation(suspect.relation);
        attribute(node, "written", suspect.written);
        attribute(node, "probably", suspect.probably);
    }

    void operator()(const model::SuspectUnit& suspect) const {
        required(node, "what", "unit");
        required(node, "unit", suspect.unit.to_string());
    }
};

std::string text_of(const model::EvidenceValue& value) {
    return std::visit([](const auto& v) { return fmt::format("{}", v); }, value);
}

void write_diagnostic(xml_node parent, const model::Diagnostic& diagnostic, bool accepted) {
    xml_node node = parent.append_child("diagnostic");
    required(node, "id", diagnostic.id);
    required(node, "code", diagnostic.code);
    required(node, "severity", to_word(diagnostic.severity));
    required(node, "state", accepted ? "accepted" : "open");
    element(node, "message", diagnostic.message);
    for (const model::UnitId unit : diagnostic.units) required(node.append_child("unit"), "ref", unit.to_string());
    for (const model::NamedRelation& named : diagnostic.relations) {
        xml_node relation = node.append_child("relation");
        reference(relation, "ref", named.relation);
        required(relation, "unit", named.unit.to_string());
        required(relation, "kind", to_word(named.kind));
        required(relation, "other", named.other.to_string());
    }
    for (const auto& [name, value] : diagnostic.evidence) {
        xml_node evidence = node.append_child("evidence");
        required(evidence, "name", name);
        required(evidence, "value", text_of(value));
    }
    for (const model::Suspect& suspect : diagnostic.suspects) {
        xml_node child = node.append_child("suspect");
        required(child, "score", fmt::format("{:.3f}", suspect.score));
        std::visit(WriteSuspect{child}, suspect.what);
        for (const std::string& reason : suspect.reasons) element(child, "reason", reason);
    }
}

void write_judgement(xml_node root, const ReportInput& input) {
    xml_node diagnostics = root.append_child("diagnostics");
    for (const model::Diagnostic& d : input.diagnostics) write_diagnostic(diagnostics, d, false);
    for (const model::Diagnostic& d : input.accepted) write_diagnostic(diagnostics, d, true);
    xml_node decisions = root.append_child("decisions");
    for (const model::Decision& decision : input.record->decisions) {
        xml_node node = decisions.append_child("decision");
        required(node, "id", decision.id.to_string());
        attribute(node, "subject", decision.subject_id);
        required(node, "kind", decision.kind);
        attribute(node, "verdict", decision.verdict);
        attribute(node, "author", decision.author);
        attribute(node, "made-at", decision.made_at);
        element(node, "because", decision.because);
    }
    xml::write_interpretations(root, *input.record);
    xml_node coverage = root.append_child("coverage");
    required(coverage, "relations", fmt::format("{}", input.coverage.relations));
    required(coverage, "confirmed", fmt::format("{}", input.coverage.confirmed));
    required(coverage, "contradicted", fmt::format("{}", input.coverage.contradicted));
    for (const auto& [reason, count] : input.coverage.untestable) {
        xml_node node = coverage.append_child("untestable");
        required(node, "reason", reason);
        required(node, "count", fmt::format("{}", count));
    }
    xml_node notes = root.append_child("import-notes");
    for (const model::ImportNote& note : input.record->import_notes) {
        xml_node node = notes.append_child("note");
        reference(node, "source", note.source);
        if (note.line > 0) attribute(node, "line", fmt::format("{}", note.line));
        required(node, "code", note.code);
        element(node, "message", note.message);
        element(node, "raw", note.raw_text);
    }
}

} // namespace

std::string write_xml_report(const ReportInput& input) {
    pugi::xml_document document;
    xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version").set_value("1.0");
    declaration.append_attribute("encoding").set_value("UTF-8");
    xml_node root = document.append_child("report");
    required(root, "xmlns", kReportNamespace);
    required(root, "made-at", input.made_at);
    attribute(root, "made-by", input.made_by);
    required(root, "program", "planum " PLANUM_VERSION);
    write_project(root, input);
    write_places(root, *input.record);
    write_chronology(root, *input.record);
    write_units(root, input);
    write_relations(root, *input.record);
    write_orders(root, input);
    write_measured(root, *input.record);
    xml::write_places_of_units(root, *input.record);
    write_judgement(root, input);
    std::ostringstream out;
    document.save(out, "  ", pugi::format_indent, pugi::encoding_utf8);
    return out.str();
}

} // namespace planum::app
