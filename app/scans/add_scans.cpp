// SPDX-License-Identifier: MIT
#include "app/scans/add_scans.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "app/scans/days_surface.hpp"
#include "app/scans/scan_stores.hpp"
#include "core/base/error.hpp"
#include "core/base/sha256.hpp"
#include "core/base/text.hpp"
#include "core/base/whole_progress.hpp"
#include "scans/cloud/store_builder.hpp"
#include "scans/formats/scan_reader.hpp"

namespace planum::app {

namespace fs = std::filesystem;

namespace {

bool has_scan_ending(const fs::path& file) {
    static const std::set<std::string> endings = {".ptx", ".e57", ".las", ".ply", ".pcd",
                                                  ".pts", ".xyz", ".3d",  ".laz"};
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    return endings.contains(ending);
}

struct FoundFiles {
    std::vector<fs::path> files;
    std::vector<std::string> left_aside;
};

// A folder gives its scan files only: beside them lie markers, outlines and notes.
FoundFiles expand(const std::vector<fs::path>& inputs) {
    FoundFiles found;
    for (const fs::path& input : inputs) {
        if (!fs::exists(input)) throw Error(ErrorCode::NotFound, input.string() + ": no such file or folder");
        if (!fs::is_directory(input)) {
            found.files.push_back(input);
            continue;
        }
        for (auto walk = fs::recursive_directory_iterator(input); walk != fs::recursive_directory_iterator(); ++walk) {
            const fs::directory_entry& entry = *walk;
            // Point stores end in .pts as the text format does; a project's caches are no scans.
            if (entry.is_directory() && entry.path().extension() == ".scans") walk.disable_recursion_pending();
            if (!entry.is_regular_file()) continue;
            if (has_scan_ending(entry.path())) {
                found.files.push_back(entry.path());
            } else if (entry.path().extension() != ".pose") {
                found.left_aside.push_back(entry.path().string() + ": not the ending of a scan");
            }
        }
    }
    const auto natural = [](const auto& a, const auto& b) { return text::natural_order(a, b) < 0; };
    std::sort(found.files.begin(), found.files.end(),
              [&](const fs::path& a, const fs::path& b) { return natural(a.string(), b.string()); });
    std::sort(found.left_aside.begin(), found.left_aside.end(), natural);
    found.files.erase(std::unique(found.files.begin(), found.files.end()), found.files.end());
    if (found.files.empty())
        throw Error(ErrorCode::Usage, "no scan file there (.ptx .e57 .las .ply .pcd .pts .xyz .3d)");
    return found;
}

FoundFiles find_files(const std::vector<fs::path>& inputs) {
    try {
        return expand(inputs);
    } catch (const fs::filesystem_error& e) {
        throw Error(ErrorCode::Io, fmt::format("{}: {}", e.path1().string(), e.code().message()));
    }
}

/// Of the time that a scan takes, what goes into its hash and header; the rest into its points.
constexpr double kLookingShare = 0.25;

// How far the work is when so many bytes of all are through: first all files are looked into, then all are read.
class Shares {
  public:
    explicit Shares(const std::vector<fs::path>& files) {
        for (const fs::path& file : files) all_ += size_of(file);
    }

    [[nodiscard]] static double size_of(const fs::path& file) {
        std::error_code unknown;
        const std::uintmax_t bytes = fs::file_size(file, unknown);
        return unknown ? 1.0 : static_cast<double>(bytes) + 1.0;
    }

    [[nodiscard]] double looked_into(double bytes) { return kLookingShare * (looked_ += bytes) / all_; }

    // Files that are in the project already need no reading.
    [[nodiscard]] double read(double bytes, double bytes_to_read) {
        return kLookingShare + (1.0 - kLookingShare) * (read_ += bytes) / bytes_to_read;
    }

  private:
    double all_ = 0.0;
    double looked_ = 0.0;
    double read_ = 0.0;
};

std::string name_of_work(const std::vector<fs::path>& files) {
    return files.size() == 1 ? "adding " + files.front().filename().string()
                             : fmt::format("adding {} scan files", files.size());
}

// What is to be added, before anything is made.
struct Plan {
    struct File {
        fs::path path;
        std::unique_ptr<scans::ScanReader> reader;
        std::vector<AddedScan> clouds;
    };

    std::vector<File> files;
    std::vector<ScanThere> there_already;
    std::vector<model::Scan> moved; // with the path where they are now
};

std::string day_for(const fs::path& file, const scans::CloudHeader& header, const AddScansOptions& options,
                    std::vector<std::string>& notes) {
    if (!options.day.empty()) return options.day;
    if (const auto day = scans::day_of_folder(fs::absolute(file))) return *day;
    const std::string own = header.acquired_from.substr(0, 10);
    if (is_day(own)) {
        notes.push_back("the day is the one written in the file");
        return own;
    }
    throw Error(ErrorCode::Usage, file.string() + ": of which day? Put it into a folder named by its date "
                                                  "(2025-06-01) or say --day 2025-06-01");
}

class Planner {
  public:
    Planner(Project& project, const AddScansOptions& options) : project_(project), options_(options) {
        for (const model::Scan& scan : project.record().scans) {
            by_content_[{scan.sha256, scan.cloud}] = scan.name;
            by_name_[scan.name] = scan.format;
        }
    }

    void add(const fs::path& path, Progress& progress) {
        progress.check();
        const std::string hash = sha256_of_file(path, progress);
        if (const auto there = by_content_.find({hash, 0}); there != by_content_.end()) {
            plan_.there_already.push_back({path.string(), there->second, found_again(hash, path)});
            return;
        }
        progress.step("looking into " + path.filename().string());
        Plan::File file{path, scans::open_scan(path, {options_.columns}, progress), {}};
        const auto& clouds = file.reader->clouds();
        if (clouds.empty()) throw Error(ErrorCode::BadInput, path.string() + ": has no scan in it");
        for (std::size_t c = 0; c < clouds.size(); ++c) file.clouds.push_back(cloud_of(file, c, hash));
        plan_.files.push_back(std::move(file));
    }

    [[nodiscard]] Plan take() { return std::move(plan_); }

  private:
    // Where the scans of this content were looked for, if they are no longer there; from now on they are looked for
    // here.
    std::string found_again(const std::string& hash, const fs::path& path) {
        std::string missed;
        for (const model::Scan& scan : project_.record().scans) {
            if (scan.sha256 != hash || fs::exists(original_path(project_.path(), scan))) continue;
            const bool is_found = std::any_of(plan_.moved.begin(), plan_.moved.end(),
                                              [&](const model::Scan& found) { return found.id == scan.id; });
            if (is_found) continue; // a second copy in the same call: the first one is as good
            missed = scan.path;
            plan_.moved.push_back(scan);
            plan_.moved.back().path = path_to_keep(project_.path(), path);
        }
        return missed;
    }

    AddedScan cloud_of(const Plan::File& file, std::size_t cloud, const std::string& hash) {
        const scans::CloudHeader& header = file.reader->clouds()[cloud];
        const scans::ScanFileInfo& info = file.reader->info();
        AddedScan added;
        added.notes = cloud == 0 ? info.notes : std::vector<std::string>{};
        added.notes.insert(added.notes.end(), header.notes.begin(), header.notes.end());
        if (!info.column_guess.empty() && cloud == 0) added.notes.push_back("columns read as " + info.column_guess);
        model::Scan& scan = added.scan;
        scan.day = day_for(file.path, header, options_, added.notes);
        scan.format = scans::format_name(info.format);
        // Whoever makes the store again must read the same columns.
        if (!options_.columns.empty() && info.format == scans::ScanFormat::Xyz) scan.format += " " + options_.columns;
        scan.name = name_for(file.path, scan.day, scan.format, cloud);
        scan.path = path_to_keep(project_.path(), file.path);
        scan.sha256 = hash;
        scan.cloud = static_cast<std::int64_t>(cloud);
        scan.rows = static_cast<std::int64_t>(header.rows);
        scan.columns = static_cast<std::int64_t>(header.columns);
        scan.sensor = header.sensor;
        scan.acquired_at = header.acquired_from;
        if (header.has_pose) {
            scan.header_pose.emplace();
            Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(scan.header_pose->data()) =
                header.site_from_scan.matrix();
        }
        by_content_[{hash, scan.cloud}] = scan.name;
        by_name_[scan.name] = scan.format;
        return added;
    }

    // `DAY/STEM`, with the ending where another format has that stem, and `#2` for further clouds.
    [[nodiscard]] std::string name_for(const fs::path& path, const std::string& day, const std::string& format,
                                       std::size_t cloud) const {
        const std::string further = cloud > 0 ? fmt::format("#{}", cloud + 1) : "";
        const std::string plain = fmt::format("{}/{}{}", day, path.stem().string(), further);
        const auto there = by_name_.find(plain);
        if (there == by_name_.end()) return plain;
        const std::string with_ending = fmt::format("{}/{}{}", day, path.filename().string(), further);
        if (there->second != format && !by_name_.contains(with_ending)) return with_ending;
        throw Error(ErrorCode::Conflict,
                    fmt::format("{}: the project has another scan {} with other content; rename the file, say another "
                                "--day, or delete that scan first",
                                path.string(), plain));
    }

    Project& project_;
    const AddScansOptions& options_;
    std::map<std::pair<std::string, std::int64_t>, std::string> by_content_;
    std::map<std::string, std::string> by_name_; // format of the scan of that name
    Plan plan_;
};

// Removes the stores made so far unless they are kept.
class MadeStores {
  public:
    MadeStores() = default;
    MadeStores(const MadeStores&) = delete;
    MadeStores& operator=(const MadeStores&) = delete;

    ~MadeStores() {
        std::error_code ignored;
        for (const fs::path& file : files_) fs::remove(file, ignored);
        if (!folder_.empty()) fs::remove(folder_, ignored); // only when it is empty
    }

    void make_folder(const fs::path& folder) {
        std::error_code error;
        const bool made = fs::create_directories(folder, error);
        if (error) throw Error(ErrorCode::Io, folder.string() + ": cannot be made: " + error.message());
        if (made) folder_ = folder;
    }

    void add(const fs::path& file) { files_.push_back(file); }

    void keep() {
        files_.clear();
        folder_.clear();
    }

  private:
    std::vector<fs::path> files_;
    fs::path folder_;
};

void make_stores(const Project& project, Plan& plan, MadeStores& made, Shares& shares, WholeProgress& progress) {
    made.make_folder(scans_folder(project.path()));
    double bytes = 0.0;
    for (const Plan::File& file : plan.files) bytes += Shares::size_of(file.path);
    for (Plan::File& file : plan.files) {
        for (AddedScan& added : file.clouds) {
            model::Scan& scan = added.scan;
            const double part = Shares::size_of(file.path) / static_cast<double>(file.clouds.size());
            progress.part(shares.read(part, bytes), 2); // reading, then sorting
            const fs::path store = store_path(project.path(), scan);
            const auto cloud = static_cast<std::size_t>(scan.cloud);
            const bool was_there = fs::exists(store);
            const scans::StoreSummary summary = scans::build_store(
                *file.reader, cloud, store,
                scans::store_info(file.reader->clouds()[cloud], scan.name, scan.sha256, cloud), {}, progress);
            if (!was_there) made.add(store);
            scan.points = static_cast<std::int64_t>(summary.points);
            if (summary.points == 0) added.notes.push_back("has no valid point");
            if (summary.too_far > 0) {
                added.notes.push_back(fmt::format("{} points over 131 km away were left out", summary.too_far));
            }
        }
        file.reader.reset();
    }
}

std::string label_of(const std::vector<AddedScan>& added, std::size_t moved) {
    if (added.empty()) return fmt::format("Find {} again", moved == 1 ? "a scan" : fmt::format("{} scans", moved));
    if (added.size() == 1) return "Add scan " + added.front().scan.name;
    return fmt::format("Add {} scans", added.size());
}

} // namespace

AddScansReport add_scans(Project& project, const std::vector<fs::path>& inputs, const AddScansOptions& options,
                         Progress& progress) {
    if (!options.day.empty()) require_day("--day", options.day);
    const auto meant = area_meant(project.record(), options.area);
    if (!meant) {
        throw Error(ErrorCode::NotFound, fmt::format("no area {}; planum area list shows them", options.area));
    }
    const model::AreaId area = *meant;
    const model::Surface* named = nullptr;
    if (!options.surface.empty()) {
        named = surface_named(project.record(), options.surface, area);
        if (named == nullptr) {
            throw Error(ErrorCode::NotFound,
                        fmt::format("no surface {}; planum surface list shows them", options.surface));
        }
    }

    AddScansReport report;
    FoundFiles found = find_files(inputs);
    report.left_aside = std::move(found.left_aside);
    Planner planner(project, options);
    WholeProgress whole(progress, name_of_work(found.files));
    Shares shares(found.files);
    for (const fs::path& file : found.files) {
        whole.part(shares.looked_into(Shares::size_of(file)), 2); // the hash, then the header
        planner.add(file, whole);
    }
    Plan plan = planner.take();
    report.there_already = std::move(plan.there_already);
    if (plan.files.empty() && plan.moved.empty()) return report;

    MadeStores made;
    if (!plan.files.empty()) make_stores(project, plan, made, shares, whole);
    for (Plan::File& file : plan.files) {
        std::move(file.clouds.begin(), file.clouds.end(), std::back_inserter(report.added));
    }
    const model::SurfaceId given = named != nullptr ? named->id : model::SurfaceId{};
    std::vector<model::Surface> surfaces = project.record().surfaces;
    report.change = project.change(label_of(report.added, plan.moved.size()), [&] {
        for (const model::Scan& scan : plan.moved) project.file().update(scan);
        for (AddedScan& added : report.added) {
            added.scan.surface = given.is_nil() ? surface_of_day(project, surfaces, area, added.scan.day) : given;
            added.scan.id = project.file().insert(added.scan);
        }
    });
    made.keep();
    return report;
}

} // namespace planum::app
