// SPDX-License-Identifier: MIT
#include "strat/exchange/pyarchinit_rows.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "core/base/text.hpp"
#include "strat/exchange/pyarchinit_relations.hpp"
#include "strat/exchange/unit_fields.hpp"

namespace planum::strat {

namespace {

// Nodes that pyArchInit keeps in its table of units for the Extended Matrix: virtual units and the
// documents, extractors and properties that argue for them. Nobody digs them.
constexpr std::array<std::string_view, 16> kNotDug = {
    "usv", "usva", "usvb",     "usvc",      "usvn", "usvs",     "vsf",      "sf",
    "con", "doc",  "property", "extractor", "tu",   "combiner", "combinar", "combinator"};

// A column that goes to a field of the full record.
struct DetailColumn {
    std::string_view column;
    std::string_view field;
};

constexpr std::array kDetails = {
    DetailColumn{"settore", "sector"},
    DetailColumn{"quad_par", "square"},
    DetailColumn{"ambient", "room"},
    DetailColumn{"posizione", "position"},
    DetailColumn{"formazione", "formation"},
    DetailColumn{"criteri_distinzione", "criteria_of_distinction"},
    DetailColumn{"modo_formazione", "mode_of_formation"},
    DetailColumn{"stato_di_conservazione", "preservation"},
    DetailColumn{"colore", "colour"},
    DetailColumn{"consistenza", "consistency"},
    DetailColumn{"inclusi", "inclusions"},
    DetailColumn{"componenti_organici", "organic_components"},
    DetailColumn{"componenti_inorganici", "inorganic_components"},
    DetailColumn{"attivita", "activity"},
    DetailColumn{"metodo_di_scavo", "excavation_method"},
    DetailColumn{"lunghezza_max", "length"},
    DetailColumn{"larghezza_media", "width"},
    DetailColumn{"profondita_max", "depth"},
    DetailColumn{"osservazioni", "observations"},
    DetailColumn{"flottazione", "flotation"},
    DetailColumn{"setacciatura", "sieving"},
    DetailColumn{"affidabilita", "reliability"},
    DetailColumn{"direttore_us", "director"},
    DetailColumn{"responsabile_us", "checked_by"},
    DetailColumn{"data_rielaborazione", "revised_on"},
    DetailColumn{"elem_datanti", "dating_evidence"},
};

// Columns read elsewhere, or bookkeeping of the program.
constexpr std::array<std::string_view, 44> kElsewhere = {"id_us",
                                                         "sito",
                                                         "area",
                                                         "us",
                                                         "d_stratigrafica",
                                                         "d_interpretativa",
                                                         "descrizione",
                                                         "interpretazione",
                                                         "periodo_iniziale",
                                                         "fase_iniziale",
                                                         "scavato",
                                                         "data_schedatura",
                                                         "schedatore",
                                                         "rapporti",
                                                         "rapporti2",
                                                         "datazione",
                                                         "struttura",
                                                         "order_layer",
                                                         "cont_per",
                                                         "created_at",
                                                         "updated_at",
                                                         "quota_max_abs",
                                                         "quota_min_abs",
                                                         "the_geom",
                                                         "quota_abs",
                                                         "sync_status",
                                                         "version_number",
                                                         "editing_by",
                                                         "editing_since",
                                                         "entity_uuid",
                                                         "last_modified_by",
                                                         "last_modified_timestamp",
                                                         "audit_trail",
                                                         "unita_tipo",
                                                         "d_stratigrafica_en",
                                                         "d_interpretativa_en",
                                                         "gid",
                                                         "osservazioni_en",
                                                         "organici",
                                                         "id",
                                                         "ogc_fid",
                                                         "fid",
                                                         "geom",
                                                         "uuid"};

bool is_empty_value(std::string_view value) {
    return value.empty() || value == "[]" || value == "None" || value == "[['']]" || value == "[['', '']]";
}

void append(std::string& text, std::string_view more) {
    if (more.empty() || text == more) return;
    text += (text.empty() ? "" : "\n") + std::string(more);
}

void read_kind(const PyarchinitRow& row, bool is_dug, ImportedUnit& unit) {
    const std::string_view type = row.get("unita_tipo");
    if (!is_dug) {
        add_custom_field(unit, "unit_type", type);
        return;
    }
    const std::string folded = text::fold_case(type);
    std::optional<model::KindAndForm> kind;
    if (folded == "usm" || folded == "wsu" || folded == "usr") {
        kind = model::KindAndForm{model::UnitKind::Structure, model::UnitForm::Masonry};
    } else {
        kind = kind_from_definition(row.get("d_stratigrafica"));
    }
    if (!kind) return;
    unit.values.kind = kind->kind;
    unit.values.form = kind->form;
}

std::optional<model::UnitStatus> status_of(std::string_view dug) {
    const std::string word = text::fold_case(dug);
    if (word == "si" || word == "sì" || word == "yes" || word == "ja" || word == "oui")
        return model::UnitStatus::Excavated;
    if (word == "no" || word == "nein" || word == "non") return model::UnitStatus::NotExcavated;
    if (word.starts_with("parz") || word.starts_with("part")) return model::UnitStatus::PartlyExcavated;
    return std::nullopt;
}

void read_details(const PyarchinitRow& row, ImportedUnit& unit) {
    for (const auto& [column, value] : row.fields) {
        const std::string_view trimmed = text::trim(value);
        const bool elsewhere = std::find(kElsewhere.begin(), kElsewhere.end(), column) != kElsewhere.end();
        if (is_empty_value(trimmed) || elsewhere) continue;
        const auto* const known =
            std::find_if(kDetails.begin(), kDetails.end(),
                         [&name = column](const DetailColumn& entry) { return entry.column == name; });
        if (known == kDetails.end()) {
            add_custom_field(unit, column, trimmed);
        } else {
            unit.values.details[std::string(known->field)] = trimmed;
        }
    }
}

} // namespace

std::string_view PyarchinitRow::get(std::string_view column) const {
    const auto field = fields.find(column);
    return field == fields.end() ? std::string_view{} : text::trim(field->second);
}

std::string_view PyarchinitRow::get_any(std::initializer_list<std::string_view> columns) const {
    for (const std::string_view column : columns) {
        if (const std::string_view value = get(column); !value.empty()) return value;
    }
    return {};
}

void PyarchinitRows::note(const PyarchinitRow& row, const Place& place, std::string_view code,
                          std::string_view message) {
    builder_.note(place, code, row.table.empty() ? std::string(message) : fmt::format("{}: {}", row.table, message));
}

Imported<ImportedRecord> PyarchinitRows::finish() {
    choose_site();
    const auto for_each = [this](PyarchinitTable table, auto&& read) {
        for (const PyarchinitRow& row : rows_[table]) {
            if (is_taken(row)) read(row);
        }
    };
    for (const PyarchinitRow& row : rows_[PyarchinitTable::Datings]) {
        dating_words_.emplace(text::fold_case(row.get("nome_datazione")),
                              row.get_any({"fascia_cronologica", "descrizione"}));
    }
    for_each(PyarchinitTable::Periods, [this](const auto& row) { read_period(row); });
    for_each(PyarchinitTable::Units, [this](const auto& row) { read_unit(row); });
    for_each(PyarchinitTable::Units, [this](const auto& row) { read_relations(row); });
    for_each(PyarchinitTable::PairsOfUnits, [this](const auto& row) { read_pair(row); });
    for_each(PyarchinitTable::Levels, [this](const auto& row) { read_level(row); });
    for_each(PyarchinitTable::Finds, [this](const auto& row) { read_find(row); });
    for_each(PyarchinitTable::Samples, [this](const auto& row) { read_sample(row); });
    set_phase_years();
    return builder_.finish();
}

// A project is one excavation: of several sites in a database the one asked for is taken, else the one
// with most units, and the others are named.
void PyarchinitRows::choose_site() {
    std::map<std::string, std::size_t> units;
    for (const PyarchinitRow& row : rows_[PyarchinitTable::Units]) {
        if (!row.get("sito").empty()) ++units[std::string(row.get("sito"))];
    }
    builder_.record.project_name = units.size() == 1 ? units.begin()->first : std::string{};
    if (options_.site == "*" || (units.size() < 2 && options_.site.empty())) return;
    site_ = options_.site;
    if (site_.empty()) {
        site_ = std::max_element(units.begin(), units.end(), [](const auto& a, const auto& b) {
                    return a.second < b.second;
                })->first;
    }
    builder_.record.project_name = site_;
    std::string others;
    for (const auto& [name, count] : units) {
        if (name != site_)
            others += fmt::format("{}{} ({})", others.empty() ? "" : ", ", name, text::counted(count, "unit"));
    }
    const std::size_t taken = units.contains(site_) ? units.at(site_) : 0;
    const std::string& file =
        rows_[PyarchinitTable::Units].empty() ? site_ : rows_[PyarchinitTable::Units].front().file;
    if (!others.empty() || taken == 0) {
        builder_.note({file, 0, {}}, "several-sites",
                      fmt::format("site {} with {} units was read; left out: {}; --site takes another or all (*)",
                                  site_, taken, others.empty() ? "none" : others));
    }
}

bool PyarchinitRows::is_taken(const PyarchinitRow& row) const {
    const std::string_view site = row.get_any({"sito", "sito_q", "scavo_s"});
    return site_.empty() || site.empty() || site == site_;
}

UnitName PyarchinitRows::name_of(const PyarchinitRow& row, std::string_view area, std::string_view number) const {
    if (options_.site != "*") return builder_.name(area, number);
    // All sites at once: the site stands before the area, so that numbers stay apart.
    const std::string_view site = row.get_any({"sito", "sito_q", "scavo_s"});
    return builder_.name(area.empty() ? std::string(site) : fmt::format("{} {}", site, area), number);
}

void PyarchinitRows::read_unit(const PyarchinitRow& row) {
    const UnitName name = name_of(row, row.get("area"), row.get("us"));
    const Place place{row.file, row.line, row.get("rapporti")};
    if (name.number.empty()) {
        note(row, place, "unparsed", "a row without number of a unit; left out");
        return;
    }
    const std::string type = text::fold_case(row.get("unita_tipo"));
    const bool is_dug = std::find(kNotDug.begin(), kNotDug.end(), type) == kNotDug.end();
    if (!is_dug) not_dug_.insert(name);
    ImportedUnit& unit = builder_.unit(name, place);
    read_kind(row, is_dug, unit);
    read_details(row, unit);
    builder_.fill(unit.values.title, row.get_any({"d_stratigrafica", "d_stratigrafica_en"}), "the definition", place);
    append(unit.values.description, row.get("descrizione"));
    append(unit.values.interpretation, row.get_any({"d_interpretativa", "d_interpretativa_en"}));
    append(unit.values.interpretation, row.get("interpretazione"));
    builder_.fill(unit.values.recorded_by, row.get("schedatore"), "the recorder", place);
    builder_.fill(unit.values.recorded_on, row.get("data_schedatura").substr(0, 10), "the date of the sheet", place);
    if (const auto status = status_of(row.get("scavato"))) unit.values.status = *status;
    read_unit_phase(row, name);
    read_unit_dating(row, name);
    read_unit_levels(row, name);
    for (const std::string_view structure : text::split(row.get("struttura"), '/')) {
        const std::string_view number = text::trim(structure);
        if (is_empty_value(number)) continue;
        builder_.group(number).values.type = "structure";
        builder_.add_member(number, name);
    }
}

void PyarchinitRows::read_unit_phase(const PyarchinitRow& row, const UnitName& name) {
    const std::string period(row.get("periodo_iniziale"));
    const std::string number(row.get("fase_iniziale"));
    if (period.empty()) return;
    const Place place{row.file, row.line, {}};
    ImportedUnit& unit = builder_.unit(name, place);
    builder_.fill(unit.period, period, "the period of unit " + name.number, place);
    if (number.empty()) return;
    builder_.fill(unit.phase, phase(period, number).values.number, "the phase of unit " + name.number, place);
}

// The date of a unit is that of its first phase, the one in which it was formed: "A (-1200 : -300) / B
// (-800 : -600)" names the last phase of its use behind the bar.
void PyarchinitRows::read_unit_dating(const PyarchinitRow& row, const UnitName& name) {
    const std::string_view label = row.get("datazione");
    if (is_empty_value(label)) return;
    const std::size_t bar = label.find(" / ");
    const std::string_view first = text::trim(label.substr(0, bar));
    const auto years = years_of(first);
    ImportedDating dating;
    dating.unit = name;
    dating.values.label = label.ends_with(" /") ? text::trim(label.substr(0, label.size() - 2)) : label;
    dating.values.kind = model::DatingKind::Typed;
    if (years) {
        dating.values.from = years->from;
        dating.values.to = years->to;
    }
    builder_.record.datings.push_back(std::move(dating));
    const auto remember = [this](std::string_view period, std::string_view number, std::string_view text) {
        const auto span = years_of(text);
        if (!span || period.empty() || number.empty()) return;
        PhaseYears& seen = phase_years_[phase(std::string(period), std::string(number)).values.number];
        seen.titles.emplace(text::trim(text.substr(0, text.find('('))));
        seen.spans.emplace(span->from, span->to);
    };
    remember(row.get("periodo_iniziale"), row.get("fase_iniziale"), first);
    if (bar != std::string_view::npos) {
        remember(row.get("periodo_finale"), row.get("fase_finale"), text::trim(label.substr(bar + 3)));
    }
}

void PyarchinitRows::read_relations(const PyarchinitRow& row) {
    const UnitName unit = name_of(row, row.get("area"), row.get("us"));
    if (unit.number.empty()) return;
    // rapporti2 repeats rapporti with more words; it counts only where the first is empty.
    const std::string_view first = row.get("rapporti");
    PyarchinitRelations cell = read_rapporti(is_empty_value(first) ? row.get("rapporti2") : first);
    if (is_empty_value(first)) {
        for (PyarchinitRelation& relation : cell.relations) relation.area = relation.site = {};
    }
    for (const PyarchinitRelationProblem& problem : cell.problems) {
        note(row, {row.file, row.line, problem.raw}, problem.code,
             fmt::format("unit {}: {}", unit.number, problem.message));
    }
    for (const PyarchinitRelation& relation : cell.relations) state(row, unit, relation);
}

void PyarchinitRows::state(const PyarchinitRow& row, const UnitName& unit, const PyarchinitRelation& relation) {
    const Place place{row.file, row.line, relation.raw};
    const std::string_view own_site = row.get("sito");
    if (!relation.site.empty() && !own_site.empty() && relation.site != own_site) {
        note(row, place, "other-site",
             fmt::format("unit {}: the relation names unit {} of another site, {}; left out", unit.number,
                         relation.target, relation.site));
        return;
    }
    if (builder_.record.project_name.empty() && options_.site != "*") builder_.record.project_name = relation.site;
    const UnitName target = relation.area.empty() ? builder_.name(unit.area, relation.target)
                                                  : name_of(row, relation.area, relation.target);
    if (relation.symbol && (not_dug_.contains(unit) || not_dug_.contains(target))) {
        // `>` and `>>` tie reconstructions to their sources there; that is no order in the ground.
        add_custom_field(builder_.unit(unit, place), "extended_matrix", relation.raw);
        note(row, place, "extended-matrix-link",
             fmt::format("unit {}: a link of the Extended Matrix to a node that is not dug; kept as a note "
                         "of the unit, not as a relation",
                         unit.number));
        return;
    }
    if (StatedRelation* made = builder_.relate(unit, relation.kind, target, place)) {
        if (relation.uncertain) made->certainty = model::Certainty::Uncertain;
        stated_.emplace(made->subject, made->kind, made->object);
    }
}

} // namespace planum::strat
