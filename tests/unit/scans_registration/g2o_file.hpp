// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "scans/registration/pose_graph.hpp"

namespace planum::test {

struct G2oGraph {
    std::vector<scans::PoseNode> nodes; ///< the first is fixed
    std::vector<scans::PoseLink> links;
};

/// VERTEX_SE3:QUAT and EDGE_SE3:QUAT lines of a text file. The information of a file stands for errors in the
/// frame of the measured source, translation first; it is brought to ours, the error stays the same.
[[nodiscard]] G2oGraph read_g2o(const std::filesystem::path& file);

} // namespace planum::test
