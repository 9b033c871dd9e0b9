// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "core/model/chronology.hpp"

namespace planum::strat {

/// Years of a date written as text; an end that is not there is open ("630 CE : present").
struct YearSpan {
    std::optional<model::Year> from;
    std::optional<model::Year> to;

    friend bool operator==(const YearSpan&, const YearSpan&) = default;
};

/// The years that a dating says: `Late Umm an-Nar (-2200 : -2000)`, `98-117 AD`, `(630 CE : present)`,
/// `300-200 a.C.`, `13th century`, `XV secolo`. Only what is certain: a text with words around the years,
/// outside brackets, or without years gives nullopt. Of several bracketed spans the first counts.
[[nodiscard]] std::optional<YearSpan> years_in_text(std::string_view utf8);

} // namespace planum::strat
