// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/base/progress.hpp"
#include "core/geometry/sheet_group.hpp"

namespace planum::paint {

/// The group as PNG, cut to what it holds: title, text, then its sheets one below the other, each at its own scale
/// with scale bar and key. The same group gives the same bytes. Throws BadInput for a group without sheets, for a
/// sheet without extent or scale, and for a picture of more than 120 million pixels.
[[nodiscard]] std::string render_sheet_group_png(const geometry::SheetGroup& group, double dpi);

/// The same as PDF on the smallest paper from A4 to A0 that holds it, else on a page of its own size.
[[nodiscard]] std::string render_sheet_group_pdf(const geometry::SheetGroup& group, Progress& progress);

} // namespace planum::paint
