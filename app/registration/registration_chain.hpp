// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/registration/register_scans.hpp"
#include "core/model/scan.hpp"
#include "scans/registration/fine_alignment.hpp"
#include "scans/registration/markers.hpp"
#include "scans/registration/scan_network.hpp"

namespace planum::app {

struct AcceptedPose {
    geometry::Rigid3 site_from_scan;
    geometry::Matrix6 covariance = geometry::Matrix6::Zero();
};

struct ChainScan {
    model::Scan scan;
    bool is_asked = false;                ///< to be placed; else it stays where it is
    bool is_origin = false;               ///< its own frame is the site grid
    std::optional<AcceptedPose> accepted; ///< always there where not asked
    std::vector<scans::Marker> markers;   ///< as this scan measured them
};

struct ChainInput {
    std::filesystem::path project;
    std::vector<ChainScan> scans;
    std::vector<scans::Marker> survey;
};

struct ChainLink {
    std::size_t target = 0;
    std::size_t source = 0;
    geometry::Rigid3 target_from_source;
    geometry::Matrix6 covariance = geometry::Matrix6::Zero();
    bool is_used = false;
    bool is_coarse = false; ///< from features alone
    int matches = 0;
    int inliers = 0;
    double rms = 0.0; ///< [m]
    double overlap = 0.0;
    std::vector<scans::Patch> patches;
    scans::NetworkCheck check;
    std::string verdict;
};

struct ChainScanResult {
    std::optional<scans::NetworkPose> pose;
    scans::MarkerPlacement markers;
    bool anchored_by_markers = false;
    std::string anchor_doubt; ///< why its markers were left out of the whole
    bool by_features_only = false;
    int links = 0;
    double rms = 0.0;
    double overlap = 0.0;
    std::string why_not; ///< a sentence, where there is no pose
};

struct ChainResult {
    std::vector<ChainScanResult> scans; ///< one a ChainScan
    std::vector<ChainLink> links;
    std::size_t pairs_tried = 0;
    std::vector<std::string> notes;
};

/// Markers, features, fine alignment, one relaxation over all. Reads points, writes nothing. The same input and seed
/// give the same result.
[[nodiscard]] ChainResult run_chain(const ChainInput& input, const RegisterOptions& options, Progress& progress);

} // namespace planum::app
