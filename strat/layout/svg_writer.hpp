// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "strat/layout/drawing.hpp"

namespace planum::strat {

/// The drawing as SVG 1.1: one group with id and classes for each unit and each order (so that they can
/// be restyled), titles and a description for screen readers, links, and `textLength`, so that labels fit
/// their boxes whatever font the viewer has. Lengths in points; same drawing, same bytes.
[[nodiscard]] std::string write_svg(const MatrixDrawing& drawing);

/// Text with the five characters XML reserves replaced; control characters XML forbids become U+FFFD.
[[nodiscard]] std::string xml_escaped(std::string_view text);

} // namespace planum::strat
