// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/project/project.hpp"
#include "app/scans/list_scans.hpp"
#include "core/base/progress.hpp"
#include "core/model/scan.hpp"

namespace planum::app {

/// Axis-parallel box [m]; the smallest and the largest x, y and z.
struct ScanExtent {
    std::array<double, 3> minimum{};
    std::array<double, 3> maximum{};
};

/// An image inside a scan file.
struct ScanImage {
    std::string type;           ///< jpeg or png
    std::string representation; ///< visualReference, pinhole, spherical, cylindrical
    std::uint64_t width = 0;    ///< [px]
    std::uint64_t height = 0;
    std::uint64_t bytes = 0;
};

/// What a step of the stored intensity means, and the limits that the file states, in the file's own units.
struct ScanIntensity {
    double offset = 0.0;
    double step = 1.0;
    std::optional<std::array<double, 2>> limits;
};

/// What the original file says of the scan, where it is still there and still readable. Empty texts: not stated.
struct OriginalDetails {
    std::string variant;                 ///< "1.2, point format 3", "binary_little_endian", …
    std::uint64_t clouds = 0;            ///< in the file
    std::uint64_t records = 0;           ///< of this cloud, misses included
    std::vector<std::string> attributes; ///< per point, by the file's own names
    std::vector<std::string> channels;
    std::optional<ScanIntensity> intensity;
    std::optional<ScanExtent> stated_bounds; ///< in the scan's frame
    std::string time_zero;                   ///< what the points' times are, in words; empty: they have none
    std::string software;
    std::string created_at; ///< ISO time UTC
    std::string coordinate_system;
    std::string column_guess; ///< XYZ and PTS: the meaning given to each column
    std::vector<ScanImage> images;
    std::vector<std::string> notes; ///< what a person should know, in sentences
};

/// What the point store of a scan says.
struct StoreDetails {
    std::string file; ///< path
    std::uint64_t file_bytes = 0;
    std::uint64_t nodes = 0;
    std::uint64_t levels = 0;
    std::optional<ScanExtent> bounds;  ///< of the points as they came, in the scan's frame; none without points
    std::vector<std::string> channels; ///< kept per point besides coordinates: intensity, colour, row and column
};

/// All that is known of one scan.
struct ScanDetails {
    model::Scan scan;
    ListedScan listed;
    StoreDetails store;
    std::optional<OriginalDetails> original;
    std::string original_trouble; ///< why there is no `original`, in a sentence
};

/// The details of the scan of that name. The store is made again where it is missing. Throws NotFound for a name that
/// is none, and like open_store.
[[nodiscard]] ScanDetails scan_details(Project& project, std::string_view name, Progress& progress);

/// An image that the original holds, as the bytes of its JPEG or PNG file; `number` counts from 1. Throws NotFound when
/// the original is not there or has no such image, BadInput when it is damaged.
[[nodiscard]] std::string scan_image(Project& project, std::string_view name, std::size_t number, Progress& progress);

} // namespace planum::app
