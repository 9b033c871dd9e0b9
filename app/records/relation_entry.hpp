// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/project/project.hpp"
#include "app/project/snapshot.hpp"
#include "core/model/relation.hpp"

namespace planum::app {

/// A relation as somebody said it, turned so that it reads from the side it is stored from.
struct SaidRelation {
    model::UnitId subject;
    model::RelationKind kind = model::RelationKind::Covers;
    model::UnitId object;
    model::StatementSide side = model::StatementSide::Subject;
};

/// Reads `UNIT RELATION UNIT` (`1042 cut by 1017`, `12 liegt über 14`); names may hold blanks. Throws Usage when it is
/// not of that form, BadInput for an unknown word (with those that are known), NotFound for a unit.
[[nodiscard]] SaidRelation parse_relation(Project& project, std::string_view sentence);

struct RelationEntry {
    SaidRelation said;
    model::Certainty certainty = model::Certainty::Certain;
    bool correlation = false;
};

/// Adds the relation, or one more statement of it where it is there already. Returns its name. Never refuses
/// what closes a cycle: the record is not bent; ask would_close_cycle first and warn.
std::string add_relation(Project& project, const RelationEntry& entry, std::string_view as_written);

/// The units of a cycle that the relation would close, from its subject over the path that leads back to it;
/// empty when it closes none. Same_as and contemporary between units that a path orders count, too.
[[nodiscard]] std::vector<model::UnitId> would_close_cycle(Project& project, const SaidRelation& relation);
/// The same while somebody types: nothing is built, so the answer comes in microseconds.
[[nodiscard]] std::vector<model::UnitId> would_close_cycle(const Snapshot& snapshot, const SaidRelation& relation);

/// Turns what was said from one of the two units (`a` is cut by `b`) into the form it is stored in.
[[nodiscard]] SaidRelation said_relation(const model::Record& record, model::UnitIndex a, model::DirectedKind kind,
                                         model::UnitIndex b);

} // namespace planum::app
