// SPDX-License-Identifier: MIT
#include "scans/registration/surfels.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "core/base/error.hpp"
#include "scans/registration/fixed_blocks.hpp"

namespace planum::scans {

namespace {

struct Keyed {
    std::uint64_t key = 0;
    std::uint32_t index = 0;
};

/// Cosine of the incidence under which ground is seen too flat to vote (about 84° off the normal): its planes come
/// from points far apart along the ray.
constexpr double kLeastIncidence = 0.1;

constexpr std::uint64_t kCubesASide = std::uint64_t{1} << 21U;

// Least significant digit first, 11 bits a pass; passes in which all keys share the digit are skipped.
void sort_by_key(std::vector<Keyed>& items, unsigned key_bits) {
    constexpr unsigned kBits = 11;
    constexpr std::size_t kValues = std::size_t{1} << kBits;
    std::vector<Keyed> other(items.size());
    for (unsigned shift = 0; shift < key_bits; shift += kBits) {
        std::array<std::size_t, kValues> start{};
        for (const auto& item : items) ++start[(item.key >> shift) & (kValues - 1)];
        if (std::any_of(start.begin(), start.end(), [&](std::size_t n) { return n == items.size(); })) continue;
        std::size_t sum = 0;
        for (auto& entry : start) sum += std::exchange(entry, sum);
        for (const auto& item : items) other[start[(item.key >> shift) & (kValues - 1)]++] = item;
        items.swap(other);
    }
}

Surfel surfel_at(const std::vector<Eigen::Vector3d>& points, std::size_t at, const PointIndex& index,
                 const SurfelOptions& options) {
    std::array<PointIndex::Neighbour, 64> near{};
    const auto wanted = std::min<std::size_t>(static_cast<std::size_t>(options.neighbours), near.size());
    const std::size_t count = index.nearest(points[at], std::span(near.data(), wanted));
    Surfel surfel;
    surfel.position = points[at];
    if (count < 5) return surfel;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < count; ++i) mean += points[near[i].index] - points[at];
    mean /= static_cast<double>(count);
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < count; ++i) {
        const Eigen::Vector3d d = points[near[i].index] - points[at] - mean;
        scatter += d * d.transpose();
    }
    scatter /= static_cast<double>(count - 1);
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(scatter);
    const Eigen::Vector3d variance = solver.eigenvalues().cwiseMax(0.0);
    surfel.normal = solver.eigenvectors().col(0);
    if (surfel.normal.dot(surfel.position) > 0.0) surfel.normal = -surfel.normal;
    // A sixth of the width thick is no plane; a tenth of the length wide is one line of the scanner, which
    // says nothing about the slope across it.
    surfel.is_flat = variance[0] < 0.03 * variance[1] && variance[1] > 0.01 * variance[2];
    const double range = surfel.position.norm();
    if (-surfel.normal.dot(surfel.position) < kLeastIncidence * range) surfel.is_flat = false;
    const double across = std::max(variance[2], options.noise * options.noise);
    const double along = std::max(variance[0], options.noise * options.noise);
    surfel.covariance =
        across * Eigen::Matrix3d::Identity() + (along - across) * surfel.normal * surfel.normal.transpose();
    return surfel;
}

} // namespace

std::vector<Eigen::Vector3d> thin_out(std::span<const Eigen::Vector3d> points, double voxel) {
    std::vector<Eigen::Vector3d> kept;
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = -low;
    for (const auto& x : points) {
        if (!x.allFinite()) continue;
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
        if (voxel <= 0.0) kept.push_back(x);
    }
    if (voxel <= 0.0 || !(low.array() <= high.array()).all()) return kept;
    if (((high - low) / voxel).maxCoeff() >= static_cast<double>(kCubesASide - 1)) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("points spread over {:.0f} m, too far for cubes of {} m: remove the strays",
                                (high - low).maxCoeff(), voxel));
    }
    // As few bits an axis as the cubes need, so that the sort needs few passes.
    const auto bits_of = [&](Eigen::Index axis) {
        return static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>((high[axis] - low[axis]) / voxel)));
    };
    const unsigned y_at = bits_of(0);
    const unsigned z_at = y_at + bits_of(1);
    std::vector<Keyed> keyed;
    keyed.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].allFinite()) continue;
        const Eigen::Vector3d cell = (points[i] - low) / voxel;
        keyed.push_back({static_cast<std::uint64_t>(cell.x()) | static_cast<std::uint64_t>(cell.y()) << y_at |
                             static_cast<std::uint64_t>(cell.z()) << z_at,
                         static_cast<std::uint32_t>(i)});
    }
    sort_by_key(keyed, z_at + bits_of(2));
    for (std::size_t i = 0; i < keyed.size();) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        std::size_t end = i;
        for (; end < keyed.size() && keyed[end].key == keyed[i].key; ++end) sum += points[keyed[end].index];
        kept.emplace_back(sum / static_cast<double>(end - i));
        i = end;
    }
    return kept;
}

SurfelCloud make_surfels(std::span<const Eigen::Vector3d> x_in_scan, const SurfelOptions& options) {
    const std::vector<Eigen::Vector3d> points = thin_out(x_in_scan, options.voxel);
    SurfelCloud cloud{options.voxel, std::vector<Surfel>(points.size()), PointIndex(points)};
    for_blocks(points.size(), options.threads, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) cloud.surfels[i] = surfel_at(points, i, cloud.index, options);
    });
    return cloud;
}

} // namespace planum::scans
