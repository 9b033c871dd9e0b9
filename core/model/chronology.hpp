// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/ids.hpp"

namespace planum::model {

/// Years are astronomical-free calendar years as excavators write them: negative = BCE.
using Year = std::int64_t;

/// A period of the site ("Early Bronze Age"), interpretation above units.
struct Period {
    PeriodId id;
    std::string number; ///< short name, unique
    std::string title;
    std::string description;
    std::optional<Year> from;         ///< earliest year
    std::optional<Year> to;           ///< latest year
    std::optional<std::int64_t> rank; ///< order in time, 1 = earliest; unset: unknown

    friend bool operator==(const Period&, const Period&) = default;
};

/// A phase: units formed in the same span of the site's history. Compares *formation*.
struct Phase {
    PhaseId id;
    std::string number;
    std::string title;
    std::string description;
    PeriodId period;
    std::optional<Year> from;
    std::optional<Year> to;
    std::optional<std::int64_t> rank; ///< order in time within its period (or the site), 1 = earliest

    friend bool operator==(const Phase&, const Phase&) = default;
};

/// Units taken together by somebody: a house, a grave, an activity, a land use. May nest.
struct UnitGroup {
    GroupId id;
    std::string number;
    std::string type; ///< group, subgroup, landuse, activity, feature, …
    std::string title;
    std::string description;
    GroupId parent;
    std::vector<UnitId> members;

    friend bool operator==(const UnitGroup&, const UnitGroup&) = default;
};

/// What kind of dating evidence; decides which side of a unit's date it can bound.
enum class DatingKind {
    Typed,       ///< somebody's date for the unit itself: bounds both sides
    Find,        ///< not earlier than
    Coin,        ///< not earlier than
    Radiocarbon, ///< not earlier than (the wood may be old, the bone redeposited)
    PostQuem,    ///< terminus post quem: not earlier than
    AnteQuem,    ///< terminus ante quem: not later than
};

/// One dating of one unit. Which of `from` and `to` binds follows from the kind.
struct Dating {
    DatingId id;
    std::string label; ///< laboratory number, coin, "Late Umm an-Nar"
    UnitId unit;
    FindId find;
    DatingKind kind = DatingKind::Typed;
    std::optional<Year> from;
    std::optional<Year> to;
    std::optional<double> bp;       ///< uncalibrated radiocarbon age [years BP]
    std::optional<double> bp_error; ///< its σ [years]
    std::string association;        ///< direct, disjunct, disparate, as the source says
    std::string notes;

    friend bool operator==(const Dating&, const Dating&) = default;
};

[[nodiscard]] std::string_view to_word(DatingKind kind) noexcept;
[[nodiscard]] std::optional<DatingKind> dating_kind_from_word(std::string_view word) noexcept;

} // namespace planum::model
