// SPDX-License-Identifier: MIT

// The tables beside us_table: periods, pairs of units, heights, finds, samples.

#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "core/base/text.hpp"
#include "strat/exchange/pyarchinit_rows.hpp"
#include "strat/exchange/unit_fields.hpp"

namespace planum::strat {

namespace {

std::optional<double> finite_number(std::string_view text) {
    const auto number = text::parse_double(text);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

std::string joined(std::string_view first, std::string_view second) {
    if (first.empty() || second.empty()) return std::string(first.empty() ? second : first);
    return fmt::format("{}: {}", first, second);
}

} // namespace

ImportedPhase& PyarchinitRows::phase(const std::string& period, const std::string& phase) {
    // Phase numbers begin again in each period.
    const std::string number = period + "-" + phase;
    auto& phases = builder_.record.phases;
    const auto [found, is_new] = phase_at_.try_emplace(number, phases.size());
    if (is_new) {
        phases.emplace_back().values.number = number;
        phases.back().period = period;
    }
    return phases[found->second];
}

std::optional<YearSpan> PyarchinitRows::years_of(std::string_view dating) const {
    if (auto span = years_in_text(dating)) return span;
    const auto word = dating_words_.find(text::fold_case(dating));
    return word == dating_words_.end() ? std::nullopt : years_in_text(word->second);
}

// Older databases name the columns periodo and fase, newer ones periodo_iniziale and fase_iniziale; a
// number of a unit in the row makes it that unit's own dating.
void PyarchinitRows::read_period(const PyarchinitRow& row) {
    const std::string period(row.get_any({"periodo", "periodo_iniziale"}));
    const std::string number(row.get_any({"fase", "fase_iniziale"}));
    const Place place{row.file, row.line, period};
    if (const std::string_view us = row.get("us"); !us.empty()) {
        const UnitName name = name_of(row, row.get("area"), us);
        builder_.unit(name, place);
        read_unit_phase(row, name);
        return;
    }
    if (period.empty()) {
        note(row, place, "unparsed", "a row of the periods without number of a period; left out");
        return;
    }
    auto from = year_from_text(row.get("cron_iniziale"));
    auto to = year_from_text(row.get("cron_finale"));
    if (from && to && *to < *from) {
        note(row, place, "swapped-years",
             fmt::format("period {} phase {} ends in {} before it begins in {}; taken the other way round", period,
                         number, *to, *from));
        std::swap(from, to);
    }
    const std::string title(row.get("datazione_estesa"));
    const std::string description(row.get_any({"descrizione", "motivazione"}));
    if (number.empty()) {
        model::Period& made = builder_.record.periods.emplace_back();
        made.number = period;
        made.title = title;
        made.description = description;
        made.from = from;
        made.to = to;
        return;
    }
    model::Phase& values = phase(period, number).values;
    if (values.title.empty()) values.title = title;
    if (values.description.empty()) values.description = description;
    if (!values.from) values.from = from;
    if (!values.to) values.to = to;
}

// A phase without years of its own has those that its units carry, if they all carry the same.
void PyarchinitRows::set_phase_years() {
    for (const auto& [number, seen] : phase_years_) {
        model::Phase& values = builder_.record.phases[phase_at_.at(number)].values;
        if (values.from || values.to || seen.spans.size() != 1) continue;
        values.from = seen.spans.begin()->first;
        values.to = seen.spans.begin()->second;
        if (values.title.empty() && seen.titles.size() == 1) values.title = *seen.titles.begin();
    }
    std::vector<model::Period>& periods = builder_.record.periods;
    std::set<std::string> seen;
    std::erase_if(periods, [&](const model::Period& period) { return !seen.insert(period.number).second; });
}

// The tables of pairs know no area: the only unit of that number is meant.
UnitName PyarchinitRows::unit_named(const PyarchinitRow& row, std::string_view number) {
    UnitName name = name_of(row, row.get("area"), number);
    if (builder_.has_unit(name)) return name;
    if (by_number_.empty()) {
        for (const ImportedUnit& unit : builder_.record.units) by_number_.emplace(unit.name.number, unit.name);
    }
    const auto [first, last] = by_number_.equal_range(name.number);
    return first != last && std::next(first) == last ? first->second : name;
}

void PyarchinitRows::read_pair(const PyarchinitRow& row) {
    const bool is_matrix = row.fields.contains("us_sopra");
    const std::string_view word = row.get(is_matrix ? "tipo_rapporto" : "relationship_type");
    const std::string raw =
        fmt::format("{} {} {}", row.get_any({"us_sopra", "us_from"}), word, row.get_any({"us_sotto", "us_to"}));
    const Place place{row.file, row.line, raw};
    auto kind = model::relation_from_any_word(word);
    if (is_matrix) kind = kind && !kind->inverse ? kind : model::DirectedKind{model::RelationKind::Later, false};
    if (!kind) {
        note(row, place, "unknown-relation", fmt::format("\"{}\" is no relation word known here", word));
        return;
    }
    const auto named = [&](std::string_view number) { return unit_named(row, number); };
    const UnitName subject = named(row.get_any({"us_sopra", "us_from"}));
    const UnitName object = named(row.get_any({"us_sotto", "us_to"}));
    const bool symbol = word.starts_with('>') || word.starts_with('<');
    if (symbol && (not_dug_.contains(subject) || not_dug_.contains(object))) return; // noted with the sheet
    const auto triple =
        kind->inverse ? std::tuple(object, kind->kind, subject) : std::tuple(subject, kind->kind, object);
    if (stated_.contains(triple)) return; // the table repeats the sheets
    if (StatedRelation* made = builder_.relate(subject, *kind, object, place)) {
        made->side = model::StatementSide::Neither;
        stated_.insert(triple);
    }
}

void PyarchinitRows::read_level(const PyarchinitRow& row) {
    const std::string_view height = row.get("quota_q");
    const Place place{row.file, row.line, height};
    const UnitName name = name_of(row, row.get("area_q"), row.get("us_q"));
    const auto z = finite_number(height);
    if (!z || name.number.empty()) {
        note(row, place, "unparsed", "a height without a number or without a unit; left out");
        return;
    }
    const std::string unit_word = text::fold_case(row.get("unita_misu_q"));
    const bool centimetres = unit_word == "cm";
    const bool metres = unit_word.empty() || unit_word == "m" || unit_word == "mt" || unit_word.starts_with("metr");
    if (!centimetres && !metres) {
        note(row, place, "unknown-measure",
             fmt::format("a height of unit {} in \"{}\", which is neither m nor cm; taken as metres", name.number,
                         row.get("unita_misu_q")));
    }
    ImportedLevel& level = builder_.record.levels.emplace_back();
    level.unit = name;
    level.values.z = centimetres ? *z / 100.0 : *z;
    level.values.x = row.x;
    level.values.y = row.y;
    const bool is_cut = builder_.has_unit(name) && builder_.unit(name, place).values.kind == model::UnitKind::Cut;
    level.values.role = is_cut ? model::LevelRole::Cut : model::LevelRole::Top;
}

// Heights on the sheet itself: the highest point of the unit's face is a top; the lowest is still a point
// of that face, not of its base.
void PyarchinitRows::read_unit_levels(const PyarchinitRow& row, const UnitName& name) {
    static constexpr std::array<std::pair<std::string_view, model::LevelRole>, 3> kColumns = {
        std::pair{"quota_max_abs", model::LevelRole::Top},
        {"quota_abs", model::LevelRole::Top},
        {"quota_min_abs", model::LevelRole::Other}};
    for (const auto& [column, role] : kColumns) {
        const std::string_view height = row.get(column);
        if (height.empty() || height == "[]" || height == "None") continue;
        const auto z = finite_number(height);
        if (!z) {
            note(row, {row.file, row.line, height}, "unparsed",
                 fmt::format("unit {}: {} is no number; left out", name.number, column));
            continue;
        }
        ImportedLevel& level = builder_.record.levels.emplace_back();
        level.unit = name;
        level.values.z = *z;
        level.values.role = role;
        level.values.label = column;
    }
}

void PyarchinitRows::read_find(const PyarchinitRow& row) {
    const std::string_view number = row.get_any({"numero_inventario", "n_reperto"});
    const Place place{row.file, row.line, number};
    if (number.empty()) {
        note(row, place, "unparsed", "a find without number; left out");
        return;
    }
    ImportedFind find;
    find.values.number = number;
    find.values.type = row.get("tipo_reperto");
    find.values.material = row.get("corpo_ceramico");
    find.values.condition = row.get("stato_conservazione");
    find.values.box = row.get("nr_cassa");
    find.values.description = joined(row.get("definizione"), row.get("descrizione"));
    find.values.weight = finite_number(row.get("peso"));
    if (const auto count = text::parse_integer(row.get_any({"totale_frammenti", "forme_minime"}))) {
        find.values.count = *count;
    }
    const std::string_view us = row.get("us");
    if (!us.empty() && us != "0") find.unit = name_of(row, row.get("area"), us);
    if (const std::string_view date = row.get("datazione_reperto"); !date.empty()) {
        ImportedDating& dating = builder_.record.datings.emplace_back();
        dating.unit = find.unit;
        dating.find = number;
        dating.values.label = date;
        const std::string type = text::fold_case(find.values.type);
        const bool is_coin = type == "coin" || type == "moneta" || type == "münze" || type == "monnaie";
        dating.values.kind = is_coin ? model::DatingKind::Coin : model::DatingKind::Find;
        if (const auto years = years_of(date)) {
            dating.values.from = years->from;
            dating.values.to = years->to;
        }
    }
    builder_.record.finds.push_back(std::move(find));
}

void PyarchinitRows::read_sample(const PyarchinitRow& row) {
    const std::string_view number = row.get("nr_campione");
    if (number.empty()) {
        note(row, {row.file, row.line, {}}, "unparsed", "a sample without number; left out");
        return;
    }
    ImportedSample& sample = builder_.record.samples.emplace_back();
    sample.values.number = number;
    sample.values.type = row.get("tipo_campione");
    sample.values.description = row.get("descrizione");
    const std::string_view us = row.get("us");
    if (!us.empty() && us != "0") sample.unit = name_of(row, row.get("area"), us);
}

} // namespace planum::strat
