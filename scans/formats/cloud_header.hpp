// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "scans/formats/point_block.hpp"

namespace planum::scans {

/// Axis-parallel box; empty as long as minimum > maximum.
struct Bounds {
    std::array<double, 3> minimum = {kHuge, kHuge, kHuge};    ///< [m]
    std::array<double, 3> maximum = {-kHuge, -kHuge, -kHuge}; ///< [m]

    [[nodiscard]] bool empty() const noexcept { return minimum[0] > maximum[0]; }

    friend bool operator==(const Bounds&, const Bounds&) = default;

  private:
    static constexpr double kHuge = std::numeric_limits<double>::infinity();
};

/// What a step of the stored 16-bit intensity means: value in the file = offset + scale × stored.
struct IntensityCoding {
    double offset = 0.0;
    double scale = 1.0;

    [[nodiscard]] double value(std::uint16_t stored) const noexcept { return offset + scale * stored; }

    friend bool operator==(const IntensityCoding&, const IntensityCoding&) = default;
};

struct Limits {
    double minimum = 0.0;
    double maximum = 0.0;

    friend bool operator==(const Limits&, const Limits&) = default;
};

/// What the file says about one cloud before its points are read.
struct CloudHeader {
    std::string name;
    std::string guid;
    std::string description;
    std::uint64_t records = 0; ///< as stated by the file, misses included
    std::uint64_t rows = 0;    ///< of the scanner's grid; 0: none
    std::uint64_t columns = 0;
    Columns has;
    IntensityCoding intensity;
    std::optional<Limits> intensity_limits; ///< as stated by the file, in its own units
    std::optional<Limits> colour_limits;
    std::optional<Bounds> stated_bounds; ///< in the scan's frame
    /// x_in_site = site_from_scan * x_in_scan as the file says; only a start value for registration.
    Eigen::Isometry3d site_from_scan = Eigen::Isometry3d::Identity();
    bool has_pose = false;
    std::string sensor;        ///< vendor, model, serial number
    std::string acquired_from; ///< ISO time UTC, or empty
    std::string acquired_to;
    std::string time_zero;               ///< from where the points' times count, in words
    std::vector<std::string> attributes; ///< all that the file has per point, by its own names
    std::vector<std::string> notes;      ///< what a person should know, in sentences
};

enum class ScanFormat { Ptx, E57, Las, Ply, Pcd, Pts, Xyz, ThreeDtk };

/// An image inside a scan file.
struct ImageHeader {
    std::string name;
    std::string guid;
    std::string scan_guid;      ///< of the cloud it belongs to, or empty
    std::string representation; ///< visualReference, pinhole, spherical, cylindrical
    std::string type;           ///< jpeg or png
    std::uint64_t width = 0;    ///< [px]
    std::uint64_t height = 0;
    std::uint64_t bytes = 0;
    std::optional<double> focal_length; ///< [m]
    Eigen::Isometry3d site_from_camera = Eigen::Isometry3d::Identity();
    bool has_pose = false;
};

/// What the file says about itself.
struct ScanFileInfo {
    ScanFormat format = ScanFormat::Xyz;
    std::string variant; ///< "1.2, point format 3", "binary_little_endian", …
    std::string guid;
    std::string software;
    std::string created_at;        ///< ISO time UTC, or empty
    std::string coordinate_system; ///< WKT or EPSG code as stated, or empty
    std::string column_guess;      ///< XYZ and PTS: the meaning given to each column, to be shown
    std::vector<ImageHeader> images;
    std::vector<std::string> notes;
};

/// What was met while reading a cloud to its end.
struct ReadSummary {
    std::uint64_t records = 0; ///< read
    std::uint64_t valid = 0;
    std::uint64_t misses = 0;  ///< no return, direction only, withheld, or not a finite number
    std::uint64_t clamped = 0; ///< intensities or colours outside what 16 or 8 bits hold
    Bounds bounds;             ///< of the valid points, in the scan's frame

    friend bool operator==(const ReadSummary&, const ReadSummary&) = default;
};

} // namespace planum::scans
