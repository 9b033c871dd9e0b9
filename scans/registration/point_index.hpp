// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <Eigen/Core>

namespace planum::scans {

/// Nearest neighbours among a fixed set of points (k-d tree). Safe to ask from several threads; equal
/// distances are decided the same way every time. Coordinates are kept in single precision about the
/// middle of the set: good to 10 µm within 100 m.
class PointIndex {
  public:
    struct Neighbour {
        std::uint32_t index = 0;
        double squared_distance = 0.0; ///< [m²]
    };

    explicit PointIndex(std::span<const Eigen::Vector3d> points);
    PointIndex(PointIndex&&) noexcept;
    PointIndex& operator=(PointIndex&&) noexcept;
    ~PointIndex();

    /// Requires at least one point.
    [[nodiscard]] Neighbour nearest(const Eigen::Vector3d& x) const;

    /// Fills `found` with the nearest points, nearest first; returns how many there are, at most its size.
    [[nodiscard]] std::size_t nearest(const Eigen::Vector3d& x, std::span<Neighbour> found) const;

  private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

} // namespace planum::scans
