// SPDX-License-Identifier: MIT
#include "app/scans/scan_stores.hpp"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/sha256.hpp"
#include "scans/cloud/store_builder.hpp"
#include "scans/formats/scan_reader.hpp"

namespace planum::app {

namespace fs = std::filesystem;

fs::path scans_folder(const fs::path& project) {
    fs::path folder = project;
    return folder.replace_extension(".scans");
}

fs::path store_path(const fs::path& project, const model::Scan& scan) {
    // The same bytes read by other columns are other points.
    const std::string columns = stated_columns(scan);
    const std::string key = columns.empty() ? scan.sha256 : sha256(scan.sha256 + ' ' + columns);
    return scans_folder(project) / fmt::format("{}-{}.pts", key.substr(0, 24), scan.cloud);
}

fs::path original_path(const fs::path& project, const model::Scan& scan) {
    const fs::path path(scan.path);
    return path.is_absolute() ? path : (project.parent_path() / path).lexically_normal();
}

std::string path_to_keep(const fs::path& project, const fs::path& file) {
    const fs::path whole = fs::weakly_canonical(file);
    const fs::path relative = whole.lexically_relative(fs::weakly_canonical(fs::absolute(project)).parent_path());
    return relative.empty() ? whole.string() : relative.string();
}

std::string stated_columns(const model::Scan& scan) {
    const std::size_t blank = scan.format.find(' ');
    return blank == std::string::npos ? std::string() : scan.format.substr(blank + 1);
}

void rebuild_store(const fs::path& project, const model::Scan& scan, Progress& progress) {
    const fs::path file = store_path(project, scan);
    const fs::path original = original_path(project, scan);
    if (!fs::exists(original)) {
        throw Error(
            ErrorCode::NotFound,
            fmt::format("scan {}: its points are not in {} and the original {} is not there either; put it back "
                        "or add the scan again from where it is now",
                        scan.name, file.filename().string(), original.string()));
    }
    if (sha256_of_file(original, progress) != scan.sha256) {
        throw Error(ErrorCode::BadInput, fmt::format("scan {}: {} is no longer the file that was added (its hash "
                                                     "differs); put that back, or delete the scan "
                                                     "and add the file as it is now",
                                                     scan.name, original.string()));
    }
    progress.step("making the point store of " + scan.name + " again");
    const auto reader = scans::open_scan(original, {stated_columns(scan)}, progress);
    const auto cloud = static_cast<std::size_t>(scan.cloud);
    if (cloud >= reader->clouds().size()) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("scan {}: {} has no cloud {}", scan.name, original.string(), cloud));
    }
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error) throw Error(ErrorCode::Io, file.parent_path().string() + ": cannot be made: " + error.message());
    scans::build_store(*reader, cloud, file, scans::store_info(reader->clouds()[cloud], scan.name, scan.sha256, cloud),
                       {}, progress);
}

std::shared_ptr<const scans::PointStore> open_store(const fs::path& project, const model::Scan& scan,
                                                    Progress& progress) {
    const fs::path file = store_path(project, scan);
    if (fs::exists(file)) {
        try {
            return std::make_shared<const scans::PointStore>(scans::PointStore::open(file));
        } catch (const Error& e) {
            if (e.code() != ErrorCode::BadInput) throw;
            // No sound store, e.g. of an older format: it is only a cache.
        }
    }
    rebuild_store(project, scan, progress);
    return std::make_shared<const scans::PointStore>(scans::PointStore::open(file));
}

std::vector<PlacedScan> placed_scans(Project& project, const std::function<bool(const model::Scan&)>& wanted,
                                     Progress& progress) {
    const model::Record& record = project.record();
    std::vector<PlacedScan> placed;
    for (const model::Scan& scan : record.scans) {
        if (wanted && !wanted(scan)) continue;
        const model::ScanPose* pose = model::pose_in_force(record, scan.id);
        if (pose == nullptr) continue;
        PlacedScan one;
        one.scan = scan;
        one.site_from_scan = geometry::from_row_major(pose->site_from_scan);
        one.covariance = Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(pose->covariance.data());
        one.rms = pose->rms;
        one.store = open_store(project.path(), scan, progress);
        placed.push_back(std::move(one));
    }
    return placed;
}

} // namespace planum::app
