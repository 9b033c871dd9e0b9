// SPDX-License-Identifier: MIT
#include "strat/exchange/planum_csv_rows.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/base/text.hpp"

namespace planum::strat {

namespace {

using model::StatementSide;

void set_kind(const CsvRow& row, ImportedUnit& unit) {
    const std::string word = row.text("kind");
    if (!word.empty()) {
        const auto kind = model::kind_from_any_word(word);
        if (kind) {
            unit.values.kind = kind->kind;
            unit.values.form = kind->form;
        } else {
            row.note(word, "unknown-type", fmt::format("the kind {} is not known; kept as a free field", word));
            std::string& custom = unit.values.details["custom"];
            custom += (custom.empty() ? "kind=" : "\nkind=") + word;
        }
    }
    const std::string form_word = text::fold_case(row.text("form"));
    if (form_word.empty()) return;
    if (const auto form = model::from_word<model::UnitForm>(form_word)) {
        unit.values.form = *form;
    } else {
        row.note(form_word, "unknown-type", fmt::format("the form {} is not known; left out", form_word));
    }
}

void set_status(const CsvRow& row, ImportedUnit& unit) {
    std::string word = text::fold_case(row.text("status"));
    if (word.empty()) return;
    std::replace(word.begin(), word.end(), ' ', '-');
    std::replace(word.begin(), word.end(), '_', '-');
    if (const auto status = model::from_word<model::UnitStatus>(word)) {
        unit.values.status = *status;
    } else {
        row.note(word, "unknown-status",
                 fmt::format("the status {} is not known; there are open, partly-excavated, excavated, not-excavated, "
                             "void",
                             word));
    }
}

void add_level(RecordBuilder& builder, const CsvRow& row, std::string_view column, model::LevelRole role) {
    const auto z = row.number(column);
    if (!z) return;
    ImportedLevel level;
    level.unit = row.unit();
    level.values.x = row.number("x");
    level.values.y = row.number("y");
    level.values.z = *z;
    level.values.role = role;
    builder.record.levels.push_back(std::move(level));
}

void set_details(const CsvRow& row, ImportedUnit& unit, RecordBuilder& builder) {
    for (const model::UnitFieldInfo& field : model::kUnitFields) {
        const std::string value = row.text(field.name);
        if (value.empty()) continue;
        std::string& target = unit.values.details[std::string{field.name}];
        builder.fill(target, value, field.label, row.place(value));
    }
    const auto known = csv_columns(CsvTable::Units);
    const auto& names = row.header().names();
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string value = without_formula_guard(row.at(i));
        if (value.empty() || std::find(known.begin(), known.end(), names[i]) != known.end()) continue;
        std::string& custom = unit.values.details["custom"];
        const std::string entry = fmt::format("{}={}", names[i], text::replace_all(value, "\n", " "));
        custom += (custom.empty() ? "" : "\n") + entry;
    }
}

void read_unit(const CsvRow& row, RecordBuilder& builder) {
    const UnitName name = row.unit();
    if (name.number.empty()) {
        row.note({}, "unparsed", "a line without a unit number was left out");
        return;
    }
    const Place place = row.place();
    ImportedUnit& unit = builder.unit(name, place);
    set_kind(row, unit);
    set_status(row, unit);
    builder.fill(unit.values.title, row.text("title"), "the title of " + name.number, place);
    builder.fill(unit.values.description, row.text("description"), "the description of " + name.number, place);
    builder.fill(unit.values.interpretation, row.text("interpretation"), "the interpretation of " + name.number, place);
    builder.fill(unit.values.excavated_from, row.date("excavated_from"), "the first day of " + name.number, place);
    builder.fill(unit.values.excavated_on, row.date("excavated_on"), "the last day of " + name.number, place);
    builder.fill(unit.values.recorded_by, row.text("recorded_by"), "the recorder of " + name.number, place);
    builder.fill(unit.values.recorded_on, row.date("recorded_on"), "the recording day of " + name.number, place);
    builder.fill(unit.phase, row.text("phase"), "the phase of " + name.number, place);
    builder.fill(unit.period, row.text("period"), "the period of " + name.number, place);
    if (const std::string parent = row.text("parent"); !parent.empty()) unit.parent = row.unit_near(name, parent, {});
    set_details(row, unit, builder);
    for (const std::string& group : split_list(row.text("group"), ListSeparator::CommaOrSemicolon)) {
        builder.add_member(group, name);
    }
    add_level(builder, row, "top", model::LevelRole::Top);
    // `base` is a field of the full record (the base of a cut, in words); as a number it is a height.
    const auto base = unit.values.details.find("base");
    if (base != unit.values.details.end() && text::parse_double(base->second)) {
        unit.values.details.erase(base);
        add_level(builder, row, "base", model::LevelRole::Base);
    }
}

// The whole cell where it is a unit, else its parts: `13, 14` is what people write.
std::vector<UnitName> others_of(const CsvRow& row, const UnitName& near, const RecordBuilder& builder) {
    const std::string text = row.text("other");
    const std::string area = row.text("other_area");
    const UnitName whole = row.unit_near(near, text, area);
    if (text.empty() || builder.has_unit(whole)) return {whole};
    std::vector<UnitName> names;
    for (const std::string& part : split_list(text, ListSeparator::CommaOrSemicolon)) {
        names.push_back(row.unit_near(near, part, area));
    }
    return names;
}

void read_relation(const CsvRow& row, RecordBuilder& builder) {
    const UnitName subject = row.unit();
    std::string word = row.text("relation");
    const std::string raw = fmt::format("{} {} {}", subject.number, word, row.text("other"));
    const bool doubted = word.ends_with('?');
    if (doubted) word.pop_back();
    const auto kind = model::relation_from_any_word(word);
    if (!kind) {
        row.note(raw, "unknown-relation", fmt::format("the relation {} is not known; left out", word));
        return;
    }
    const std::string certainty = text::fold_case(row.text("certainty"));
    const auto certain = certainty == "?" ? model::Certainty::Uncertain : model::certainty_from_word(certainty);
    if (!certainty.empty() && !certain) {
        row.note(certainty, "unparsed",
                 fmt::format("certainty is certain or uncertain, not {}; taken as certain", certainty));
    }
    const std::string correlation = text::fold_case(row.text("correlation"));
    for (const UnitName& other : others_of(row, subject, builder)) {
        StatedRelation* relation = builder.relate(subject, *kind, other, row.place(raw));
        if (relation == nullptr) continue;
        relation->certainty = doubted ? model::Certainty::Uncertain : certain.value_or(model::Certainty::Certain);
        relation->person = row.text("person");
        relation->correlation = correlation == "yes" || correlation == "1" || correlation == "true";
        if (text::fold_case(row.text("side")) == "neither") relation->side = StatementSide::Neither;
    }
}

void read_level(const CsvRow& row, RecordBuilder& builder) {
    const auto z = row.number("z");
    if (!z || row.unit().number.empty()) {
        row.note(row.text("unit"), "unparsed", "a level needs a unit and a height z; left out");
        return;
    }
    const std::string word = text::fold_case(row.text("role"));
    const auto role = model::level_role_from_word(word);
    if (!role && !word.empty())
        row.note(word, "unparsed", fmt::format("the role {} is not known; taken as other", word));
    ImportedLevel level;
    level.unit = row.unit();
    level.values.x = row.number("x");
    level.values.y = row.number("y");
    level.values.z = *z;
    level.values.role = role.value_or(word.empty() ? model::LevelRole::Top : model::LevelRole::Other);
    level.values.label = row.text("label");
    builder.record.levels.push_back(std::move(level));
}

void read_find(const CsvRow& row, RecordBuilder& builder) {
    ImportedFind find;
    find.unit = row.unit();
    find.values.number = row.text("find");
    find.values.x = row.number("x");
    find.values.y = row.number("y");
    find.values.z = row.number("z");
    find.values.type = row.text("type");
    find.values.material = row.text("material");
    find.values.count = row.integer("count");
    find.values.weight = row.number("weight");
    find.values.condition = row.text("condition");
    find.values.box = row.text("box");
    find.values.found_on = row.date("found_on");
    find.values.description = row.text("description");
    builder.record.finds.push_back(std::move(find));
}

void read_sample(const CsvRow& row, RecordBuilder& builder) {
    ImportedSample sample;
    sample.unit = row.unit();
    sample.values.number = row.text("sample");
    sample.values.type = row.text("type");
    sample.values.volume = row.number("volume");
    sample.values.weight = row.number("weight");
    sample.values.laboratory_number = row.text("laboratory_number");
    sample.values.state = row.text("state");
    sample.values.description = row.text("description");
    builder.record.samples.push_back(std::move(sample));
}

void read_document(const CsvRow& row, RecordBuilder& builder) {
    ImportedDocument document;
    document.unit = row.unit();
    document.values.number = row.text("document");
    document.values.type = row.text("type");
    document.values.title = row.text("title");
    document.values.path = row.text("path");
    document.values.made_on = row.date("made_on");
    document.values.author = row.text("author");
    builder.record.documents.push_back(std::move(document));
}

void read_dating(const CsvRow& row, RecordBuilder& builder) {
    ImportedDating dating;
    dating.unit = row.unit();
    dating.find = row.text("find");
    dating.values.label = row.text("dating");
    const std::string word = text::fold_case(row.text("kind"));
    const auto kind = model::dating_kind_from_word(word);
    if (!kind && !word.empty()) {
        row.note(word, "unknown-type", fmt::format("the kind of dating {} is not known; left out", word));
        return;
    }
    dating.values.kind = kind.value_or(model::DatingKind::Typed);
    dating.values.from = row.integer("from");
    dating.values.to = row.integer("to");
    dating.values.bp = row.number("bp");
    dating.values.bp_error = row.number("error");
    dating.values.association = row.text("association");
    dating.values.notes = row.text("notes");
    builder.record.datings.push_back(std::move(dating));
}

void read_period(const CsvRow& row, RecordBuilder& builder) {
    model::Period period;
    period.number = row.text("period");
    period.title = row.text("title");
    period.description = row.text("description");
    period.from = row.integer("from");
    period.to = row.integer("to");
    period.rank = row.integer("rank");
    builder.record.periods.push_back(std::move(period));
}

void read_phase(const CsvRow& row, RecordBuilder& builder) {
    ImportedPhase phase;
    phase.values.number = row.text("phase");
    phase.values.title = row.text("title");
    phase.values.description = row.text("description");
    phase.values.from = row.integer("from");
    phase.values.to = row.integer("to");
    phase.values.rank = row.integer("rank");
    phase.period = row.text("period");
    builder.record.phases.push_back(std::move(phase));
}

void read_group(const CsvRow& row, RecordBuilder& builder) {
    ImportedGroup& group = builder.group(row.text("group"));
    const Place place = row.place();
    builder.fill(group.values.type, row.text("type"), "the type of a group", place);
    builder.fill(group.values.title, row.text("title"), "the title of a group", place);
    builder.fill(group.values.description, row.text("description"), "the description of a group", place);
    builder.fill(group.parent, row.text("parent"), "the parent of a group", place);
}

void read_area(const CsvRow& row, RecordBuilder& builder) {
    model::Area area;
    area.name = row.text("area");
    area.title = row.text("title");
    const std::string word = text::fold_case(row.text("method"));
    const auto method = model::dig_method_from_word(word);
    if (!method && !word.empty()) row.note(word, "unparsed", fmt::format("the method {} is not known", word));
    area.method = method.value_or(model::DigMethod::Stratigraphic);
    area.first_number = row.text("first_number");
    area.last_number = row.text("last_number");
    builder.record.areas.push_back(std::move(area));
}

} // namespace

std::string CsvRow::text(std::string_view column) const {
    return without_formula_guard(cell(*row_, header_->find(column)));
}

void CsvRow::note(std::string_view raw_text, std::string_view code, std::string message) const {
    builder_->note(place(raw_text), code, std::move(message));
}

std::optional<double> CsvRow::number(std::string_view column) const {
    const std::string value = text(column);
    if (value.empty()) return std::nullopt;
    const auto number = text::parse_double(value);
    if (!number) note(value, "unparsed", fmt::format("{} is not a number in the column {}; left out", value, column));
    return number;
}

std::optional<std::int64_t> CsvRow::integer(std::string_view column) const {
    const std::string value = text(column);
    if (value.empty()) return std::nullopt;
    const auto number = text::parse_integer(value);
    if (number) return static_cast<std::int64_t>(*number);
    note(value, "unparsed", fmt::format("{} is not a whole number in the column {}; left out", value, column));
    return std::nullopt;
}

std::string CsvRow::date(std::string_view column) const {
    const std::string value = text(column);
    if (value.empty()) return {};
    if (const auto date = iso_date(value)) return *date;
    note(value, "unparsed", fmt::format("{} is not a date in the column {} (2025-06-01); left out", value, column));
    return {};
}

UnitName CsvRow::unit(std::string_view column, std::string_view area_column) const {
    const std::string area = text(area_column);
    return area.empty() ? builder_->name(text(column)) : builder_->name(area, text(column));
}

UnitName CsvRow::unit_near(const UnitName& near, std::string_view text, std::string_view area) const {
    if (!text::trim(area).empty()) return builder_->name(area, text);
    UnitName name = builder_->name(text);
    if (text.find("::") == std::string_view::npos) name.area = near.area;
    return name;
}

void read_csv_row(CsvTable table, const CsvRow& row, RecordBuilder& builder) {
    switch (table) {
    case CsvTable::Units: return read_unit(row, builder);
    case CsvTable::Relations: return read_relation(row, builder);
    case CsvTable::Members: return builder.add_member(row.text("group"), row.unit());
    case CsvTable::Levels: return read_level(row, builder);
    case CsvTable::Finds: return read_find(row, builder);
    case CsvTable::Samples: return read_sample(row, builder);
    case CsvTable::Documents: return read_document(row, builder);
    case CsvTable::Datings: return read_dating(row, builder);
    case CsvTable::Phases: return read_phase(row, builder);
    case CsvTable::Periods: return read_period(row, builder);
    case CsvTable::Groups: return read_group(row, builder);
    case CsvTable::Areas: return read_area(row, builder);
    }
}

} // namespace planum::strat
