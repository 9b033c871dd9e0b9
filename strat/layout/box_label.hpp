// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/model/unit.hpp"
#include "strat/layout/drawing.hpp"
#include "strat/layout/text_measure.hpp"

namespace planum::strat {

[[nodiscard]] BoxShape shape_of(const model::StratigraphicUnit& unit);

/// Whether the title says so, in the words of our four languages: such units lie on top.
[[nodiscard]] bool names_topsoil(const model::StratigraphicUnit& unit);

/// At most three lines; what does not fit ends in an ellipsis.
[[nodiscard]] std::vector<std::string> broken_title(const std::string& title, const TextMeasure& measure);

/// `12 = 15 = 20`, broken where a line grows too wide; `=?` before those that are `doubtful`. `names` has one at least,
/// and both as many.
[[nodiscard]] std::vector<std::string> joined_names(const std::vector<std::string>& names,
                                                    const std::vector<bool>& doubtful, const TextMeasure& measure);

/// Sets the widths of the lines and the size of the box around them.
void size_box(DrawnBox& box, const TextMeasure& measure);

/// A name as part of an XML id: letters, digits, '-' and '.' stay, all else becomes `_xHH`, so that
/// different names stay different. So does a '-' behind another or at the end: no id holds `--`, which joins two
/// of them to the id of an order.
[[nodiscard]] std::string xml_id(std::string_view prefix, std::string_view name);

/// A link to a unit: `{unit}` in the pattern stands for its name, `{uuid}` for its id. Bytes of the name that mean
/// something in an address, or are not ASCII, become `%HH` (RFC 3986).
[[nodiscard]] std::string unit_link_of(std::string_view pattern, std::string_view name, const model::UnitId& id);

} // namespace planum::strat
