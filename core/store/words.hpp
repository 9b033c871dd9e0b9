// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "core/model/record.hpp"

namespace planum::store {

/// The model's word tables under one name, so that a column needs to know its enumeration only.
template<class Enum>
[[nodiscard]] std::optional<Enum> value_of_word(std::string_view word) noexcept = delete;

#define PLANUM_STORE_WORD(Enum, function)                                                                              \
    template<>                                                                                                         \
    [[nodiscard]] inline std::optional<model::Enum> value_of_word<model::Enum>(std::string_view word) noexcept {       \
        return model::function(word);                                                                                  \
    }

PLANUM_STORE_WORD(DigMethod, dig_method_from_word)
PLANUM_STORE_WORD(NumberScope, number_scope_from_word)
PLANUM_STORE_WORD(Strictness, strictness_from_word)
PLANUM_STORE_WORD(UnitKind, from_word<model::UnitKind>)
PLANUM_STORE_WORD(UnitForm, from_word<model::UnitForm>)
PLANUM_STORE_WORD(UnitStatus, from_word<model::UnitStatus>)
PLANUM_STORE_WORD(UnitOrigin, from_word<model::UnitOrigin>)
PLANUM_STORE_WORD(RelationKind, relation_kind_from_word)
PLANUM_STORE_WORD(Certainty, certainty_from_word)
PLANUM_STORE_WORD(StatementSide, side_from_word)
PLANUM_STORE_WORD(DatingKind, dating_kind_from_word)
PLANUM_STORE_WORD(LevelRole, level_role_from_word)
PLANUM_STORE_WORD(RegionShows, region_shows_from_word)
PLANUM_STORE_WORD(RegionCategory, region_category_from_word)

#undef PLANUM_STORE_WORD

} // namespace planum::store
