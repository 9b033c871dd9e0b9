// SPDX-License-Identifier: MIT
#include "app/regions/region_heights.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "app/regions/region_points.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/sha256.hpp"
#include "core/base/text.hpp"

namespace planum::app {

namespace fs = std::filesystem;

namespace {

constexpr double kTail = 0.005; ///< share of the points left out at either end
constexpr const char* kCacheVersion = "region-heights-1";

RegionHeights heights_of(const RegionGround& ground, const std::vector<PlacedScan>& scans) {
    std::vector<float> z; // relative to the first: a float keeps a tenth of a millimetre within a trench
    double zero = 0.0;
    for_points_on(ground, scans, [&](const RegionPoint& point) {
        if (z.empty()) zero = point.x_in_site.z();
        z.push_back(static_cast<float>(point.x_in_site.z() - zero));
    });
    RegionHeights heights;
    heights.points = static_cast<std::int64_t>(z.size());
    if (z.empty()) return heights;
    const auto quantile = [&](double share) {
        const auto at = static_cast<std::ptrdiff_t>(std::lround(share * static_cast<double>(z.size() - 1)));
        std::nth_element(z.begin(), z.begin() + at, z.end());
        return zero + static_cast<double>(z[static_cast<std::size_t>(at)]);
    };
    heights.lowest = quantile(kTail);
    heights.median = quantile(0.5);
    heights.highest = quantile(1.0 - kTail);
    return heights;
}

// All that the heights of one region depend on.
std::string key_of(const RegionGround& ground, const std::vector<const model::Scan*>& scans,
                   const model::Record& record) {
    std::string text = kCacheVersion;
    for (const auto& rings : ground.shape) {
        for (const auto& ring : rings) {
            text += "ring";
            for (const auto& p : ring) text += fmt::format(" {} {}", p[0], p[1]);
        }
    }
    text += fmt::format("\n{} {} {}", ground.low, ground.high, ground.frame_from_site.translation.x());
    for (const model::Scan* scan : scans) {
        text += fmt::format("\n{} {}", scan->sha256, scan->cloud);
        for (const double v : model::pose_in_force(record, scan->id)->site_from_scan) text += fmt::format(" {}", v);
    }
    return sha256(text);
}

std::optional<RegionHeights> read_cached(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error)) return std::nullopt;
    try {
        const std::string bytes = read_file(file, 1000);
        const auto words = text::split(text::trim(bytes), ' ');
        if (words.size() != 4) return std::nullopt;
        const auto points = text::parse_integer(words[0]);
        const auto low = text::parse_double(words[1]);
        const auto middle = text::parse_double(words[2]);
        const auto high = text::parse_double(words[3]);
        if (!points || !low || !middle || !high) return std::nullopt;
        return RegionHeights{*points, false, *low, *middle, *high};
    } catch (const Error&) {
        return std::nullopt; // only a cache
    }
}

void write_cached(const fs::path& file, const RegionHeights& h) {
    try {
        fs::create_directories(file.parent_path());
        write_file_atomically(file, fmt::format("{} {} {} {}\n", h.points, h.lowest, h.median, h.highest));
    } catch (const Error&) {
        return; // read-only media: count again next time
    } catch (const fs::filesystem_error&) {
        return;
    }
}

} // namespace

std::vector<RegionHeights> heights_of_regions(Project& project, Progress& progress) {
    const model::Record& record = project.record();
    std::vector<RegionHeights> heights(record.regions.size());
    const bool placed_any = std::any_of(record.scans.begin(), record.scans.end(), [&](const model::Scan& scan) {
        return model::pose_in_force(record, scan.id) != nullptr;
    });
    if (!placed_any) return heights;
    const std::vector<RegionGround> grounds = region_grounds(record);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        progress.check();
        progress.fraction(static_cast<double>(i) / static_cast<double>(heights.size()));
        std::vector<const model::Scan*> wanted;
        for (const model::Scan& scan : record.scans) {
            if (model::pose_in_force(record, scan.id) != nullptr && may_show(record, scan, record.regions[i])) {
                wanted.push_back(&scan);
            }
        }
        if (wanted.empty() || grounds[i].shape.empty()) continue;
        const fs::path cached =
            scans_folder(project.path()) / "regions" / (key_of(grounds[i], wanted, record).substr(0, 32) + ".txt");
        if (const auto known = read_cached(cached)) {
            heights[i] = *known;
            heights[i].outside_scans = known->points == 0;
            continue;
        }
        const auto is_wanted = [&](const model::Scan& scan) {
            return std::any_of(wanted.begin(), wanted.end(), [&](const auto* w) { return w->id == scan.id; });
        };
        heights[i] = heights_of(grounds[i], placed_scans(project, is_wanted, progress));
        heights[i].outside_scans = heights[i].points == 0;
        write_cached(cached, heights[i]);
    }
    return heights;
}

} // namespace planum::app
