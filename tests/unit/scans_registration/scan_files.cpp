// SPDX-License-Identifier: MIT
#include "tests/unit/scans_registration/scan_files.hpp"

#include <array>
#include <fstream>
#include <sstream>
#include <string>

namespace planum::test {

std::vector<Eigen::Vector3d> read_ptx_points(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string line;
    for (int i = 0; i < 10; ++i) std::getline(in, line);
    std::vector<Eigen::Vector3d> points;
    while (std::getline(in, line)) {
        std::istringstream fields(line);
        Eigen::Vector3d x;
        if (fields >> x.x() >> x.y() >> x.z() && x.squaredNorm() > 0.0) points.push_back(x);
    }
    return points;
}

std::vector<Eigen::Vector3d> read_ply_points(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string line;
    std::size_t vertices = 0;
    std::size_t fields = 0;
    while (std::getline(in, line) && line.find("end_header") == std::string::npos) {
        if (line.starts_with("element vertex ")) vertices = std::stoul(line.substr(15));
        if (line.starts_with("property float ")) ++fields;
    }
    std::vector<Eigen::Vector3d> points;
    std::vector<float> values(fields);
    for (std::size_t i = 0; i < vertices; ++i) {
        in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(4 * fields));
        points.emplace_back(values[0], values[1], values[2]);
    }
    return points;
}

geometry::Rigid3 read_matrix(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::array<double, 16> matrix{};
    for (auto& value : matrix) in >> value;
    return geometry::from_row_major(matrix);
}

} // namespace planum::test
