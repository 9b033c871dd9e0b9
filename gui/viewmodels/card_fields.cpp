// SPDX-License-Identifier: MIT
#include "gui/viewmodels/unit_card_model.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <array>
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

// The labels of model::kUnitFields, for those who translate; tests/gui/gui_viewmodels/log_words_test.cpp holds them to
// these.
[[maybe_unused]] constexpr std::array kDetailLabels = {
    QT_TRANSLATE_NOOP("card", "Site code"),
    QT_TRANSLATE_NOOP("card", "Sector"),
    QT_TRANSLATE_NOOP("card", "Square"),
    QT_TRANSLATE_NOOP("card", "Room or functional unit"),
    QT_TRANSLATE_NOOP("card", "Position"),
    QT_TRANSLATE_NOOP("card", "Formation (natural, artificial)"),
    QT_TRANSLATE_NOOP("card", "Criteria of distinction"),
    QT_TRANSLATE_NOOP("card", "Mode of formation"),
    QT_TRANSLATE_NOOP("card", "Compaction or consistency"),
    QT_TRANSLATE_NOOP("card", "Colour"),
    QT_TRANSLATE_NOOP("card", "Munsell colour"),
    QT_TRANSLATE_NOOP("card", "Composition"),
    QT_TRANSLATE_NOOP("card", "Inclusions"),
    QT_TRANSLATE_NOOP("card", "Organic components"),
    QT_TRANSLATE_NOOP("card", "Inorganic components"),
    QT_TRANSLATE_NOOP("card", "Thickness"),
    QT_TRANSLATE_NOOP("card", "Length"),
    QT_TRANSLATE_NOOP("card", "Width"),
    QT_TRANSLATE_NOOP("card", "Depth"),
    QT_TRANSLATE_NOOP("card", "Shape in plan"),
    QT_TRANSLATE_NOOP("card", "Profile"),
    QT_TRANSLATE_NOOP("card", "Corners"),
    QT_TRANSLATE_NOOP("card", "Break of slope, top and base"),
    QT_TRANSLATE_NOOP("card", "Sides"),
    QT_TRANSLATE_NOOP("card", "Base"),
    QT_TRANSLATE_NOOP("card", "Orientation"),
    QT_TRANSLATE_NOOP("card", "Borders"),
    QT_TRANSLATE_NOOP("card", "Truncation"),
    QT_TRANSLATE_NOOP("card", "Preservation"),
    QT_TRANSLATE_NOOP("card", "Disturbance"),
    QT_TRANSLATE_NOOP("card", "Masonry: materials, size, finish"),
    QT_TRANSLATE_NOOP("card", "Masonry: coursing and bond"),
    QT_TRANSLATE_NOOP("card", "Masonry: form and faces"),
    QT_TRANSLATE_NOOP("card", "Masonry: bonding material"),
    QT_TRANSLATE_NOOP("card", "Timber: type and setting"),
    QT_TRANSLATE_NOOP("card", "Timber: cross-section, conversion"),
    QT_TRANSLATE_NOOP("card", "Timber: tool marks, joints"),
    QT_TRANSLATE_NOOP("card", "Skeleton: position"),
    QT_TRANSLATE_NOOP("card", "Skeleton: completeness, truncation"),
    QT_TRANSLATE_NOOP("card", "Excavation method"),
    QT_TRANSLATE_NOOP("card", "Per cent excavated"),
    QT_TRANSLATE_NOOP("card", "Conditions"),
    QT_TRANSLATE_NOOP("card", "Sieving"),
    QT_TRANSLATE_NOOP("card", "Flotation"),
    QT_TRANSLATE_NOOP("card", "Reliability of the stratigraphy"),
    QT_TRANSLATE_NOOP("card", "Activity"),
    QT_TRANSLATE_NOOP("card", "Dating evidence"),
    QT_TRANSLATE_NOOP("card", "Observations"),
    QT_TRANSLATE_NOOP("card", "Scientific director"),
    QT_TRANSLATE_NOOP("card", "Checked by"),
    QT_TRANSLATE_NOOP("card", "Checked on"),
    QT_TRANSLATE_NOOP("card", "Revised by"),
    QT_TRANSLATE_NOOP("card", "Revised on"),
    QT_TRANSLATE_NOOP("card", "Free fields (name=value lines)"),
};

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
