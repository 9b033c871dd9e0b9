// SPDX-License-Identifier: MIT
#include "app/records/field_table.hpp"

namespace planum::app {

using model::StratigraphicUnit;

namespace {

// The first screen: what fits on it with gloves on.
std::vector<Field<StratigraphicUnit>> first_fields() {
    using U = StratigraphicUnit;
    std::vector<Field<U>> fields;
    fields.push_back({{"kind", "kind, or a word that means kind and form (deposit, layer, fill, cut, feature, "
                               "structure, masonry, timber, interface, skeleton, natural, void; de, it, fr too)"},
                      [](const U& unit, Project&) { return std::string(to_word(unit.kind)); },
                      [](U& unit, const std::string& text, Project&) {
                          const auto meaning = model::kind_from_any_word(text);
                          if (!meaning) throw Error(ErrorCode::BadInput, "kind: " + text + " is no kind of unit");
                          unit.kind = meaning->kind;
                          if (meaning->form != model::UnitForm::None) unit.form = meaning->form;
                      }});
    fields.push_back(word_field<U>("form", "form", &U::form, model::from_word<model::UnitForm>,
                                   "layer, fill, masonry, timber, burial"));
    fields.push_back(word_field<U>("status", "status", &U::status, model::from_word<model::UnitStatus>,
                                   "open, partly-excavated, excavated, not-excavated, void"));
    fields.push_back(text_field<U>("title", "short definition", &U::title));
    fields.push_back(text_field<U>("description", "description", &U::description));
    fields.push_back(text_field<U>("interpretation", "interpretation", &U::interpretation));
    fields.push_back(date_field<U>("excavated-from", "day digging began", &U::excavated_from));
    fields.push_back(date_field<U>("excavated-on", "day it was dug away", &U::excavated_on));
    fields.push_back(text_field<U>("recorded-by", "recorded by", &U::recorded_by));
    fields.push_back(date_field<U>("recorded-on", "day of recording", &U::recorded_on));
    fields.push_back(
        named_field<U, model::Area>("area", "trench", &U::area, &model::Record::areas, &model::Area::name));
    fields.push_back(
        named_field<U, model::Phase>("phase", "phase", &U::phase, &model::Record::phases, &model::Phase::number));
    fields.push_back(
        named_field<U, model::Period>("period", "period", &U::period, &model::Record::periods, &model::Period::number));
    fields.push_back(unit_field<U>("parent", "feature it is part of", &U::parent));
    return fields;
}

std::vector<Field<StratigraphicUnit>> all_fields() {
    std::vector<Field<StratigraphicUnit>> fields = first_fields();
    for (const model::UnitFieldInfo& info : model::kUnitFields) {
        const std::string key{info.name};
        fields.push_back({{text::replace_all(info.name, "_", "-"), std::string(info.label)},
                          [key](const StratigraphicUnit& unit, Project&) {
                              const auto it = unit.details.find(key);
                              return it == unit.details.end() ? std::string{} : it->second;
                          },
                          [key](StratigraphicUnit& unit, const std::string& text, Project&) {
                              if (text.empty()) {
                                  unit.details.erase(key);
                              } else {
                                  unit.details[key] = text;
                              }
                          }});
    }
    return fields;
}

// Units are named NUMBER, or AREA::NUMBER where the number alone is not unique.
class UnitRecordKind final : public FieldTableKind<StratigraphicUnit> {
  public:
    UnitRecordKind() : FieldTableKind("unit", "NUMBER", &model::Record::units, all_fields()) {}

  protected:
    [[nodiscard]] std::string name_of(const StratigraphicUnit& unit, Project& project) const override {
        return project.index().name(unit.id);
    }

    [[nodiscard]] StratigraphicUnit make(Project& project, const std::string& name) const override {
        StratigraphicUnit unit;
        unit.number = std::string(text::trim(name));
        const std::size_t colons = unit.number.find("::");
        if (colons != std::string::npos) {
            const std::string area = unit.number.substr(0, colons);
            unit.number = unit.number.substr(colons + 2);
            for (const model::Area& candidate : project.record().areas) {
                if (candidate.name == area) unit.area = candidate.id;
            }
            if (unit.area.is_nil()) throw Error(ErrorCode::NotFound, "no area " + area + "; add it first");
        }
        if (unit.number.empty()) throw Error(ErrorCode::BadInput, "a unit needs a number");
        return unit;
    }

    [[nodiscard]] const StratigraphicUnit& find(Project& project, const std::string& name) const override {
        return project.record().units[project.unit_named(name)];
    }

    void write(Project& project, const StratigraphicUnit& unit) const override {
        StratigraphicUnit sheet = unit;
        sheet.origin = model::UnitOrigin::Recorded; // whoever fills fields writes its sheet
        project.file().update(sheet);
    }
};

} // namespace

std::unique_ptr<RecordKind> make_unit_kind() { return std::make_unique<UnitRecordKind>(); }

} // namespace planum::app
