// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "core/geometry/rigid.hpp"
#include "core/model/record.hpp"
#include "scans/cloud/point_store.hpp"

namespace planum::app {

/// `NAME.scans` beside the project file: caches that can all be made again.
[[nodiscard]] std::filesystem::path scans_folder(const std::filesystem::path& project);

/// Where the points of a scan are kept, by the hash of the original, the columns stated for it and the number of the
/// cloud in it.
[[nodiscard]] std::filesystem::path store_path(const std::filesystem::path& project, const model::Scan& scan);

/// Where the original of a scan should be; relative paths count from the project file.
[[nodiscard]] std::filesystem::path original_path(const std::filesystem::path& project, const model::Scan& scan);

/// How a project remembers an original: relative to the project file where there is a way, else whole.
[[nodiscard]] std::string path_to_keep(const std::filesystem::path& project, const std::filesystem::path& file);

/// The points of a scan. A store that is missing or no sound file is made again from the original, whose
/// hash must be the recorded one. Throws NotFound or BadInput with the name of the scan and what to do.
[[nodiscard]] std::shared_ptr<const scans::PointStore> open_store(const std::filesystem::path& project,
                                                                  const model::Scan& scan, Progress& progress);

/// The columns that somebody stated for a table of points; they stand behind the format's name. Empty: guessed.
[[nodiscard]] std::string stated_columns(const model::Scan& scan);

/// Makes the points of a scan again from its original, whose hash must be the recorded one; what is there is replaced
/// when the new store is whole. Throws like open_store.
void rebuild_store(const std::filesystem::path& project, const model::Scan& scan, Progress& progress);

/// A scan on the site grid, with its points.
struct PlacedScan {
    model::Scan scan;
    geometry::Rigid3 site_from_scan;
    geometry::Matrix6 covariance = geometry::Matrix6::Zero(); ///< in the numbers of geometry::moved()
    double rms = 0.0;                                         ///< of the fine alignment [m]
    std::shared_ptr<const scans::PointStore> store;
};

/// All scans with an accepted pose that `wanted` asks for, in the order of the record, stores open.
[[nodiscard]] std::vector<PlacedScan>
placed_scans(Project& project, const std::function<bool(const model::Scan&)>& wanted, Progress& progress);

} // namespace planum::app
