// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace planum::bench {

/// What every projection and channel finds on the scans of a folder of days whose headers hold the truth: features,
/// matches and inliers of all pairs, how many pairs are accepted and how well.
void bench_projections(const std::filesystem::path& folder);

/// Scans that do not belong, added to those of the folder: of another site, with nothing in it, mirrored, with 5 % in
/// common. What `planum register` says of each.
void bench_strangers(const std::filesystem::path& folder);

} // namespace planum::bench
