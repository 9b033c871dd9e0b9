// SPDX-License-Identifier: MIT
#include "app/scans/verify_scans.hpp"

#include <cerrno>
#include <csignal>
#include <set>

#include <fmt/format.h>

#include "app/scans/scan_stores.hpp"
#include "core/base/error.hpp"
#include "core/base/sha256.hpp"
#include "core/base/text.hpp"
#include "core/base/whole_progress.hpp"

namespace planum::app {

namespace {

namespace fs = std::filesystem;

// Empty when the original is what was added.
std::string original_problem(const fs::path& original, const model::Scan& scan, Progress& progress) {
    if (!fs::exists(original)) {
        return "its original is not there: " + original.string() + "; put it back, its points could not be made again";
    }
    if (sha256_of_file(original, progress) != scan.sha256) {
        return original.string() + " is no longer the file that was added (its hash differs); put that back, or delete "
                                   "the scan and add the file as it is "
                                   "now";
    }
    return {};
}

// Empty when the store is sound or not there.
std::string store_problem(const fs::path& file, Progress& progress) {
    if (!fs::exists(file)) return {};
    try {
        const scans::PointStore store = scans::PointStore::open(file);
        const std::vector<scans::DamagedBlock> damaged = store.verify(progress);
        if (damaged.empty()) return {};
        return fmt::format("{} of {} blocks of its point store are damaged, the first at byte {} with {} points",
                           damaged.size(), store.nodes().size(), damaged.front().at, damaged.front().points);
    } catch (const Error& e) {
        if (e.code() != ErrorCode::BadInput) throw;
        return std::string("its point store is damaged: ") + e.what();
    }
}

// The damaged store goes only when the new one is whole: building renames over it.
std::string mend(const Project& project, const model::Scan& scan, Progress& progress) {
    try {
        rebuild_store(project.path(), scan, progress);
        return "; made again from the original";
    } catch (const Error& e) {
        if (e.code() == ErrorCode::Cancelled) throw;
        return std::string("; it could not be made again: ") + e.what();
    }
}

bool is_running(std::string_view process) {
    const auto number = text::parse_integer(process);
    if (!number || *number <= 0) return false;
    // Another user's program may not be signalled, and runs all the same.
    return ::kill(static_cast<pid_t>(*number), 0) == 0 || errno == EPERM;
}

// `NAME.PID.part`, of a program that is no longer there.
bool is_left_behind(const fs::path& file) {
    if (file.extension() != ".part") return false;
    const std::string process = file.stem().extension().string();
    return process.size() < 2 || !is_running(std::string_view(process).substr(1));
}

} // namespace

std::vector<ScanProblem> verify_scans(Project& project, Progress& progress) {
    std::vector<ScanProblem> problems;
    const std::vector<model::Scan>& scans = project.record().scans;
    WholeProgress whole(progress, fmt::format("checking {} scans and their points", scans.size()));
    for (std::size_t i = 0; i < scans.size(); ++i) {
        const model::Scan& scan = scans[i];
        whole.part(static_cast<double>(i + 1) / static_cast<double>(scans.size()), 2); // the original, then the store
        whole.check();
        const std::string original = original_problem(original_path(project.path(), scan), scan, whole);
        whole.step("points");
        std::string store = store_problem(store_path(project.path(), scan), whole);
        if (!store.empty() && original.empty()) store += mend(project, scan, whole);
        for (const std::string& what : {original, store}) {
            if (!what.empty()) problems.push_back({"scan " + scan.name, what});
        }
    }
    return problems;
}

CleanedScans clean_scans(Project& project) {
    CleanedScans cleaned;
    const fs::path folder = scans_folder(project.path());
    if (!fs::is_directory(folder)) return cleaned;
    std::set<fs::path> wanted;
    for (const model::Scan& scan : project.record().scans) wanted.insert(store_path(project.path(), scan));
    for (const auto& entry : fs::directory_iterator(folder)) {
        const fs::path& file = entry.path();
        const bool of_no_scan = file.extension() == ".pts" && !wanted.contains(file);
        if (entry.is_regular_file() && (of_no_scan || is_left_behind(file))) cleaned.removed.push_back(file);
    }
    for (const fs::path& file : cleaned.removed) {
        std::error_code error;
        cleaned.bytes += fs::file_size(file, error);
        fs::remove(file, error);
        if (error) throw Error(ErrorCode::Io, file.string() + ": cannot be removed: " + error.message());
    }
    return cleaned;
}

} // namespace planum::app
