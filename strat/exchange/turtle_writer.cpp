// SPDX-License-Identifier: MIT
// The record as RDF in CIDOC CRM 7.1.3, CRMarchaeo 2.0, CRMsci and CRMdig; the mapping stands in
// docs/formats/turtle.md.
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/base/text.hpp"
#include "strat/exchange/write_support.hpp"
#include "strat/exchange/writers.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::strat {

namespace {

using model::RelationKind;
using model::UnitKind;

constexpr std::string_view kPrefixes = R"(@prefix crm: <http://www.cidoc-crm.org/cidoc-crm/> .
@prefix crmarchaeo: <http://www.cidoc-crm.org/extensions/crmarchaeo/> .
@prefix crmsci: <http://www.cidoc-crm.org/extensions/crmsci/> .
@prefix crmdig: <http://www.cidoc-crm.org/extensions/crmdig/> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
@prefix xsd: <http://www.w3.org/2001/XMLSchema#> .
@prefix planum: <urn:planum:def:> .

planum:covers rdfs:subPropertyOf crmarchaeo:AP11_has_physical_relation_to .
planum:cuts rdfs:subPropertyOf crmarchaeo:AP11_has_physical_relation_to .
planum:fills rdfs:subPropertyOf crmarchaeo:AP11_has_physical_relation_to .
planum:abuts rdfs:subPropertyOf crmarchaeo:AP11_has_physical_relation_to .
planum:bonds_with rdfs:subPropertyOf crmarchaeo:AP11_has_physical_relation_to .
planum:borders rdfs:subPropertyOf crmarchaeo:AP11_has_physical_relation_to .
planum:later_than rdfs:comment "closed: along every path of orders" .

)";

// Above this many nodes the closed order is left out: it grows with their square.
constexpr std::size_t kMostClosed = 3000;

std::string literal(std::string_view value) {
    std::string out = "\"";
    for (const char c : text::clean_utf8(value).text) {
        switch (c) {
        case '"': out += "\\\""; break;
        case '\\': out += "\\\\"; break;
        case '\n': out += "\\n"; break;
        case '\r': out += "\\r"; break;
        case '\t': out += "\\t"; break;
        default: out += c;
        }
    }
    return out + "\"";
}

template<class Tag>
std::string iri(const Id<Tag>& id) {
    return "<urn:uuid:" + id.to_string() + ">";
}

std::string genesis(model::UnitId unit) { return "<urn:uuid:" + unit.to_string() + "#genesis>"; }

// xsd:gYear has four digits at least; since XSD 1.1 year 0000 is 1 BCE, so years before our era move by one.
std::string year(model::Year value) {
    const model::Year astronomical = value < 0 ? value + 1 : value;
    return fmt::format("\"{}{:04}\"^^xsd:gYear", astronomical < 0 ? "-" : "",
                       astronomical < 0 ? -astronomical : astronomical);
}

std::string time_span(const std::optional<model::Year>& from, const std::optional<model::Year>& to) {
    std::string out = "[ a crm:E52_Time-Span";
    if (from) out += " ; crm:P82a_begin_of_the_begin " + year(*from);
    if (to) out += " ; crm:P82b_end_of_the_end " + year(*to);
    return out + " ]";
}

std::string_view class_of(UnitKind kind) {
    switch (kind) {
    case UnitKind::Deposit:
    case UnitKind::Structure:
    case UnitKind::Natural:
    case UnitKind::Skeleton: return "crmarchaeo:A2_Stratigraphic_Volume_Unit";
    case UnitKind::Cut:
    case UnitKind::Interface: return "crmarchaeo:A3_Stratigraphic_Interface";
    case UnitKind::Unknown:
    case UnitKind::Feature:
    case UnitKind::Void: return "crmarchaeo:A8_Stratigraphic_Unit";
    }
    return "crmarchaeo:A8_Stratigraphic_Unit";
}

bool is_volume(const model::StratigraphicUnit& unit) {
    return class_of(unit.kind) == "crmarchaeo:A2_Stratigraphic_Volume_Unit";
}

class TurtleWriter {
  public:
    explicit TurtleWriter(const RecordNames& names) : names_(names), record_(names.record()) { out_ = kPrefixes; }

    [[nodiscard]] Written write() {
        units();
        relations();
        closed_orders();
        chronology();
        datings();
        things();
        days();
        surfaces();
        add_loss(lost_, record_.levels.size(), "levels");
        add_loss(lost_, record_.documents.size(), "documents");
        add_loss(lost_, record_.statements.size(), "statements (who said it, and where)");
        return {{{"", std::move(out_)}}, std::move(lost_)};
    }

  private:
    /// One subject with its type; further lines follow with also(), and end() closes it.
    void begin(const std::string& subject, std::string_view type) { out_ += fmt::format("{} a {}", subject, type); }

    void also(std::string_view predicate, std::string_view object) {
        out_ += fmt::format(" ;\n  {} {}", predicate, object);
    }

    void text(std::string_view predicate, std::string_view value) {
        if (!value.empty()) also(predicate, literal(value));
    }

    void identifier(std::string_view number) {
        if (number.empty()) return;
        text("rdfs:label", number);
        also("crm:P1_is_identified_by",
             fmt::format("[ a crm:E42_Identifier ; crm:P190_has_symbolic_content {} ]", literal(number)));
    }

    void end() { out_ += " .\n"; }

    void units() {
        for (const model::StratigraphicUnit& unit : record_.units) {
            begin(iri(unit.id), class_of(unit.kind));
            identifier(names_.unit(unit.id));
            also("crm:P2_has_type", fmt::format("planum:{}", to_word(unit.kind)));
            if (unit.form != model::UnitForm::None) {
                also("crm:P2_has_type", fmt::format("planum:{}", to_word(unit.form)));
            }
            text("crm:P3_has_note", unit.title);
            text("crm:P3_has_note", unit.description);
            text("planum:interpretation", unit.interpretation);
            for (const auto& [name, value] : unit.details) text("planum:" + name, value);
            end();
            begin(genesis(unit.id), "crmarchaeo:A4_Stratigraphic_Genesis");
            also("crmarchaeo:AP7_produced", iri(unit.id));
            end();
        }
    }

    // RDF cannot say "perhaps" of a triple: an uncertain relation, or that two numbers are one unit, is an
    // assignment by somebody.
    void assignment(const model::PhysicalRelation& relation) {
        begin(iri(relation.id), "crm:E13_Attribute_Assignment");
        also("crm:P140_assigned_attribute_to", iri(relation.subject));
        also("crm:P177_assigned_property_of_type", fmt::format("planum:{}", to_word(relation.kind)));
        also("crm:P141_assigned", iri(relation.object));
        also("crm:P2_has_type", fmt::format("planum:{}", to_word(relation.certainty)));
        if (relation.correlation) also("crm:P2_has_type", "planum:correlation");
        end();
    }

    void relations() {
        for (const std::size_t i : complete_relations(names_)) {
            const model::PhysicalRelation& relation = record_.relations[i];
            if (relation.certainty == model::Certainty::Uncertain || relation.kind == RelationKind::SameAs) {
                assignment(relation);
                continue;
            }
            const std::string subject = iri(relation.subject);
            const std::string object = iri(relation.object);
            if (relation.kind != RelationKind::Later && relation.kind != RelationKind::Contemporary) {
                out_ += fmt::format("{} planum:{} {} ;\n  crmarchaeo:AP11_has_physical_relation_to {} .\n", subject,
                                    to_word(relation.kind), object, object);
            }
            in_time(relation);
        }
    }

    void in_time(const model::PhysicalRelation& relation) {
        const std::string subject = genesis(relation.subject);
        const std::string object = genesis(relation.object);
        switch (time_meaning(relation.kind)) {
        case model::TimeMeaning::SubjectLater:
            out_ += fmt::format("{} crmarchaeo:AP28_occurs_before {} .\n", object, subject);
            out_ += fmt::format("{} crmarchaeo:AP13_has_stratigraphic_relation_to {} .\n", subject, object);
            return;
        case model::TimeMeaning::SameTime:
            out_ += fmt::format("{} crmarchaeo:AP22_is_equal_in_time_to {} .\n", subject, object);
            return;
        case model::TimeMeaning::SameUnit:
        case model::TimeMeaning::None: return;
        }
    }

    // Many query tools know no paths, so what follows from the orders is written out.
    void closed_orders() {
        const HarrisMatrix matrix = HarrisMatrix::build(record_);
        const std::size_t nodes = matrix.node_count();
        if (nodes > kMostClosed) {
            lost_.push_back(
                fmt::format("planum:later_than, the closed order: {} units are more than {}", nodes, kMostClosed));
            return;
        }
        std::vector<NodeIndex> reached;
        std::vector<bool> seen(nodes);
        for (NodeIndex later = 0; later < nodes; ++later) {
            reached.clear();
            std::fill(seen.begin(), seen.end(), false);
            const auto go_down = [&](NodeIndex from) {
                for (const std::uint32_t order : matrix.orders_below(from)) {
                    const NodeIndex next = matrix.orders()[order].earlier;
                    if (!seen[next]) reached.push_back(next);
                    seen[next] = true;
                }
            };
            go_down(later);
            std::size_t next = 0;
            while (next < reached.size()) go_down(reached[next++]); // it grows meanwhile
            later_than(matrix, later, reached);
        }
    }

    void later_than(const HarrisMatrix& matrix, NodeIndex later, std::vector<NodeIndex>& earlier) {
        std::sort(earlier.begin(), earlier.end());
        std::vector<std::string> objects;
        for (const NodeIndex node : earlier) {
            if (matrix.component_of(node) == matrix.component_of(later)) continue; // a cycle orders nothing
            for (const UnitIndex unit : matrix.members(node)) objects.push_back(iri(record_.units[unit].id));
        }
        if (objects.empty()) return;
        for (const UnitIndex unit : matrix.members(later)) {
            out_ +=
                fmt::format("{} planum:later_than {} .\n", iri(record_.units[unit].id), text::join(objects, ",\n    "));
        }
    }

    template<class T>
    void span_of_time(const T& value, const char* type) {
        begin(iri(value.id), "crm:E4_Period");
        identifier(value.number);
        also("crm:P2_has_type", type);
        text("crm:P3_has_note", value.title);
        text("crm:P3_has_note", value.description);
    }

    void chronology() {
        for (const model::Period& period : record_.periods) {
            span_of_time(period, "planum:period");
            if (period.from || period.to) also("crm:P4_has_time-span", time_span(period.from, period.to));
            end();
        }
        std::map<model::PhaseId, std::vector<std::string>> formed;
        for (const model::StratigraphicUnit& unit : record_.units) {
            if (!unit.phase.is_nil()) formed[unit.phase].push_back(genesis(unit.id));
        }
        for (const model::Phase& phase : record_.phases) {
            span_of_time(phase, "planum:phase");
            if (phase.from || phase.to) also("crm:P4_has_time-span", time_span(phase.from, phase.to));
            if (!phase.period.is_nil()) also("crm:P9i_forms_part_of", iri(phase.period));
            for (const std::string& event : formed[phase.id]) also("crm:P9_consists_of", event);
            end();
        }
        for (const model::UnitGroup& group : record_.groups) {
            span_of_time(group, "planum:group");
            text("planum:group_type", group.type);
            if (!group.parent.is_nil()) also("crm:P9i_forms_part_of", iri(group.parent));
            for (const model::UnitId member : group.members) also("crm:P9_consists_of", genesis(member));
            end();
        }
    }

    void datings() {
        for (const model::Dating& dating : record_.datings) {
            begin(iri(dating.id), "crm:E13_Attribute_Assignment");
            text("rdfs:label", dating.label);
            also("crm:P2_has_type", fmt::format("planum:{}", to_word(dating.kind)));
            if (!dating.unit.is_nil()) also("crm:P140_assigned_attribute_to", genesis(dating.unit));
            if (dating.unit.is_nil() && !dating.find.is_nil()) {
                also("crm:P140_assigned_attribute_to", iri(dating.find));
            }
            if (dating.from || dating.to) also("crm:P141_assigned", time_span(dating.from, dating.to));
            if (dating.bp) also("planum:radiocarbon_age_bp", fmt::format("{:.1f}", *dating.bp));
            if (dating.bp_error) also("planum:radiocarbon_sigma", fmt::format("{:.1f}", *dating.bp_error));
            text("crm:P3_has_note", dating.notes);
            end();
        }
    }

    void things() {
        for (const model::Find& find : record_.finds) {
            begin(iri(find.id), "crm:E22_Human-Made_Object");
            identifier(find.number);
            text("planum:find_type", find.type);
            text("planum:material", find.material);
            text("crm:P3_has_note", find.description);
            if (!find.unit.is_nil()) also("planum:found_in", iri(find.unit));
            end();
            if (names_.has(find.unit) && is_volume(names_.unit_at(find.unit))) {
                out_ += fmt::format("{} crmarchaeo:AP21_contains {} .\n", iri(find.unit), iri(find.id));
            }
        }
        for (const model::Sample& sample : record_.samples) {
            begin(iri(sample.id), "crmsci:S13_Sample");
            identifier(sample.number);
            text("planum:sample_type", sample.type);
            text("crm:P3_has_note", sample.description);
            if (!sample.unit.is_nil()) also("planum:taken_from", iri(sample.unit));
            end();
        }
    }

    // Digging as processing units, one a day on which units were finished.
    void days() {
        std::map<std::string, std::vector<std::string>> removed;
        for (const model::StratigraphicUnit& unit : record_.units) {
            if (unit.excavated_on.size() == 10) removed[unit.excavated_on].push_back(iri(unit.id));
        }
        for (const auto& [day, units] : removed) {
            begin("<urn:planum:day:" + day + ">", "crmarchaeo:A1_Excavation_Processing_Unit");
            also("crm:P4_has_time-span",
                 fmt::format("[ a crm:E52_Time-Span ; crm:P82_at_some_time_within {}^^xsd:date ]", literal(day)));
            for (const std::string& unit : units) also("crmarchaeo:AP5_removed_part_or_all_of", unit);
            end();
        }
    }

    void surfaces() {
        for (const model::Scan& scan : record_.scans) {
            begin(iri(scan.id), "crmdig:D9_Data_Object");
            identifier(scan.name);
            text("planum:sha256", scan.sha256);
            end();
        }
        for (const model::Region& region : record_.regions) {
            begin(iri(region.id), "crmdig:D35_Area");
            also("crm:P2_has_type", fmt::format("planum:{}", to_word(region.category)));
            if (!region.unit.is_nil()) also("crm:P129_is_about", iri(region.unit));
            text("crm:P3_has_note", region.notes);
            end();
        }
        add_loss(lost_, record_.regions.size(), "outlines of regions (GeoJSON carries them)");
    }

    const RecordNames& names_;
    const model::Record& record_;
    std::string out_;
    std::vector<std::string> lost_;
};

} // namespace

Written write_turtle(const model::Record& record, const WriteOptions& /*options*/) {
    const RecordNames names(record);
    return TurtleWriter(names).write();
}

} // namespace planum::strat
