// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/project/project.hpp"
#include "app/records/relation_entry.hpp"

namespace planum::app {

// Corrections of what the field wrote. Each is one undo step with author and reason (a Decision of kind
// `revision`), and what was written stays readable: the row is marked deleted, its statements stay in the log.
// All throw NotFound for relations that are gone and Usage without a reason.

/// The relation was not so: it counts no more.
void withdraw_relation(Project& project, model::RelationId id, std::string_view because);

/// It may be so: it stays, marked uncertain.
void mark_uncertain(Project& project, model::RelationId id, std::string_view because);

/// It was another: `instead` takes its place (or one more statement where it is there already).
void replace_relation(Project& project, model::RelationId id, const SaidRelation& instead, std::string_view because);

/// The unit is really two: a new one with that number and the same kind, area and phase takes over the relations
/// named. Returns its id. Throws as adding a unit does for a number that is taken.
model::UnitId split_unit(Project& project, model::UnitId unit, std::string_view number,
                         const std::vector<model::RelationId>& moved, std::string_view because);

} // namespace planum::app
