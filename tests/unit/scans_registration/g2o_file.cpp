// SPDX-License-Identifier: MIT
#include "tests/unit/scans_registration/g2o_file.hpp"

#include <fstream>
#include <sstream>
#include <string>

#include <Eigen/Geometry>

namespace planum::test {

namespace {

geometry::Rigid3 read_pose(std::istream& in) {
    Eigen::Vector3d t;
    Eigen::Quaterniond q;
    in >> t.x() >> t.y() >> t.z() >> q.x() >> q.y() >> q.z() >> q.w();
    return {q.normalized().toRotationMatrix(), t};
}

geometry::Matrix6 read_information(std::istream& in, const Eigen::Matrix3d& turn) {
    Eigen::Matrix<double, 6, 6> given; // translation first
    for (int row = 0; row < 6; ++row) {
        for (int column = row; column < 6; ++column) {
            in >> given(row, column);
            given(column, row) = given(row, column);
        }
    }
    geometry::Matrix6 ours;
    ours << given.bottomRightCorner<3, 3>(), given.bottomLeftCorner<3, 3>(), given.topRightCorner<3, 3>(),
        given.topLeftCorner<3, 3>();
    geometry::Matrix6 both = geometry::Matrix6::Zero();
    both.topLeftCorner<3, 3>() = turn;
    both.bottomRightCorner<3, 3>() = turn;
    return both * ours * both.transpose();
}

} // namespace

G2oGraph read_g2o(const std::filesystem::path& file) {
    G2oGraph graph;
    std::ifstream in(file);
    std::string line;
    while (std::getline(in, line)) {
        std::istringstream fields(line);
        std::string kind;
        fields >> kind;
        if (kind == "VERTEX_SE3:QUAT") {
            std::size_t id = 0;
            fields >> id;
            if (graph.nodes.size() <= id) graph.nodes.resize(id + 1);
            graph.nodes[id].site_from_scan = read_pose(fields);
        } else if (kind == "EDGE_SE3:QUAT") {
            scans::PoseLink link;
            fields >> link.target >> link.source;
            link.target_from_source = read_pose(fields);
            link.information = read_information(fields, link.target_from_source.rotation);
            graph.links.push_back(link);
        }
    }
    if (!graph.nodes.empty()) graph.nodes.front().is_fixed = true;
    return graph;
}

} // namespace planum::test
