// SPDX-License-Identifier: MIT
#include "app/scans/scan_details.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "app/scans/scan_stores.hpp"
#include "core/base/error.hpp"
#include "scans/formats/scan_reader.hpp"

namespace planum::app {

namespace {

std::vector<std::string> channels(const scans::Columns& has) {
    std::vector<std::string> names;
    if (has.intensity) names.emplace_back("intensity");
    if (has.colour) names.emplace_back("colour");
    if (has.grid) names.emplace_back("row and column");
    if (has.time) names.emplace_back("time");
    return names;
}

std::optional<ScanExtent> extent(const scans::Bounds& bounds) {
    if (bounds.empty()) return std::nullopt;
    return ScanExtent{bounds.minimum, bounds.maximum};
}

StoreDetails store_details(const Project& project, const model::Scan& scan, Progress& progress) {
    const std::shared_ptr<const scans::PointStore> store = open_store(project.path(), scan, progress);
    StoreDetails details;
    details.file = store_path(project.path(), scan).string();
    details.file_bytes = store->file_bytes();
    details.nodes = store->nodes().size();
    for (const scans::StoreNodeRecord& node : store->nodes()) {
        details.levels = std::max<std::uint64_t>(details.levels, node.depth + 1U);
    }
    details.bounds = extent(store->bounds());
    details.channels = channels(store->info().has);
    return details;
}

// The original, its hash taken on trust: hashing gigabytes is the work of verify.
std::unique_ptr<scans::ScanReader> open_original(const Project& project, const model::Scan& scan, Progress& progress) {
    const std::filesystem::path original = original_path(project.path(), scan);
    if (!std::filesystem::exists(original)) {
        throw Error(ErrorCode::NotFound,
                    fmt::format("scan {}: the original {} is not there", scan.name, original.string()));
    }
    auto reader = scans::open_scan(original, {stated_columns(scan)}, progress);
    if (static_cast<std::size_t>(scan.cloud) >= reader->clouds().size()) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("scan {}: {} has no cloud {} any more", scan.name, original.string(), scan.cloud + 1));
    }
    return reader;
}

OriginalDetails original_details(const scans::ScanReader& reader, std::size_t number) {
    const scans::ScanFileInfo& file = reader.info();
    const scans::CloudHeader& cloud = reader.clouds()[number];
    OriginalDetails details;
    details.variant = file.variant;
    details.clouds = reader.clouds().size();
    details.records = cloud.records;
    details.attributes = cloud.attributes;
    details.channels = channels(cloud.has);
    if (cloud.has.intensity) {
        details.intensity = ScanIntensity{cloud.intensity.offset, cloud.intensity.scale, std::nullopt};
        if (cloud.intensity_limits) {
            details.intensity->limits = {cloud.intensity_limits->minimum, cloud.intensity_limits->maximum};
        }
    }
    if (cloud.stated_bounds) details.stated_bounds = extent(*cloud.stated_bounds);
    if (cloud.has.time) details.time_zero = cloud.time_zero;
    details.software = file.software;
    details.created_at = file.created_at;
    details.coordinate_system = file.coordinate_system;
    details.column_guess = file.column_guess;
    for (const scans::ImageHeader& image : file.images) {
        details.images.push_back({image.type, image.representation, image.width, image.height, image.bytes});
    }
    details.notes = file.notes;
    details.notes.insert(details.notes.end(), cloud.notes.begin(), cloud.notes.end());
    return details;
}

} // namespace

ScanDetails scan_details(Project& project, std::string_view name, Progress& progress) {
    ScanDetails details;
    details.scan = scan_named(project, name);
    for (ListedScan& listed : list_scans(project)) {
        if (listed.scan == name) details.listed = std::move(listed);
    }
    details.store = store_details(project, details.scan, progress);
    try {
        const auto reader = open_original(project, details.scan, progress);
        details.original = original_details(*reader, static_cast<std::size_t>(details.scan.cloud));
    } catch (const Error& e) {
        // The scan stays usable without its original: what the store and the project know is shown all the same.
        if (e.code() != ErrorCode::NotFound && e.code() != ErrorCode::BadInput && e.code() != ErrorCode::Io) throw;
        details.original_trouble = e.what();
    }
    return details;
}

std::string scan_image(Project& project, std::string_view name, std::size_t number, Progress& progress) {
    const model::Scan scan = scan_named(project, name);
    const auto reader = open_original(project, scan, progress);
    const std::size_t images = reader->info().images.size();
    if (images == 0) {
        throw Error(ErrorCode::NotFound, fmt::format("scan {}: {} holds no images", scan.name,
                                                     original_path(project.path(), scan).string()));
    }
    if (number < 1 || number > images) {
        throw Error(ErrorCode::NotFound,
                    fmt::format("scan {}: there is no image {}; the file holds {}", scan.name, number,
                                images == 1 ? "one" : fmt::format("the images 1 to {}", images)));
    }
    return reader->read_image(number - 1);
}

} // namespace planum::app
