// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>

#include "core/model/ids.hpp"

namespace planum::model {

/// One set-up of the scanner. The original file is referenced by hash and never changed.
struct Scan {
    ScanId id;
    std::string name; ///< `DAY/STEM`, further clouds of a file `#2`
    std::string day;  ///< ISO date
    SurfaceId surface;
    std::string path; ///< of the original, relative to the project file where possible
    std::string sha256;
    std::string format;
    std::int64_t cloud = 0; ///< which cloud of the file, from 0
    std::int64_t points = 0;
    std::int64_t rows = 0; ///< of the scanner's grid; 0: none
    std::int64_t columns = 0;
    std::string sensor;
    std::string acquired_at;                           ///< ISO time or empty
    std::optional<std::array<double, 16>> header_pose; ///< as the file says, row-major; a start value only

    friend bool operator==(const Scan&, const Scan&) = default;
};

/// A scan placed no better than this is reported as placed poorly: σ in the worst direction and about the worst axis.
inline constexpr double kPoorPosition = 0.010;                          ///< [m]
inline constexpr double kPoorRotation = 0.1 * std::numbers::pi / 180.0; ///< [rad]

/// Where a scan stands on the site grid: `x_in_site = site_from_scan * x_in_scan`.
struct ScanPose {
    ScanId scan;
    RegistrationRunId run;
    std::array<double, 16> site_from_scan{}; ///< row-major, rigid
    std::array<double, 36> covariance{};     ///< of (rotation [rad], translation [m]) in site, row-major
    double rms = 0.0;                        ///< of the fine alignment [m]
    double overlap = 0.0;                    ///< share of points with a partner, 0…1
    std::string verdict;                     ///< in words

    friend bool operator==(const ScanPose&, const ScanPose&) = default;
};

/// One run of the registration chain, kept so that runs can be compared, accepted or undone.
struct RegistrationRun {
    RegistrationRunId id;
    std::string name;
    std::string made_at;
    std::string method; ///< auto, markers, features, icp
    std::string state;  ///< proposed, accepted, discarded
    std::string report; ///< JSON: links, residuals, verdicts

    friend bool operator==(const RegistrationRun&, const RegistrationRun&) = default;
};

} // namespace planum::model
