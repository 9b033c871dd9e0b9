// SPDX-License-Identifier: MIT
#include "app/project/clean.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "app/regions/region_heights.hpp"
#include "app/scans/scan_stores.hpp"
#include "app/scans/verify_scans.hpp"
#include "core/base/error.hpp"
#include "core/base/uuid.hpp"

namespace planum::app {

namespace fs = std::filesystem;

namespace {

constexpr auto kSurelyLeftOver = std::chrono::hours(24); // no backup takes a day

// `site.gpkg.UUID.new`, as `new` and `backup` name what they have not finished.
bool is_unfinished(const std::string& name, const std::string& project) {
    constexpr std::string_view kEnding = ".new";
    const std::string start = project + ".";
    if (!name.starts_with(start) || !name.ends_with(kEnding) || name.size() <= start.size() + kEnding.size()) {
        return false;
    }
    return Uuid::parse(name.substr(start.size(), name.size() - start.size() - kEnding.size())).has_value();
}

std::vector<fs::path> left_over(const fs::path& project) {
    std::vector<fs::path> found;
    const fs::path folder = project.parent_path(); // empty: here
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.empty() ? fs::path(".") : folder)) {
        if (!entry.is_regular_file() || !is_unfinished(entry.path().filename().string(), project.filename().string())) {
            continue;
        }
        if (fs::file_time_type::clock::now() - entry.last_write_time() > kSurelyLeftOver)
            found.push_back(folder / entry.path().filename());
    }
    return found;
}

// Gridded surfaces and what was found between them: each redrawn outline and each new pose leaves old ones, and all are
// made again when they are asked for. What another program writes just now has another ending.
std::vector<fs::path> surface_caches(const fs::path& project) {
    constexpr std::array<std::string_view, 6> kEndings = {".grid",    ".summary", ".step",
                                                          ".density", ".floor",   ".altered"};
    std::vector<fs::path> found;
    for (const char* name : {"surfaces", "evidence"}) {
        const fs::path folder = scans_folder(project) / name;
        if (!fs::is_directory(folder)) continue;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
            if (!entry.is_regular_file()) continue;
            const std::string ending = entry.path().extension().string();
            const bool ours = std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
            if (ours || fs::file_time_type::clock::now() - entry.last_write_time() > kSurelyLeftOver)
                found.push_back(entry.path());
        }
    }
    return found;
}

} // namespace

Cleaned clean_project(Project& project, const std::string& forget_undo_before, Progress& progress) {
    Cleaned cleaned;
    progress.step("cleaning");
    try {
        if (!forget_undo_before.empty()) {
            cleaned.forgotten_changes = project.file().forget_changes(forget_undo_before);
        }
        const std::uintmax_t before = fs::file_size(project.path());
        project.file().compact();
        const std::uintmax_t after = fs::file_size(project.path());
        cleaned.freed_bytes = before > after ? before - after : 0;
        CleanedScans scans = clean_scans(project);
        cleaned.removed = std::move(scans.removed);
        cleaned.removed_bytes = scans.bytes;
        std::vector<fs::path> unneeded = left_over(project.path());
        const std::vector<fs::path> stale = stale_region_heights(project);
        unneeded.insert(unneeded.end(), stale.begin(), stale.end());
        const std::vector<fs::path> caches = surface_caches(project.path());
        unneeded.insert(unneeded.end(), caches.begin(), caches.end());
        for (const fs::path& file : unneeded) {
            cleaned.removed_bytes += fs::file_size(file);
            fs::remove(file);
            cleaned.removed.push_back(file);
        }
        std::sort(cleaned.removed.begin(), cleaned.removed.end());
    } catch (const fs::filesystem_error& e) {
        throw Error(ErrorCode::Io, fmt::format("{}: {}", e.path1().string(), e.code().message()));
    }
    return cleaned;
}

} // namespace planum::app
