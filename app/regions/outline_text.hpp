// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "core/geometry/gpb.hpp"

namespace planum::app {

/// An outline as people type it: `x y [z], x y [z], …` in site coordinates [m], or WKT POLYGON and MULTIPOLYGON, with
/// or without Z. Throws BadInput with the word that was not understood.
[[nodiscard]] geometry::MultiPolygon parse_outline(std::string_view text);

/// WKT with heights, millimetres.
[[nodiscard]] std::string outline_text(const geometry::MultiPolygon& shape);

} // namespace planum::app
