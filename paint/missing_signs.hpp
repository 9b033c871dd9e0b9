// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "strat/layout/drawing.hpp"

namespace planum::paint {

/// The signs of a text (each once, in the order of their code points) that no font of this machine has: what is
/// painted shows empty squares in their place. Signs that our own font lacks and another has are painted with that
/// one. SVG is not concerned: there the viewer's fonts count.
[[nodiscard]] std::vector<std::string> missing_signs(std::string_view utf8);

/// Of all labels, headings and words of the key.
[[nodiscard]] std::vector<std::string> missing_signs(const strat::MatrixDrawing& drawing);

/// A remark for whoever asked for `file`; empty where nothing is missing.
[[nodiscard]] std::string missing_signs_remark(std::string_view file, const std::vector<std::string>& signs);

} // namespace planum::paint
