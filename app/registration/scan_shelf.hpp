// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <vector>

#include "core/base/progress.hpp"
#include "core/model/scan.hpp"
#include "scans/cloud/point_store.hpp"
#include "scans/registration/features.hpp"
#include "scans/registration/fine_alignment.hpp"

namespace planum::app {

/// What registration needs of each scan, made when first asked for. Features of all scans are kept, thinned points
/// of the last few only.
class ScanShelf {
  public:
    ScanShelf(std::filesystem::path project, std::vector<model::Scan> scans, scans::FineOptions fine,
              Progress& progress);

    [[nodiscard]] const std::vector<model::Scan>& scans() const noexcept { return scans_; }

    /// Features of every channel that tells something; in the order of scans(). Made for all that lack them, two
    /// scans at a time.
    void make_features(const std::vector<std::size_t>& scans);

    [[nodiscard]] const scans::FeatureSet& features(std::size_t scan) const { return features_.at(scan); }

    [[nodiscard]] std::shared_ptr<const scans::PreparedScan> prepared(std::size_t scan, Progress& progress);

  private:
    std::filesystem::path project_;
    std::vector<model::Scan> scans_;
    scans::FineOptions fine_;
    Progress& progress_;
    std::map<std::size_t, scans::FeatureSet> features_;
    std::deque<std::pair<std::size_t, std::shared_ptr<const scans::PreparedScan>>> prepared_; ///< latest first
};

/// In what features are looked for. The defaults are the best by measurement, see docs/registration.md.
struct FeatureView {
    scans::ProjectionKind projection = scans::ProjectionKind::Equirectangular;
    bool looks = true;  ///< in the reflectance, else the colour
    bool range = false; ///< in the range too; where there is neither reflectance nor colour, in any case
};

/// Features of a store in reflectance, else colour, else range, and in the range too if the view says so.
[[nodiscard]] scans::FeatureSet features_of(const scans::PointStore& store, const FeatureView& view = {});

/// Points of a store, in its order.
[[nodiscard]] std::vector<Eigen::Vector3d> points_of(const scans::PointStore& store);

} // namespace planum::app
