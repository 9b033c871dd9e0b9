// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <array>
#include <filesystem>
#include <string>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "strat/layout/drawing.hpp"

namespace planum::gui {

/// Writes the project in the form that the ending names: `.xml` and `.html` are reports, `.svg`, `.pdf` and `.png` the
/// matrix, all else the record for other programs. `shown`: the matrix as a view shows it, instead of one of the whole
/// record. Returns what was written and what could not be carried. Throws Usage for an unknown ending.
[[nodiscard]] QString export_file(app::Project& project, const std::filesystem::path& file, Progress& progress,
                                  const strat::MatrixDrawing* shown = nullptr);

/// Writes the report as `.pdf`, `.html` or `.xml`, of the whole record or, with an ISO date, of one day. Throws as
/// app::write_report().
[[nodiscard]] QString write_report_file(app::Project& project, const std::filesystem::path& file,
                                        const std::string& day, Progress& progress);

/// Writes the plan of a surface, by its name, at 1 : `scale` as `.pdf` or `.png`; returns what could not be shown too.
/// Throws as app::plan_sheet(), Usage for another ending.
[[nodiscard]] QString write_plan_file(app::Project& project, const std::filesystem::path& file,
                                      const std::string& surface, double scale, Progress& progress);

/// The same of a section, by its name. Throws as app::section_sheet(), NotFound for the name, Usage for another ending.
[[nodiscard]] QString write_section_file(app::Project& project, const std::filesystem::path& file,
                                         const std::string& section, double scale, Progress& progress);

/// The same between any two places of the site [m]. Throws as app::section_sheet(), Usage for another ending.
[[nodiscard]] QString write_free_section_file(app::Project& project, const std::filesystem::path& file,
                                              const std::array<double, 2>& from_in_site,
                                              const std::array<double, 2>& to_in_site, double scale,
                                              Progress& progress);

} // namespace planum::gui
