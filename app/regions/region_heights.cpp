// SPDX-License-Identifier: MIT
#include "app/regions/region_heights.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "app/project/sealed_file.hpp"
#include "app/regions/region_points.hpp"
#include "core/base/error.hpp"
#include "core/base/sha256.hpp"
#include "core/base/text.hpp"

namespace planum::app {

namespace fs = std::filesystem;

namespace {

constexpr double kTail = 0.005; ///< share of the points left out at either end
constexpr const char* kCacheVersion = "region-heights-2";

fs::path heights_folder(const fs::path& project) { return scans_folder(project) / "regions"; }

bool any_placed(const model::Record& record) {
    return std::any_of(record.scans.begin(), record.scans.end(),
                       [&](const model::Scan& scan) { return model::pose_in_force(record, scan.id) != nullptr; });
}

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
    text += fmt::format("\n{} {}", ground.low, ground.high);
    // Of parallel sections all but one number of the frame may be the same.
    for (const double v : geometry::to_row_major(ground.frame_from_site)) text += fmt::format(" {}", v);
    for (const model::Scan* scan : scans) {
        text += fmt::format("\n{} {}", scan->sha256, scan->cloud);
        for (const double v : model::pose_in_force(record, scan->id)->site_from_scan) text += fmt::format(" {}", v);
    }
    return sha256(text);
}

std::optional<RegionHeights> read_cached(const fs::path& file) {
    const std::optional<std::string> kept = read_sealed(file);
    if (!kept) return std::nullopt;
    const auto words = text::split(*kept, ' ');
    if (words.size() != 4) return std::nullopt;
    const auto points = text::parse_integer(words[0]);
    const auto low = text::parse_double(words[1]);
    const auto middle = text::parse_double(words[2]);
    const auto high = text::parse_double(words[3]);
    if (!points || !low || !middle || !high) return std::nullopt;
    return RegionHeights{*points, false, false, *low, *middle, *high};
}

void write_cached(const fs::path& file, const RegionHeights& h) {
    write_sealed(file, fmt::format("{} {} {} {}", h.points, h.lowest, h.median, h.highest));
}

// Placed scans by position in the record, each opened once for as long as regions in a row want it: a site of years has
// more scans than a program may have files open.
class OpenScans {
  public:
    OpenScans(Project& project, std::vector<ScanProblem>& problems)
        : project_(project), problems_(problems), failed_(project.record().scans.size(), false) {}

    // Those of the wanted that can be read; each that cannot becomes a problem once.
    std::vector<PlacedScan> take(const std::vector<std::size_t>& wanted, Progress& progress) {
        std::erase_if(
            open_, [&](const auto& one) { return std::find(wanted.begin(), wanted.end(), one.first) == wanted.end(); });
        std::vector<PlacedScan> taken;
        for (const std::size_t at : wanted) {
            if (!failed_[at] && !open_.contains(at)) open(at, progress);
            if (const auto it = open_.find(at); it != open_.end()) taken.push_back(it->second);
        }
        return taken;
    }

  private:
    void open(std::size_t at, Progress& progress) {
        const model::Scan& scan = project_.record().scans[at];
        try {
            for (PlacedScan& placed : placed_scans(
                     project_, [&](const model::Scan& other) { return other.id == scan.id; }, progress)) {
                open_.emplace(at, std::move(placed));
            }
        } catch (const Error& e) {
            if (e.code() == ErrorCode::Cancelled) throw;
            failed_[at] = true;
            problems_.push_back({"scan " + scan.name, e.what()});
        }
    }

    Project& project_;
    std::vector<ScanProblem>& problems_;
    std::vector<bool> failed_;
    std::map<std::size_t, PlacedScan> open_;
};

// One region that points are to be counted of.
struct Task {
    std::size_t region = 0;
    std::vector<std::size_t> scans; ///< positions in the record
    fs::path kept;
};

// The regions that some registered scan may show, in the order of the record.
std::vector<Task> tasks_of(const Project& project, const model::Record& record,
                           const std::vector<RegionGround>& grounds) {
    std::vector<Task> tasks;
    for (std::size_t i = 0; i < grounds.size(); ++i) {
        Task task{i, {}, {}};
        std::vector<const model::Scan*> scans;
        for (std::size_t at = 0; at < record.scans.size(); ++at) {
            const model::Scan& scan = record.scans[at];
            if (model::pose_in_force(record, scan.id) == nullptr || !may_show(record, scan, record.regions[i]))
                continue;
            task.scans.push_back(at);
            scans.push_back(&scan);
        }
        if (scans.empty() || grounds[i].shape.empty()) continue;
        task.kept = heights_folder(project.path()) / (key_of(grounds[i], scans, record).substr(0, 32) + ".txt");
        tasks.push_back(std::move(task));
    }
    return tasks;
}

} // namespace

CountedHeights heights_of_regions(Project& project, Progress& progress) {
    const model::Record& record = project.record();
    CountedHeights counted;
    counted.regions.resize(record.regions.size());
    if (!any_placed(record)) return counted;
    const std::vector<RegionGround> grounds = region_grounds(record);
    std::vector<Task> tasks = tasks_of(project, record, grounds);
    std::erase_if(tasks, [&](const Task& task) {
        const auto known = read_cached(task.kept);
        if (!known) return false;
        counted.regions[task.region] = *known;
        counted.regions[task.region].outside_scans = known->points == 0;
        return true;
    });
    std::stable_sort(tasks.begin(), tasks.end(), [](const Task& a, const Task& b) { return a.scans < b.scans; });
    OpenScans scans(project, counted.problems);
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        progress.check();
        progress.fraction(static_cast<double>(i) / static_cast<double>(tasks.size()));
        const Task& task = tasks[i];
        const std::vector<PlacedScan> placed = scans.take(task.scans, progress);
        RegionHeights& heights = counted.regions[task.region];
        heights = heights_of(grounds[task.region], placed);
        heights.incomplete = placed.size() < task.scans.size();
        heights.outside_scans = heights.points == 0 && !heights.incomplete;
        if (!heights.incomplete) write_cached(task.kept, heights);
    }
    return counted;
}

std::vector<fs::path> stale_region_heights(Project& project) {
    constexpr auto kSurelyLeftOver = std::chrono::hours(24); // no file of this size is written for a day
    std::vector<fs::path> stale;
    const fs::path folder = heights_folder(project.path());
    if (!fs::is_directory(folder)) return stale;
    const model::Record& record = project.record();
    std::set<fs::path> wanted;
    for (const Task& task : tasks_of(project, record, region_grounds(record))) wanted.insert(task.kept);
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (!entry.is_regular_file() || wanted.contains(entry.path())) continue;
        const bool old = fs::file_time_type::clock::now() - entry.last_write_time() > kSurelyLeftOver;
        if (entry.path().extension() == ".txt" || old) stale.push_back(entry.path());
    }
    std::sort(stale.begin(), stale.end());
    return stale;
}

} // namespace planum::app
