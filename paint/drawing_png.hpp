// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "strat/layout/drawing.hpp"

namespace planum::paint {

struct PngOptions {
    double dpi = 150.0;                    ///< pixels per inch
    std::int64_t max_pixels = 120'000'000; ///< a larger picture is refused, with the resolution that fits
};

/// The drawing as a PNG file's bytes. Throws BadInput when it would be larger than allowed.
[[nodiscard]] std::string render_png(const strat::MatrixDrawing& drawing, const PngOptions& options = {});

} // namespace planum::paint
