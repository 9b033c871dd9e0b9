// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <filesystem>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"

namespace planum::gui {

/// Writes the project in the form that the ending names: `.xml` and `.html` are reports, `.svg`, `.pdf` and `.png` the
/// matrix, all else the record for other programs. Returns what was written and what could not be carried. Throws
/// Usage for an unknown ending.
[[nodiscard]] QString export_file(app::Project& project, const std::filesystem::path& file, Progress& progress);

} // namespace planum::gui
