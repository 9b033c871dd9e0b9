// SPDX-License-Identifier: MIT
#include "app/surfaces/surface_cache.hpp"

#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "app/project/sealed_file.hpp"
#include "app/scans/scan_stores.hpp"
#include "core/base/sha256.hpp"

namespace planum::app {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kVersion = "planum surface grid 2\n";

template<class Value>
void append(std::string& bytes, const std::vector<Value>& values) {
    const std::size_t at = bytes.size();
    bytes.resize(at + values.size() * sizeof(Value));
    if (!values.empty()) std::memcpy(bytes.data() + at, values.data(), values.size() * sizeof(Value));
}

template<class Value>
void take(std::string_view& bytes, std::vector<Value>& values, std::size_t count) {
    values.resize(count);
    std::memcpy(values.data(), bytes.data(), count * sizeof(Value));
    bytes.remove_prefix(count * sizeof(Value));
}

constexpr std::size_t kBytesOfCell = 6 * sizeof(float) + sizeof(std::uint16_t) + 1;

std::string to_bytes(const scans::SurfaceGrid& grid) {
    std::string bytes{kVersion};
    append(bytes, grid.height);
    append(bytes, grid.spread);
    append(bytes, grid.pose_sigma);
    append(bytes, grid.slope);
    append(bytes, grid.count);
    append(bytes, grid.state);
    append(bytes, grid.side_east);
    append(bytes, grid.side_north);
    return bytes;
}

std::optional<scans::SurfaceGrid> read_cached(const fs::path& file, const scans::GridFrame& frame) {
    const std::optional<std::string> kept = read_sealed(file);
    const std::size_t n = frame.cells();
    if (!kept || kept->size() != kVersion.size() + n * kBytesOfCell || !kept->starts_with(kVersion))
        return std::nullopt;
    std::string_view bytes = *kept;
    bytes.remove_prefix(kVersion.size());
    scans::SurfaceGrid grid;
    grid.frame = frame;
    take(bytes, grid.height, n);
    take(bytes, grid.spread, n);
    take(bytes, grid.pose_sigma, n);
    take(bytes, grid.slope, n);
    take(bytes, grid.count, n);
    take(bytes, grid.state, n);
    take(bytes, grid.side_east, n);
    take(bytes, grid.side_north, n);
    return grid;
}

} // namespace

std::vector<scans::SurfaceScan> surface_scans(Project& project, model::SurfaceId surface, Progress& progress) {
    std::vector<scans::SurfaceScan> scans;
    for (const PlacedScan& placed : placed_scans(
             project, [&](const model::Scan& scan) { return scan.surface == surface; }, progress)) {
        scans::SurfaceScan scan;
        scan.name = placed.scan.name;
        scan.points = std::make_shared<scans::StorePoints>(placed.store, placed.site_from_scan);
        scan.station = placed.site_from_scan.translation;
        scan.covariance = placed.covariance;
        scans.push_back(std::move(scan));
    }
    return scans;
}

std::string surface_key(const model::Record& record, model::SurfaceId surface, const scans::GridFrame& frame) {
    std::string text;
    for (const model::Scan& scan : record.scans) {
        if (scan.surface != surface) continue;
        const model::ScanPose* pose = model::pose_in_force(record, scan.id);
        if (pose == nullptr) continue;
        text += fmt::format("\n{} {}", scan.sha256, scan.cloud);
        for (const double v : pose->site_from_scan) text += fmt::format(" {}", v);
        for (const double v : pose->covariance) text += fmt::format(" {}", v);
    }
    if (text.empty()) return {};
    return sha256(fmt::format("{}{} {} {} {} {} {}{}", kVersion, frame.west, frame.south, frame.columns, frame.rows,
                              frame.cell, record.settings.tolerance, text));
}

scans::SurfaceGrid cached_surface(Project& project, model::SurfaceId surface, const scans::GridFrame& frame,
                                  const std::string& key, Progress& progress) {
    const fs::path file = scans_folder(project.path()) / "surfaces" / (key.substr(0, 32) + ".grid");
    if (auto cached = read_cached(file, frame)) return std::move(*cached);
    scans::SurfaceOptions options;
    options.tolerance = project.record().settings.tolerance;
    scans::SurfaceGrid grid =
        scans::build_surface(surface_scans(project, surface, progress), frame, options, progress).grid;
    write_sealed(file, to_bytes(grid));
    return grid;
}

} // namespace planum::app
