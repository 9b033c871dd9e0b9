// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/base/progress.hpp"
#include "core/geometry/map_sheet.hpp"

namespace planum::paint {

struct MapSheetOptions {
    double scale = 20.0; ///< 1 : scale
    double dpi = 200.0;  ///< of a PNG
};

/// The sheet as PNG, cut to what it holds: title, frame with coordinates, scale bar, north arrow (on a plan), key.
/// Throws BadInput for a sheet without extent, a scale that is no positive number, and for a picture that would be too
/// large, saying at which scale it fits.
[[nodiscard]] std::string render_map_png(const geometry::MapSheet& sheet, const MapSheetOptions& options);

/// The same as PDF on the smallest paper from A4 to A0 that holds it, upright or across, else on a page of its own
/// size; so is a section that would be a mere strip on its paper. Lines and words are vectors. The same sheet gives the
/// same bytes. Throws as render_map_png().
[[nodiscard]] std::string render_map_pdf(const geometry::MapSheet& sheet, const MapSheetOptions& options,
                                         Progress& progress);

/// The largest scale from 1:5 to 1:20, the one sections are drawn at, at which the sheet fits A4; 1:20 where none does.
[[nodiscard]] double section_scale(const geometry::MapSheet& sheet);

} // namespace planum::paint
