// SPDX-License-Identifier: MIT
#include "scans/registration/point_index.hpp"

#include <array>
#include <vector>

#include <nanoflann.hpp>

namespace planum::scans {

namespace {

/// What nanoflann asks of a set of points.
struct Coordinates {
    std::vector<Eigen::Vector3f> points;

    [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }

    [[nodiscard]] float kdtree_get_pt(std::size_t i, std::size_t axis) const {
        return points[i][static_cast<Eigen::Index>(axis)];
    }

    template<class Box>
    bool kdtree_get_bbox(Box& /*box*/) const {
        return false; // let it look
    }
};

using Kd = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Coordinates, float, std::uint32_t>,
                                               Coordinates, 3, std::uint32_t>;

Eigen::Vector3d middle_of(std::span<const Eigen::Vector3d> points) {
    if (points.empty()) return Eigen::Vector3d::Zero();
    Eigen::Vector3d low = points.front();
    Eigen::Vector3d high = low;
    for (const auto& x : points) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    return 0.5 * (low + high);
}

} // namespace

struct PointIndex::Tree {
    Eigen::Vector3d middle;
    Coordinates coordinates;
    std::unique_ptr<Kd> kd;
};

PointIndex::PointIndex(std::span<const Eigen::Vector3d> points) : tree_(std::make_unique<Tree>()) {
    tree_->middle = middle_of(points);
    tree_->coordinates.points.reserve(points.size());
    for (const auto& x : points) tree_->coordinates.points.emplace_back((x - tree_->middle).cast<float>());
    constexpr std::size_t kLeaf = 12; // measured: 8…16 are alike
    tree_->kd = std::make_unique<Kd>(3, tree_->coordinates, nanoflann::KDTreeSingleIndexAdaptorParams(kLeaf));
}

PointIndex::PointIndex(PointIndex&&) noexcept = default;
PointIndex& PointIndex::operator=(PointIndex&&) noexcept = default;
PointIndex::~PointIndex() = default;

PointIndex::Neighbour PointIndex::nearest(const Eigen::Vector3d& x) const {
    Neighbour one;
    (void)nearest(x, std::span(&one, 1));
    return one;
}

std::size_t PointIndex::nearest(const Eigen::Vector3d& x, std::span<Neighbour> found) const {
    constexpr std::size_t kMost = 64;
    std::array<std::uint32_t, kMost> indices{};
    std::array<float, kMost> squared{};
    const Eigen::Vector3f local = (x - tree_->middle).cast<float>();
    const std::size_t wanted = std::min(found.size(), kMost);
    const std::size_t count = tree_->kd->knnSearch(local.data(), wanted, indices.data(), squared.data());
    for (std::size_t i = 0; i < count; ++i) found[i] = {indices[i], static_cast<double>(squared[i])};
    return count;
}

} // namespace planum::scans
