// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/model/record.hpp"
#include "strat/layout/layout_engine.hpp"

namespace planum::app {

/// Two states of one record put into one, with what tells them apart.
struct Comparison {
    model::Record both; ///< units and relations of either; where both have one, the later state's
    std::vector<strat::UnitMark> units;
    std::vector<strat::OrderMark> orders;
};

/// Units and relations only in `after` are added, those only in `before` removed; a pair of units whose
/// relations changed their kind or certainty is changed, and so are units in both whose relations are not the
/// same. Units are known by their id, relations by the units they join.
[[nodiscard]] Comparison compare_readings(const model::Record& before, const model::Record& after);

} // namespace planum::app
