// SPDX-License-Identifier: MIT
#include "app/records/field_table.hpp"

namespace planum::app {

namespace {

std::vector<Field<model::Find>> find_fields() {
    using F = model::Find;
    return {unit_field<F>("unit", "unit it was found in", &F::unit),
            number_field<F>("x", "site grid [m]", &F::x),
            number_field<F>("y", "site grid [m]", &F::y),
            number_field<F>("z", "height [m]", &F::z),
            text_field<F>("type", "what it is", &F::type),
            text_field<F>("material", "material", &F::material),
            integer_field<F>("count", "how many", &F::count),
            number_field<F>("weight", "weight [g]", &F::weight),
            text_field<F>("condition", "condition", &F::condition),
            text_field<F>("box", "box or bag", &F::box),
            date_field<F>("found-on", "day it was found", &F::found_on),
            text_field<F>("description", "description", &F::description)};
}

std::vector<Field<model::Sample>> sample_fields() {
    using S = model::Sample;
    return {unit_field<S>("unit", "unit it was taken from", &S::unit),
            text_field<S>("type", "soil, C14, charcoal, pollen, …", &S::type),
            number_field<S>("volume", "volume [l]", &S::volume),
            number_field<S>("weight", "weight [g]", &S::weight),
            text_field<S>("laboratory-number", "number the laboratory gave", &S::laboratory_number),
            text_field<S>("state", "stored, submitted, analysed, discarded", &S::state),
            text_field<S>("description", "description", &S::description)};
}

std::vector<Field<model::Document>> document_fields() {
    using D = model::Document;
    return {unit_field<D>("unit", "unit it shows", &D::unit),
            text_field<D>("type", "photo, drawing, sheet, …", &D::type),
            text_field<D>("title", "title", &D::title),
            text_field<D>("path", "file, relative to the project", &D::path),
            date_field<D>("made-on", "day it was made", &D::made_on),
            text_field<D>("author", "author", &D::author)};
}

std::vector<Field<model::Level>> level_fields() {
    using L = model::Level;
    std::vector<Field<L>> fields = {word_field<L>("role", "what the height stands for", &L::role,
                                                  model::level_role_from_word, "top, base, cut, other"),
                                    number_field<L>("x", "site grid [m]", &L::x),
                                    number_field<L>("y", "site grid [m]", &L::y)};
    fields.push_back({{"z", "height [m]"},
                      [](const L& level, Project&) { return fmt::format("{}", level.z); },
                      [](L& level, const std::string& text, Project&) {
                          const auto z = number_from("z", text);
                          if (!z) throw Error(ErrorCode::BadInput, "z: a level needs a height");
                          level.z = *z;
                      }});
    fields.push_back(text_field<L>("label", "label", &L::label));
    return fields;
}

// Levels have no name of their own: the second top of 1042 is `1042/top#2`; to add one, name its unit.
class LevelKind final : public FieldTableKind<model::Level> {
  public:
    LevelKind() : FieldTableKind("level", "UNIT (to add) or UNIT/ROLE#n", &model::Record::levels, level_fields()) {}

  protected:
    [[nodiscard]] std::string name_of(const model::Level& level, Project& project) const override {
        std::size_t n = 0;
        for (const model::Level& other : project.record().levels) {
            if (other.unit == level.unit && other.role == level.role) ++n;
            if (other.id == level.id) break;
        }
        return fmt::format("{}/{}#{}", project.index().name(level.unit), to_word(level.role), n);
    }

    [[nodiscard]] model::Level make(Project& project, const std::string& name) const override {
        model::Level level;
        level.unit = project.record().units[project.unit_named(name)].id;
        return level;
    }
};

} // namespace

void add_measured_kinds(std::vector<std::unique_ptr<RecordKind>>& kinds) {
    using model::Record;
    kinds.push_back(
        std::make_unique<NamedKind<model::Find>>("find", &Record::finds, &model::Find::number, find_fields()));
    kinds.push_back(std::make_unique<LevelKind>());
    kinds.push_back(std::make_unique<NamedKind<model::Sample>>("sample", &Record::samples, &model::Sample::number,
                                                               sample_fields()));
    kinds.push_back(std::make_unique<NamedKind<model::Document>>("document", &Record::documents,
                                                                 &model::Document::number, document_fields()));
}

} // namespace planum::app
