// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "core/geometry/rigid.hpp"

namespace planum::test {

/// Returns of a PTX file with one cloud, in the frame of the scanner; its header pose is not read.
[[nodiscard]] std::vector<Eigen::Vector3d> read_ptx_points(const std::filesystem::path& file);

/// Points of a binary little-endian PLY whose vertices begin with float x, y, z and hold floats only.
[[nodiscard]] std::vector<Eigen::Vector3d> read_ply_points(const std::filesystem::path& file);

/// Sixteen numbers, row-major.
[[nodiscard]] geometry::Rigid3 read_matrix(const std::filesystem::path& file);

} // namespace planum::test
