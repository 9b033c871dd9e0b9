// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/model/relation.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::strat {

/// A relation somebody is about to add.
struct NewRelation {
    UnitIndex subject = model::kNoUnit;
    model::RelationKind kind = model::RelationKind::Covers;
    UnitIndex object = model::kNoUnit;
};

enum class Consequence {
    None,          ///< nothing is closed
    SelfRelation,  ///< a unit above itself
    ClosesCycle,   ///< the path runs from the earlier unit of the new relation down to the later one
    OrdersSame,    ///< same_as between units that a path orders: merging them closes a cycle
    OrdersTogether ///< bonds_with or contemporary between units that a path orders
};

struct Prediction {
    Consequence consequence = Consequence::None;
    std::vector<std::uint32_t> path; ///< a shortest one, positions in matrix.orders(), from later to earlier
};

/// What adding one relation would do, without building anything: one search over the orders, at worst
/// O(units + orders). Units must be ones of the matrix's record.
[[nodiscard]] Prediction predict(const HarrisMatrix& matrix, const NewRelation& relation);

} // namespace planum::strat
