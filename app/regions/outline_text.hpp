// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "core/geometry/gpb.hpp"

namespace planum::app {

/// An outline as people type it: `x y [z], x y [z], …` in site coordinates [m], or WKT POLYGON and MULTIPOLYGON, with
/// or without Z; a height that is not said is NaN. Throws BadInput with the word that was not understood.
[[nodiscard]] geometry::MultiPolygon parse_outline(std::string_view text);

/// WKT in millimetres; points whose height is NaN have none.
[[nodiscard]] std::string outline_text(const geometry::MultiPolygon& shape);

} // namespace planum::app
