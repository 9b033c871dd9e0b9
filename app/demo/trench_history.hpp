// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "app/demo/random.hpp"
#include "core/model/relation.hpp"
#include "core/model/unit.hpp"

namespace planum::app {

/// A column of ground that belongs to one unit in the finished trench.
struct TrenchCell {
    double x = 0.0; ///< [m] in the trench
    double y = 0.0;
    double top = 0.0; ///< height [m]
    double base = 0.0;
};

struct TrenchUnit {
    model::UnitKind kind = model::UnitKind::Deposit;
    model::UnitForm form = model::UnitForm::None;
    double formed = 0.0;           ///< place in time, ascending
    std::vector<TrenchCell> cells; ///< what is left of it; empty: nothing, nobody ever saw it
};

/// `later` touched `earlier` when it came to be.
struct TrenchContact {
    std::uint32_t later = 0;
    std::uint32_t earlier = 0;
    model::RelationKind kind = model::RelationKind::Covers;
    std::uint32_t cells = 0; ///< size of the contact

    friend auto operator<=>(const TrenchContact&, const TrenchContact&) = default;
};

/// How one trench came to be.
struct TrenchHistory {
    std::vector<TrenchUnit> units; ///< in the order of their forming; the first is natural ground
    std::vector<TrenchContact> contacts;
};

/// Lets about `units` units form on a grid of half-metre cells (10 by 7 m): layers, pits and graves with
/// their fills, walls with layers against them, on gently sloping ground. Contacts and heights follow from
/// the ground itself, cell by cell, and from nothing else. Units that later pits took away altogether are
/// left out, so that somewhat fewer may come back.
[[nodiscard]] TrenchHistory simulate_trench(Random& random, std::size_t units);

} // namespace planum::app
