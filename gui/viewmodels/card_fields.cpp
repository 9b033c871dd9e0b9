// SPDX-License-Identifier: MIT
#include "gui/viewmodels/unit_card_model.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

#include "core/base/text.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

namespace {

using model::StratigraphicUnit;

QString label(const char* text) { return QCoreApplication::translate("card", text); }

CardField plain(std::string name, const char* text, const std::string& value) {
    CardField field;
    field.name = std::move(name);
    field.label = label(text);
    field.value = qt(value);
    return field;
}

CardField long_text(std::string name, const char* text, const std::string& value) {
    CardField field = plain(std::move(name), text, value);
    field.is_long = true;
    return field;
}

CardField kind_field(const StratigraphicUnit& unit) {
    using model::UnitForm;
    using model::UnitKind;
    static constexpr std::array<std::pair<UnitKind, UnitForm>, 13> kOffered = {
        {{UnitKind::Deposit, UnitForm::Layer},
         {UnitKind::Deposit, UnitForm::Fill},
         {UnitKind::Deposit, UnitForm::None},
         {UnitKind::Cut, UnitForm::None},
         {UnitKind::Feature, UnitForm::None},
         {UnitKind::Structure, UnitForm::Masonry},
         {UnitKind::Structure, UnitForm::Timber},
         {UnitKind::Structure, UnitForm::None},
         {UnitKind::Interface, UnitForm::None},
         {UnitKind::Skeleton, UnitForm::None},
         {UnitKind::Natural, UnitForm::None},
         {UnitKind::Void, UnitForm::None},
         {UnitKind::Unknown, UnitForm::None}}};
    CardField field;
    field.name = "kind";
    field.label = label(QT_TRANSLATE_NOOP("card", "Kind"));
    field.value = kind_word(unit.kind, unit.form);
    for (const auto& [kind, form] : kOffered) {
        field.choices << (kind == UnitKind::Unknown ? label(QT_TRANSLATE_NOOP("card", "not known"))
                                                    : kind_word(kind, form));
        field.stored << qt(form == UnitForm::None ? to_word(kind) : to_word(form));
    }
    if (unit.kind == UnitKind::Unknown) field.value = field.choices.back();
    return field;
}

CardField status_field(const StratigraphicUnit& unit) {
    using model::UnitStatus;
    CardField field;
    field.name = "status";
    field.label = label(QT_TRANSLATE_NOOP("card", "Status"));
    field.value = status_word(unit.status);
    for (const UnitStatus status : {UnitStatus::Open, UnitStatus::PartlyExcavated, UnitStatus::Excavated,
                                    UnitStatus::NotExcavated, UnitStatus::Void}) {
        field.choices << status_word(status);
        field.stored << qt(to_word(status));
    }
    return field;
}

// A field that names one of the things of the record; the empty choice unsets it.
template<class T, class IdType>
CardField named(std::string name, const char* text, IdType id, const std::vector<T>& all, std::string T::*name_of,
                std::string T::*title_of) {
    CardField field;
    field.name = std::move(name);
    field.label = label(text);
    field.choices << QString();
    field.stored << QString();
    for (const T& one : all) {
        const QString shown = (one.*title_of).empty() ? qt(one.*name_of) : qt(one.*name_of + "  " + one.*title_of);
        field.choices << shown;
        field.stored << qt(one.*name_of);
        if (one.id == id) field.value = shown;
    }
    return field;
}

QString block_label(std::string_view block) {
    static constexpr std::array<std::pair<std::string_view, const char*>, 13> kBlocks = {
        {{"header", QT_TRANSLATE_NOOP("card", "Site")},
         {"location", QT_TRANSLATE_NOOP("card", "Place")},
         {"formation", QT_TRANSLATE_NOOP("card", "Formation")},
         {"material", QT_TRANSLATE_NOOP("card", "Material")},
         {"measurements", QT_TRANSLATE_NOOP("card", "Measurements")},
         {"shape", QT_TRANSLATE_NOOP("card", "Shape")},
         {"preservation", QT_TRANSLATE_NOOP("card", "Preservation")},
         {"masonry", QT_TRANSLATE_NOOP("card", "Masonry")},
         {"timber", QT_TRANSLATE_NOOP("card", "Timber")},
         {"skeleton", QT_TRANSLATE_NOOP("card", "Skeleton")},
         {"excavation", QT_TRANSLATE_NOOP("card", "Excavation")},
         {"assessment", QT_TRANSLATE_NOOP("card", "Assessment")},
         {"signatures", QT_TRANSLATE_NOOP("card", "Signatures")}}};
    for (const auto& [key, text] : kBlocks) {
        if (key == block) return label(text);
    }
    return label(QT_TRANSLATE_NOOP("card", "Other"));
}

void add_details(const StratigraphicUnit& unit, std::vector<CardField>& fields) {
    for (const model::UnitFieldInfo& info : model::kUnitFields) {
        CardField field;
        field.name = text::replace_all(info.name, "_", "-");
        field.label = QCoreApplication::translate("card", std::string(info.label).c_str());
        field.block = block_label(info.block);
        const auto it = unit.details.find(info.name);
        if (it != unit.details.end()) field.value = qt(it->second);
        field.is_long = info.name == "observations" || info.name == "custom" || info.name == "inclusions";
        fields.push_back(std::move(field));
    }
}

} // namespace

std::vector<CardField> card_fields(const app::Snapshot& snapshot, model::UnitIndex at) {
    const model::Record& record = snapshot.record();
    const StratigraphicUnit& unit = record.units[at];
    std::vector<CardField> fields;
    fields.push_back(kind_field(unit));
    fields.push_back(status_field(unit));
    fields.push_back(plain("title", QT_TRANSLATE_NOOP("card", "Short definition"), unit.title));
    fields.push_back(long_text("description", QT_TRANSLATE_NOOP("card", "Description"), unit.description));
    fields.push_back(long_text("interpretation", QT_TRANSLATE_NOOP("card", "Interpretation"), unit.interpretation));
    fields.push_back(named("area", QT_TRANSLATE_NOOP("card", "Trench"), unit.area, record.areas, &model::Area::name,
                           &model::Area::title));
    fields.push_back(plain("excavated-on", QT_TRANSLATE_NOOP("card", "Dug away on"), unit.excavated_on));
    fields.push_back(plain("recorded-by", QT_TRANSLATE_NOOP("card", "Recorded by"), unit.recorded_by));
    // From here on: the full record.
    const std::size_t first = fields.size();
    fields.push_back(plain("recorded-on", QT_TRANSLATE_NOOP("card", "Recorded on"), unit.recorded_on));
    fields.push_back(plain("excavated-from", QT_TRANSLATE_NOOP("card", "Digging began on"), unit.excavated_from));
    fields.push_back(named("phase", QT_TRANSLATE_NOOP("card", "Phase"), unit.phase, record.phases,
                           &model::Phase::number, &model::Phase::title));
    fields.push_back(named("period", QT_TRANSLATE_NOOP("card", "Period"), unit.period, record.periods,
                           &model::Period::number, &model::Period::title));
    fields.push_back(plain("parent", QT_TRANSLATE_NOOP("card", "Part of feature"),
                           unit.parent.is_nil() ? std::string{} : snapshot.index().name(unit.parent)));
    for (std::size_t i = first; i < fields.size(); ++i)
        fields[i].block = label(QT_TRANSLATE_NOOP("card", "Dates and phases"));
    add_details(unit, fields);
    return fields;
}

} // namespace planum::gui
