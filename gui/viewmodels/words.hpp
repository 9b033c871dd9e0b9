// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <string>
#include <string_view>

#include "core/model/diagnostic.hpp"
#include "core/model/measured.hpp"
#include "core/model/place.hpp"
#include "core/model/record.hpp"
#include "core/model/relation.hpp"
#include "core/model/unit.hpp"

namespace planum::gui {

[[nodiscard]] QString qt(std::string_view utf8);

/// A measure with so many decimals, written as in the language of the window; never grouped, as coordinates are not.
[[nodiscard]] QString number_word(double value, int decimals);

// Words of the record in the language of the window.

/// `fill`, `masonry`, `cut`: the form where there is one, else the kind; empty for unknown.
[[nodiscard]] QString kind_word(model::UnitKind kind, model::UnitForm form);
[[nodiscard]] QString status_word(model::UnitStatus status);
/// `covers`, or read from the other side `covered by`.
[[nodiscard]] QString relation_word(model::DirectedKind kind);
[[nodiscard]] QString severity_word(model::Severity severity);
[[nodiscard]] QString level_word(model::LevelRole role);
[[nodiscard]] QString category_word(model::RegionCategory category);
/// What is written on an outline: the number of its unit, or what it encloses.
[[nodiscard]] QString outline_word(const model::RecordIndex& index, const model::Region& region);
/// `shows: its top`, as the outline tool offers it.
[[nodiscard]] QString shows_word(model::RegionShows shows);
/// What a check is about, from its code: `cycle` → "Cycle".
[[nodiscard]] QString check_title(std::string_view code);

} // namespace planum::gui
