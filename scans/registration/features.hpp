// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "scans/panorama/panorama.hpp"

namespace planum::scans {

struct FeatureOptions {
    int most = 3000;         ///< the strongest of one channel are kept
    double contrast = 0.015; ///< SIFT's contrast threshold, grey values 0…1; lower finds more and weaker ones
    double edge = 12.0;      ///< SIFT's edge threshold
    /// Descriptors all look the same way up. Scanners are levelled well enough for that, and what looks alike
    /// when turned is no longer mistaken.
    bool is_upright = true;
    /// Features whose surroundings differ in range by more than this share lie on an edge that looks different
    /// from elsewhere.
    double most_relief = 0.25;
};

/// A place that is told from others by what its surroundings look like.
struct Feature {
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero(); ///< with fractions, see Projection
    Eigen::Vector3d x_in_scan = Eigen::Vector3d::Zero();
    float size = 0.0F; ///< diameter of what is described [px]
    Channel channel = Channel::Reflectance;
};

inline constexpr Eigen::Index kDescriptorSize = 128;

/// Row i describes feature i; rows have length 1, so that a product is the cosine between two.
using Descriptors = Eigen::Matrix<float, Eigen::Dynamic, kDescriptorSize, Eigen::RowMajor>;

struct FeatureSet {
    std::vector<Feature> features;
    Descriptors descriptors;
};

/// SIFT (Lowe 2004) in one channel of a panorama, the square roots of its descriptors (Arandjelović and
/// Zisserman 2012). A full turn has no seam. Features where the panorama shows nothing are left out.
/// Throws BadInput if the scan lacks the channel.
[[nodiscard]] FeatureSet find_features(const Panorama& panorama, Channel channel, const FeatureOptions& options = {});

/// Puts the features of another channel behind those that are there.
void append(FeatureSet& all, const FeatureSet& more);

} // namespace planum::scans
