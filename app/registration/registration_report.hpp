// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace planum::app {

struct ReportedMarker {
    std::string name;
    bool is_used = false;
    double residual = 0.0; ///< [m]
    std::string reason;    ///< why it was left out

    friend bool operator==(const ReportedMarker&, const ReportedMarker&) = default;
};

struct ReportedScan {
    std::string scan;
    std::string day;
    std::int64_t points = 0;
    std::string status;                                   ///< registered, failed
    std::string method;                                   ///< how it was placed: markers, features, icp, origin
    std::optional<std::array<double, 16>> site_from_scan; ///< row-major
    std::array<double, 36> covariance{};                  ///< see model::ScanPose
    double rms = 0.0;                                     ///< of its best link or, without links, of its markers [m]
    double overlap = 0.0;                                 ///< of its best link
    double sigma_position = 0.0;                          ///< in the worst direction, on the site grid [m]
    double sigma_rotation_deg = 0.0;
    double sigma_to_others = 0.0; ///< what the links leave open, without the share of the markers [m]
    int links = 0;                ///< that were used
    bool is_poor = false;
    std::string verdict; ///< a sentence
    std::vector<ReportedMarker> markers;

    friend bool operator==(const ReportedScan&, const ReportedScan&) = default;
};

struct ReportedLink {
    std::string from; ///< x_in_from = from_from_to * x_in_to
    std::string to;
    std::array<double, 16> from_from_to{}; ///< as the two scans alone say, row-major
    std::array<double, 36> covariance{};   ///< of it, in the numbers of geometry::moved
    bool is_accepted = false;
    double rms = 0.0; ///< [m]
    double overlap = 0.0;
    int matches = 0;             ///< features that look alike
    int inliers = 0;             ///< of these, that lie the same way
    double sigma_position = 0.0; ///< [m]
    double sigma_rotation_deg = 0.0;
    double error_before = 0.0; ///< against the chain of best links, in standard deviations
    double error_after = 0.0;  ///< after all were relaxed
    double shift = 0.0;        ///< that remains [m]
    double turn_deg = 0.0;     ///< that remains
    int stable_patches = 0;    ///< ground that voted
    int changed_patches = 0;   ///< dug away, moved
    int shifted_patches = 0;   ///< a little higher or lower as a whole
    std::string verdict;

    friend bool operator==(const ReportedLink&, const ReportedLink&) = default;
};

/// What a run of the registration found; kept with the run.
struct RegistrationReport {
    std::string run;
    std::string method;
    std::string state; ///< proposed, accepted, discarded
    std::vector<ReportedScan> scans;
    std::vector<ReportedLink> links;
    std::size_t pairs_tried = 0;
    double loops_before = 0.0; ///< root mean square of the links' errors, in standard deviations
    double loops_after = 0.0;
    std::vector<std::string> notes; ///< sentences

    friend bool operator==(const RegistrationReport&, const RegistrationReport&) = default;
};

/// As `planum register --json` prints it.
[[nodiscard]] nlohmann::ordered_json to_json(const RegistrationReport& report);

/// Throws BadInput for a text that is no report.
[[nodiscard]] RegistrationReport registration_report(const std::string& json);

} // namespace planum::app
