// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/model/record.hpp"

namespace planum::app {

/// Whether a scan may show a surface: its own, or one of the same day that belongs to another area, as where two
/// trenches beside each other were scanned together. Other scans of the same area and day show the ground before or
/// after.
[[nodiscard]] bool may_show(const model::Record& record, const model::Scan& scan, const model::Surface& surface);

/// The scans that a surface is made from: its own; where it has none, all that may show it.
[[nodiscard]] std::vector<const model::Scan*> scans_of(const model::Record& record, const model::Surface& surface);

/// The same for the surface of that id; none where there is no such surface.
[[nodiscard]] std::vector<const model::Scan*> scans_of(const model::Record& record, model::SurfaceId surface);

/// Whether one of scans_of() stands on the site grid.
[[nodiscard]] bool is_seen(const model::Record& record, const model::Surface& surface);

/// Why a surface cannot be judged that no scan on the site grid shows: `none of its scans stands on the site grid; …`.
[[nodiscard]] std::string why_unseen(const model::Record& record, const model::Surface& surface);

} // namespace planum::app
