// SPDX-License-Identifier: MIT
#include <filesystem>
#include <ranges>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "app/demo/dig_files.hpp"
#include "app/demo/simulator.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"

namespace planum::app::demo {

namespace {

namespace fs = std::filesystem;

// Everything a writer made, so that nothing half-written is left when it fails.
class FolderWriter {
  public:
    explicit FolderWriter(fs::path folder) : folder_(std::move(folder)) {
        std::error_code failure;
        if (fs::exists(folder_, failure) && !fs::is_empty(folder_, failure)) {
            throw Error(ErrorCode::Conflict, folder_.string() +
                                                 " is not empty; name a new folder for the sample dig, or "
                                                 "remove this one if a stopped run left it");
        }
        make(folder_);
    }

    FolderWriter(const FolderWriter&) = delete;
    FolderWriter& operator=(const FolderWriter&) = delete;

    ~FolderWriter() {
        if (kept_) return;
        std::error_code ignored; // on the way out of another failure
        for (const fs::path& file : written_) fs::remove(folder_ / file, ignored);
        for (const fs::path& folder : made_ | std::views::reverse) fs::remove(folder, ignored);
    }

    void write(const fs::path& name, const std::string& bytes) {
        if (!name.parent_path().empty() && !fs::exists(folder_ / name.parent_path()))
            make(folder_ / name.parent_path());
        write_file_atomically(folder_ / name, bytes);
        written_.push_back(name);
    }

    std::vector<fs::path> keep() {
        kept_ = true;
        return std::move(written_);
    }

  private:
    void make(const fs::path& folder) {
        std::error_code failure;
        if (fs::exists(folder)) return;
        fs::create_directories(folder, failure);
        if (failure) throw Error(ErrorCode::Io, "making the folder " + folder.string() + ": " + failure.message());
        made_.push_back(folder);
    }

    fs::path folder_;
    std::vector<fs::path> made_;
    std::vector<fs::path> written_;
    bool kept_ = false;
};

void append_marker(std::string& table, const std::string& scan, const std::string& marker, const Vec3& x) {
    table += fmt::format("{},{},{:.4f},{:.4f},{:.4f}\n", scan, marker, x.x, x.y, x.z);
}

} // namespace

WrittenDemo write_demo(const DemoDig& dig, const std::filesystem::path& folder, Progress& progress) {
    FolderWriter writer(folder);
    WrittenDemo result;
    std::vector<ScanTruth> truths;
    std::string markers = "scan,marker,x,y,z\n";
    for (const Marker& marker : make_scene(dig.site, dig.options.seed, 0.0).markers)
        append_marker(markers, "site", marker.name, marker.x_in_site);
    for (SurfaceNo s = 0; s < dig.plan.surfaces; ++s) {
        for (const SimulatedScan& scan : scan_surface(dig, s, progress)) {
            progress.check();
            writer.write(scan.station.name + ".ptx", ptx_text(scan.image));
            result.points += scan.image.count;
            truths.push_back(
                {scan.station, scan.image.count, scan.image.mixed, scan.image.people, scan.markers.size()});
            for (const MeasuredMarker& marker : scan.markers)
                append_marker(markers, scan.station.name, marker.name, marker.x_in_scan);
        }
        writer.write("outlines/" + dig.plan.days[static_cast<std::size_t>(s)] + ".geojson", outlines_geojson(dig, s));
    }
    writer.write("markers.csv", markers);
    for (const auto& [name, table] : record_tables(dig.record, dig.plan)) writer.write("record/" + name, table);
    for (const auto& [name, table] : record_tables(dig.mistaken, dig.plan))
        writer.write("with-mistakes/" + name, table);
    writer.write("truth.json", truth_json(dig, truths));
    result.files = writer.keep();
    return result;
}

} // namespace planum::app::demo
