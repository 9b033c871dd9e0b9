// SPDX-License-Identifier: MIT
#include "app/surfaces/surface_cache.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/project/sealed_file.hpp"
#include "app/scans/scan_stores.hpp"
#include "app/scans/surface_scans.hpp"
#include "core/base/sha256.hpp"

namespace planum::app {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kVersion = "planum surface grid 6\n";

template<class Value>
void append(std::string& bytes, const std::vector<Value>& values) {
    const std::size_t at = bytes.size();
    bytes.resize(at + values.size() * sizeof(Value));
    if (!values.empty()) std::memcpy(bytes.data() + at, values.data(), values.size() * sizeof(Value));
}

template<class Value>
void take(std::string_view& bytes, std::vector<Value>& values, std::size_t count) {
    values.resize(count);
    if (count == 0) return;
    std::memcpy(values.data(), bytes.data(), count * sizeof(Value));
    bytes.remove_prefix(count * sizeof(Value));
}

constexpr std::size_t kBytesOfCell = 7 * sizeof(float) + sizeof(std::uint16_t) + 1;

using nlohmann::json;

std::string text_of(const std::vector<scans::DisputedPatch>& disputed) {
    json patches = json::array();
    for (const scans::DisputedPatch& p : disputed)
        patches.push_back({p.x, p.y, p.area, p.difference, p.detectable, p.lower, p.higher, p.cells});
    // Names of scans are names of files, whose bytes need not be UTF-8.
    return patches.dump(-1, ' ', false, json::error_handler_t::replace);
}

// Cells beyond `cells` can only come from another program; nothing is made of them.
std::optional<std::vector<scans::DisputedPatch>> disputed_from(std::string_view text, std::size_t cells) {
    std::vector<scans::DisputedPatch> disputed;
    try {
        for (const json& p : json::parse(text)) {
            disputed.push_back({p.at(0), p.at(1), p.at(2), p.at(3), p.at(4), p.at(5), p.at(6),
                                p.at(7).get<std::vector<std::size_t>>()});
            for (const std::size_t cell : disputed.back().cells) {
                if (cell >= cells) return std::nullopt;
            }
        }
    } catch (const json::exception&) {
        return std::nullopt;
    }
    return disputed;
}

std::string to_bytes(const KeptSurface& surface) {
    const scans::SurfaceGrid& grid = surface.grid;
    std::string bytes{kVersion};
    append(bytes, grid.height);
    append(bytes, grid.spread);
    append(bytes, grid.pose_sigma);
    append(bytes, grid.slope);
    append(bytes, grid.count);
    append(bytes, grid.state);
    append(bytes, grid.side_east);
    append(bytes, grid.side_north);
    append(bytes, grid.ceiling);
    append(bytes, std::vector{static_cast<std::uint64_t>(surface.as_seen.size())});
    append(bytes, surface.as_seen);
    bytes += text_of(surface.disputed);
    return bytes;
}

std::optional<KeptSurface> read_cached(const fs::path& file, const scans::GridFrame& frame) {
    const std::optional<std::string> kept = read_sealed(file);
    const std::size_t n = frame.cells();
    if (!kept || kept->size() < kVersion.size() + n * kBytesOfCell + sizeof(std::uint64_t) ||
        !kept->starts_with(kVersion))
        return std::nullopt;
    std::string_view bytes = *kept;
    bytes.remove_prefix(kVersion.size());
    KeptSurface surface;
    scans::SurfaceGrid& grid = surface.grid;
    grid.frame = frame;
    take(bytes, grid.height, n);
    take(bytes, grid.spread, n);
    take(bytes, grid.pose_sigma, n);
    take(bytes, grid.slope, n);
    take(bytes, grid.count, n);
    take(bytes, grid.state, n);
    take(bytes, grid.side_east, n);
    take(bytes, grid.side_north, n);
    take(bytes, grid.ceiling, n);
    std::vector<std::uint64_t> cells;
    take(bytes, cells, 1);
    if (cells[0] > n || bytes.size() < cells[0] * sizeof(scans::CellAsSeen)) return std::nullopt;
    take(bytes, surface.as_seen, static_cast<std::size_t>(cells[0]));
    std::optional<std::vector<scans::DisputedPatch>> disputed = disputed_from(bytes, n);
    if (!disputed) return std::nullopt;
    surface.disputed = std::move(*disputed);
    return surface;
}

} // namespace

std::vector<scans::SurfaceScan> surface_scans(Project& project, model::SurfaceId surface, Progress& progress) {
    std::vector<scans::SurfaceScan> scans;
    const std::vector<const model::Scan*> wanted = scans_of(project.record(), surface);
    const auto is_wanted = [&](const model::Scan& scan) {
        return std::find(wanted.begin(), wanted.end(), &scan) != wanted.end();
    };
    for (const PlacedScan& placed : placed_scans(project, is_wanted, progress)) {
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
    for (const model::Scan* scan : scans_of(record, surface)) {
        const model::ScanPose* pose = model::pose_in_force(record, scan->id);
        if (pose == nullptr) continue;
        text += fmt::format("\n{} {}", scan->sha256, scan->cloud);
        for (const double v : pose->site_from_scan) text += fmt::format(" {}", v);
        for (const double v : pose->covariance) text += fmt::format(" {}", v);
    }
    if (text.empty()) return {};
    return sha256(fmt::format("{}{} {} {} {} {} {}{}", kVersion, frame.west, frame.south, frame.columns, frame.rows,
                              frame.cell, record.settings.tolerance, text));
}

KeptSurface kept_surface(Project& project, model::SurfaceId surface, const scans::GridFrame& frame,
                         const std::string& key, Progress& progress) {
    const fs::path file = scans_folder(project.path()) / "surfaces" / (key.substr(0, 32) + ".grid");
    if (auto cached = read_cached(file, frame)) return std::move(*cached);
    scans::SurfaceOptions options;
    options.tolerance = project.record().settings.tolerance;
    scans::BuiltSurface built =
        scans::build_surface(surface_scans(project, surface, progress), frame, options, progress);
    KeptSurface kept{std::move(built.grid), std::move(built.as_seen), std::move(built.disputed)};
    write_sealed(file, to_bytes(kept));
    return kept;
}

scans::SurfaceGrid seen_surface(Project& project, model::SurfaceId surface, const scans::GridFrame& frame,
                                const std::string& key, Progress& progress) {
    KeptSurface kept = kept_surface(project, surface, frame, key, progress);
    scans::put_back(kept.grid, kept.as_seen);
    return std::move(kept.grid);
}

} // namespace planum::app
