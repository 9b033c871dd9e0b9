// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "app/project/project.hpp"
#include "app/regions/outline.hpp"
#include "core/base/progress.hpp"

namespace planum::app {

/// Reads files of outlines (GeoJSON, or pixel polygons of panoramas) together; of several every place is said with its
/// file. Throws BadInput, NotFound or Io, naming the file.
[[nodiscard]] OutlineFile read_outline_files(Project& project, const std::vector<std::filesystem::path>& files,
                                             Progress& progress);

} // namespace planum::app
