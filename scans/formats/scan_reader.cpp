// SPDX-License-Identifier: MIT
#include "scans/formats/scan_reader.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/calendar.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "scans/formats/readers.hpp"

namespace planum::scans {

namespace {

constexpr std::uint64_t kLargestPoseFile = 65536;

std::optional<std::string> read_pose_beside(const std::filesystem::path& file) {
    std::filesystem::path pose = file;
    pose.replace_extension(".pose");
    std::error_code ignored;
    if (!std::filesystem::exists(pose, ignored)) return std::nullopt;
    return read_file(pose, kLargestPoseFile);
}

std::unique_ptr<ScanReader> open_scan_as(std::unique_ptr<ByteSource> source, ScanFormat format,
                                         const OpenOptions& options, Progress& progress,
                                         const std::optional<std::string>& companion) {
    switch (format) {
    case ScanFormat::Ptx: return make_ptx_reader(std::move(source), progress);
    case ScanFormat::E57: return make_e57_reader(std::move(source));
    case ScanFormat::Las: return make_las_reader(std::move(source));
    case ScanFormat::Ply: return make_ply_reader(std::move(source));
    case ScanFormat::Pcd: return make_pcd_reader(std::move(source));
    case ScanFormat::Pts: return make_pts_reader(std::move(source), progress);
    case ScanFormat::Xyz: return make_xyz_reader(std::move(source), options, progress);
    case ScanFormat::ThreeDtk: return make_3dtk_reader(std::move(source), companion, progress);
    }
    throw Error(ErrorCode::Internal, "no reader for this scan format");
}

} // namespace

ReadSummary ScanReader::read(std::size_t cloud, const PointSink& sink, const ReadOptions& options, Progress& progress) {
    if (cloud >= clouds_.size()) {
        throw Error(ErrorCode::Usage, fmt::format("no cloud #{}: the file has {}", cloud + 1, clouds_.size()));
    }
    try {
        return read_cloud(cloud, sink, options, progress);
    } catch (Error& e) {
        add_file(e);
        throw;
    }
}

// What the sink throws is about another file, and never BadInput.
void ScanReader::add_file(Error& error) const {
    if (error.code() == ErrorCode::BadInput && !file_.empty()) error.add_context(file_);
}

std::string ScanReader::read_image(std::size_t image) const {
    if (image >= info_.images.size()) {
        throw Error(ErrorCode::Usage, fmt::format("no image #{}: the file has {}", image + 1, info_.images.size()));
    }
    try {
        return read_image_bytes(image);
    } catch (Error& e) {
        add_file(e);
        throw;
    }
}

std::string ScanReader::read_image_bytes(std::size_t /*image*/) const {
    return {}; // never called: only formats that list images have them
}

std::string_view format_name(ScanFormat format) noexcept {
    switch (format) {
    case ScanFormat::Ptx: return "PTX";
    case ScanFormat::E57: return "E57";
    case ScanFormat::Las: return "LAS";
    case ScanFormat::Ply: return "PLY";
    case ScanFormat::Pcd: return "PCD";
    case ScanFormat::Pts: return "PTS";
    case ScanFormat::Xyz: return "XYZ";
    case ScanFormat::ThreeDtk: return "3DTK";
    }
    return "?";
}

std::optional<ScanFormat> guess_format(const ByteSource& source, std::string_view ending) {
    const std::string head = source.read_string(0, std::min<std::uint64_t>(source.size(), 64));
    if (head.starts_with("ASTM-E57")) return ScanFormat::E57;
    if (head.starts_with("LASF")) return ScanFormat::Las;
    if (head.starts_with("ply\n") || head.starts_with("ply\r\n")) return ScanFormat::Ply;
    if (head.starts_with("# .PCD") || head.starts_with("VERSION ")) return ScanFormat::Pcd;
    const std::string folded = text::fold_case(ending);
    if (folded == ".ptx") return ScanFormat::Ptx;
    if (folded == ".e57") return ScanFormat::E57;
    if (folded == ".las" || folded == ".laz") return ScanFormat::Las;
    if (folded == ".ply") return ScanFormat::Ply;
    if (folded == ".pcd") return ScanFormat::Pcd;
    if (folded == ".pts") return ScanFormat::Pts;
    if (folded == ".3d") return ScanFormat::ThreeDtk;
    if (folded == ".xyz" || folded == ".csv" || folded == ".txt" || folded == ".asc") return ScanFormat::Xyz;
    return std::nullopt;
}

std::unique_ptr<ScanReader> open_scan(std::unique_ptr<ByteSource> source, ScanFormat format, const OpenOptions& options,
                                      Progress& progress, std::optional<std::string> companion) {
    return open_scan_as(std::move(source), format, options, progress, companion);
}

std::unique_ptr<ScanReader> open_scan(const std::filesystem::path& file, const OpenOptions& options,
                                      Progress& progress) {
    std::unique_ptr<ByteSource> source = open_file_source(file);
    try {
        const std::optional<ScanFormat> format = guess_format(*source, file.extension().string());
        if (!format) {
            throw Error(ErrorCode::BadInput, "no scan format by its content or ending; known are .ptx .e57 .las .ply "
                                             ".pcd .pts .xyz .csv .txt .asc .3d");
        }
        const std::optional<std::string> companion =
            *format == ScanFormat::ThreeDtk ? read_pose_beside(file) : std::nullopt;
        auto reader = open_scan_as(std::move(source), *format, options, progress, companion);
        reader->name_in_errors(file);
        return reader;
    } catch (Error& e) {
        e.add_context(file.string());
        throw;
    }
}

std::optional<std::string> day_of_folder(const std::filesystem::path& file) {
    for (std::filesystem::path folder = file.parent_path(); folder.has_filename(); folder = folder.parent_path()) {
        const std::string name = folder.filename().string();
        const bool ends =
            name.size() == 10 || (name.size() > 10 && (name[10] == ' ' || name[10] == '_' || name[10] == '-'));
        if (ends && is_day(std::string_view(name).substr(0, 10))) return name.substr(0, 10);
    }
    return std::nullopt;
}

} // namespace planum::scans
