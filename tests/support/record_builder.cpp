// SPDX-License-Identifier: MIT
#include "tests/support/record_builder.hpp"

#include <stdexcept>

namespace planum::test {

RecordBuilder& RecordBuilder::unit(std::string_view number, model::UnitKind kind, model::UnitForm form) {
    for (const model::StratigraphicUnit& unit : record_.units) {
        if (unit.number == number) return *this;
    }
    model::StratigraphicUnit unit;
    unit.id = model::UnitId{ids_.next()};
    unit.number = number;
    unit.kind = kind;
    unit.form = form;
    record_.units.push_back(unit);
    return *this;
}

RecordBuilder& RecordBuilder::relation(std::string_view subject, model::RelationKind kind, std::string_view object,
                                       model::Certainty certainty) {
    unit(subject);
    unit(object);
    model::PhysicalRelation relation;
    relation.id = model::RelationId{ids_.next()};
    relation.subject = at(subject).id;
    relation.kind = kind;
    relation.object = at(object).id;
    relation.certainty = certainty;
    model::RelationStatement statement;
    statement.id = model::StatementId{ids_.next()};
    statement.relation = relation.id;
    record_.relations.push_back(relation);
    record_.statements.push_back(statement);
    return *this;
}

RecordBuilder& RecordBuilder::level(std::string_view unit_number, model::LevelRole role, double z) {
    unit(unit_number);
    model::Level level;
    level.id = model::LevelId{ids_.next()};
    level.unit = at(unit_number).id;
    level.role = role;
    level.z = z;
    record_.levels.push_back(level);
    return *this;
}

model::Record RecordBuilder::record() const {
    model::Record sorted = record_;
    model::sort_record(sorted);
    return sorted;
}

model::StratigraphicUnit& RecordBuilder::at(std::string_view number) {
    for (model::StratigraphicUnit& unit : record_.units) {
        if (unit.number == number) return unit;
    }
    throw std::out_of_range(std::string(number));
}

} // namespace planum::test
