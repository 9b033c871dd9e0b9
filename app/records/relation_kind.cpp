// SPDX-License-Identifier: MIT
#include "app/records/field_table.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include "app/records/relation_entry.hpp"

namespace planum::app {

using model::PhysicalRelation;

namespace {

std::vector<Field<PhysicalRelation>> relation_fields() {
    using R = PhysicalRelation;
    std::vector<Field<R>> fields = {
        word_field<R>("certainty", "how sure", &R::certainty, model::certainty_from_word, "certain, uncertain")};
    fields.push_back({{"correlation", "same_as across a gap (yes, no)"},
                      [](const R& relation, Project&) { return std::string(relation.correlation ? "yes" : ""); },
                      [](R& relation, const std::string& text, Project&) { relation.correlation = text == "yes"; }});
    return fields;
}

// Relations are named as they are said: `1042 cuts 1017`, in any of the four languages, from either side.
class RelationRecordKind final : public FieldTableKind<PhysicalRelation> {
  public:
    RelationRecordKind()
        : FieldTableKind("relation", "UNIT RELATION UNIT", &model::Record::relations, relation_fields()) {}

    std::string add(Project& project, const std::string& name, const FieldValues& values) const override {
        const SaidRelation said = parse_relation(project, name);
        RelationEntry entry;
        entry.said = said;
        for (const auto& [field, text] : values) {
            if (field == "certainty" && text == "uncertain") entry.certainty = model::Certainty::Uncertain;
            if (field == "correlation" && text == "yes") entry.correlation = true;
            if (field == "certainty" && !model::certainty_from_word(text)) {
                throw Error(ErrorCode::BadInput, "certainty: " + text + " is none of certain, uncertain");
            }
        }
        return add_relation(project, entry, name);
    }

  protected:
    [[nodiscard]] std::string name_of(const PhysicalRelation& relation, Project& project) const override {
        return fmt::format("{} {} {}", project.index().name(relation.subject), to_word(relation.kind),
                           project.index().name(relation.object));
    }

    [[nodiscard]] PhysicalRelation make(Project&, const std::string& name) const override {
        throw Error(ErrorCode::Internal, "relations are made by add_relation: " + name);
    }

    [[nodiscard]] const PhysicalRelation& find(Project& project, const std::string& name) const override {
        const SaidRelation said = parse_relation(project, name);
        const model::RecordIndex& index = project.index();
        const auto key = [&](const auto& one) {
            return std::tuple(index.find(one.subject), index.find(one.object), one.kind);
        };
        // Records keep relations in this order; a walk through all for each of 100,000 listed takes seconds.
        const std::vector<PhysicalRelation>& all = project.record().relations;
        const auto at = std::lower_bound(all.begin(), all.end(), key(said),
                                         [&](const PhysicalRelation& r, const auto& k) { return key(r) < k; });
        if (at == all.end() || key(*at) != key(said)) throw Error(ErrorCode::NotFound, "no relation " + name);
        return *at;
    }
};

} // namespace

std::unique_ptr<RecordKind> make_relation_kind() { return std::make_unique<RelationRecordKind>(); }

} // namespace planum::app
