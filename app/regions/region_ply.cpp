// SPDX-License-Identifier: MIT
#include "app/regions/region_ply.hpp"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "app/regions/region_names.hpp"
#include "app/regions/region_points.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"

namespace planum::app {

namespace fs = std::filesystem;

namespace {

template<class T>
void append_bytes(std::string& out, T value) {
    static_assert(std::endian::native == std::endian::little, "PLY is written as little-endian");
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    out.append(bytes, sizeof(T));
}

std::string ply_header(std::int64_t points, bool colour) {
    std::string header =
        fmt::format("ply\nformat binary_little_endian 1.0\ncomment site grid, metres\nelement vertex {}\n"
                    "property double x\nproperty double y\nproperty double z\n"
                    "property ushort intensity\n",
                    points);
    if (colour) header += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    return header + "end_header\n";
}

// Written beside the target and renamed at the end: regions may hold more points than fit in memory.
class PlyFile {
  public:
    PlyFile(const fs::path& target, const std::string& header)
        : target_(target), partial_(target.string() + ".part"), bytes_(header) {
        refuse_to_replace_database(target_);
        errno = 0;
        out_.open(partial_, std::ios::binary);
        if (!out_) fail(errno);
    }

    ~PlyFile() {
        std::error_code ignored;
        if (!finished_) fs::remove(partial_, ignored);
    }

    PlyFile(const PlyFile&) = delete;
    PlyFile& operator=(const PlyFile&) = delete;

    void write(const RegionPoint& point, bool colour) {
        for (const double v : {point.x_in_site.x(), point.x_in_site.y(), point.x_in_site.z()}) append_bytes(bytes_, v);
        append_bytes(bytes_, point.intensity);
        if (colour) {
            for (const std::uint8_t v : {point.colour.red, point.colour.green, point.colour.blue}) {
                append_bytes(bytes_, v);
            }
        }
        if (bytes_.size() > kChunk) flush();
    }

    void finish() {
        flush();
        errno = 0;
        out_.close();
        if (!out_) fail(errno);
        std::error_code error;
        fs::rename(partial_, target_, error);
        if (error) fail(error.value());
        finished_ = true;
    }

  private:
    static constexpr std::size_t kChunk = 1U << 20U;

    void flush() {
        errno = 0;
        out_.write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
        const int problem = errno;
        bytes_.clear();
        if (!out_) fail(problem); // a full disk: do not go on through all points
    }

    [[noreturn]] void fail(int problem) const {
        throw Error(ErrorCode::Io, fmt::format("{}: cannot be written{}{}", target_.string(), problem == 0 ? "" : ": ",
                                               problem == 0 ? "" : std::strerror(problem)));
    }

    fs::path target_;
    fs::path partial_;
    std::ofstream out_;
    std::string bytes_;
    bool finished_ = false;
};

} // namespace

std::int64_t write_region_points(Project& project, const model::Region& region, const fs::path& ply,
                                 Progress& progress) {
    const model::Record& record = project.record();
    const auto scans = placed_scans(
        project, [&](const model::Scan& scan) { return may_show(record, scan, region); }, progress);
    const std::string name = region_name(record, project.index(), region);
    if (scans.empty()) {
        throw Error(ErrorCode::NotFound,
                    fmt::format("no registered scan of {} shows region {}; add scans of that day and register them",
                                region_day(record, region), name));
    }
    const std::vector<RegionGround> grounds = region_grounds(record);
    const auto at = std::find_if(record.regions.begin(), record.regions.end(),
                                 [&](const model::Region& other) { return other.id == region.id; });
    if (at == record.regions.end()) throw Error(ErrorCode::NotFound, "no region " + name);
    const RegionGround& ground = grounds[static_cast<std::size_t>(at - record.regions.begin())];
    std::int64_t points = 0;
    bool colour = false;
    for_points_on(ground, scans, [&](const RegionPoint& point) {
        ++points;
        colour = colour || point.has_colour;
    });
    if (points == 0) throw Error(ErrorCode::NotFound, fmt::format("region {} lies outside all scans of its day", name));
    PlyFile file(ply, ply_header(points, colour));
    for_points_on(ground, scans, [&](const RegionPoint& point) { file.write(point, colour); });
    file.finish();
    return points;
}

} // namespace planum::app
