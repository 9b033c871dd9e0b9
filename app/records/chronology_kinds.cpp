// SPDX-License-Identifier: MIT
#include "app/records/field_table.hpp"

namespace planum::app {

namespace {

std::vector<Field<model::Period>> period_fields() {
    using P = model::Period;
    return {text_field<P>("title", "name in full", &P::title),
            text_field<P>("description", "description", &P::description),
            integer_field<P>("from", "first year, negative = BCE", &P::from),
            integer_field<P>("to", "last year, negative = BCE", &P::to),
            integer_field<P>("rank", "order in time, 1 = earliest", &P::rank)};
}

std::vector<Field<model::Phase>> phase_fields() {
    using P = model::Phase;
    return {text_field<P>("title", "name in full", &P::title),
            text_field<P>("description", "description", &P::description),
            named_field<P, model::Period>("period", "its period", &P::period, &model::Record::periods,
                                          &model::Period::number),
            integer_field<P>("from", "first year, negative = BCE", &P::from),
            integer_field<P>("to", "last year, negative = BCE", &P::to),
            integer_field<P>("rank", "order in time, 1 = earliest", &P::rank)};
}

std::vector<Field<model::UnitGroup>> group_fields() {
    using G = model::UnitGroup;
    std::vector<Field<G>> fields = {
        text_field<G>("type", "group, subgroup, landuse, activity, …", &G::type),
        text_field<G>("title", "name in full", &G::title), text_field<G>("description", "description", &G::description),
        named_field<G, model::UnitGroup>("parent", "group it is part of", &G::parent, &model::Record::groups,
                                         &model::UnitGroup::number)};
    fields.push_back({{"members", "its units, separated by commas"},
                      [](const G& group, Project& project) {
                          std::vector<std::string> names;
                          names.reserve(group.members.size());
                          for (const model::UnitId member : group.members)
                              names.push_back(project.index().name(member));
                          return text::join(names, ", ");
                      },
                      [](G& group, const std::string& text, Project& project) {
                          group.members.clear();
                          for (const std::string_view part : text::split(text, ',')) {
                              if (text::trim(part).empty()) continue;
                              group.members.push_back(project.record().units[project.unit_named(text::trim(part))].id);
                          }
                      }});
    return fields;
}

std::vector<Field<model::Dating>> dating_fields() {
    using D = model::Dating;
    return {
        unit_field<D>("unit", "unit it dates", &D::unit),
        word_field<D>("kind", "kind of evidence", &D::kind, model::dating_kind_from_word,
                      "typed, find, coin, radiocarbon, post-quem, ante-quem"),
        integer_field<D>("from", "earliest year, negative = BCE", &D::from),
        integer_field<D>("to", "latest year, negative = BCE", &D::to),
        number_field<D>("bp", "uncalibrated radiocarbon age [years BP]", &D::bp),
        number_field<D>("bp-error", "its sigma [years]", &D::bp_error),
        named_field<D, model::Find>("find", "find it rests on", &D::find, &model::Record::finds, &model::Find::number),
        text_field<D>("association", "direct, disjunct, disparate", &D::association),
        text_field<D>("notes", "notes", &D::notes)};
}

} // namespace

void add_chronology_kinds(std::vector<std::unique_ptr<RecordKind>>& kinds) {
    using model::Record;
    kinds.push_back(
        std::make_unique<NamedKind<model::Phase>>("phase", &Record::phases, &model::Phase::number, phase_fields()));
    kinds.push_back(std::make_unique<NamedKind<model::Period>>("period", &Record::periods, &model::Period::number,
                                                               period_fields()));
    kinds.push_back(std::make_unique<NamedKind<model::UnitGroup>>("group", &Record::groups, &model::UnitGroup::number,
                                                                  group_fields()));
    kinds.push_back(
        std::make_unique<NamedKind<model::Dating>>("dating", &Record::datings, &model::Dating::label, dating_fields()));
}

} // namespace planum::app
