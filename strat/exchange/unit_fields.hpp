// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "strat/exchange/record_builder.hpp"

namespace planum::strat {

/// Appends a line `name=value` to the free fields of a unit; an empty value adds nothing.
void add_custom_field(ImportedUnit& unit, std::string_view name, std::string_view value);

/// The kind that a definition in words means: the whole, its first word (`Strato di terra`, `Pit: fill` by
/// what stands behind the colon) or its last (`Stone wall`).
[[nodiscard]] std::optional<model::KindAndForm> kind_from_definition(std::string_view definition);

/// Sets kind and form from such words; the words themselves are kept as title where there is none, and as
/// a free field `type` where they are not understood.
void set_kind(ImportedUnit& unit, std::string_view definition);

/// A year as files write it: whole, `-1200.0`, or text; nullopt for anything else.
[[nodiscard]] std::optional<model::Year> year_from_text(std::string_view text);

} // namespace planum::strat
