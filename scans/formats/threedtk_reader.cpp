// SPDX-License-Identifier: MIT
// 3DTK .3d and .pose: docs/formats/3dtk.md has the formulas.
#include <array>
#include <numbers>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "scans/formats/block_builder.hpp"
#include "scans/formats/readers.hpp"
#include "scans/formats/text_table.hpp"

namespace planum::scans {

namespace {

constexpr double kMetresPerCentimetre = 0.01;

// Theirs: left-handed, x right, y up, z forward. Ours: right-handed, x forward, y left, z up.
Eigen::Matrix3d ours_from_theirs() {
    Eigen::Matrix3d axes;
    axes << 0, 0, 1, //
        -1, 0, 0,    //
        0, 1, 0;
    return axes;
}

Eigen::Isometry3d parse_pose(const std::string& pose_text) {
    std::array<double, 6> v{};
    std::size_t count = 0;
    std::string flat = pose_text;
    for (char& c : flat) {
        if (c == '\n' || c == '\r' || c == '\t') c = ' ';
    }
    for (const std::string_view word : split_line(flat, ' ')) {
        const std::optional<double> value = text::parse_double(word);
        if (!value || count == v.size())
            throw Error(ErrorCode::BadInput,
                        ".pose file: six numbers are expected, position in cm and angles in degrees");
        v[count++] = *value;
    }
    if (count != v.size())
        throw Error(ErrorCode::BadInput,
                    fmt::format(".pose file: {} numbers instead of six, position in cm and angles in degrees", count));
    const auto turn = [&](std::size_t i, const Eigen::Vector3d& axis) {
        return Eigen::AngleAxisd(v[3 + i] * std::numbers::pi / 180.0, axis).toRotationMatrix();
    };
    const Eigen::Matrix3d theirs =
        turn(0, Eigen::Vector3d::UnitX()) * turn(1, Eigen::Vector3d::UnitY()) * turn(2, Eigen::Vector3d::UnitZ());
    const Eigen::Matrix3d axes = ours_from_theirs();
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = axes * theirs * axes.transpose();
    pose.translation() = axes * Eigen::Vector3d(v[0], v[1], v[2]) * kMetresPerCentimetre;
    if (!pose.matrix().allFinite()) throw Error(ErrorCode::BadInput, ".pose file: numbers that are not finite");
    return pose;
}

class ThreeDtkReader final : public ScanReader {
  public:
    ThreeDtkReader(std::unique_ptr<ByteSource> source, const std::optional<std::string>& pose, Progress& progress)
        : source_(std::move(source)) {
        info_.format = ScanFormat::ThreeDtk;
        table_.scan_from_file = ours_from_theirs() * kMetresPerCentimetre;
        table_.turned = true;
        CloudHeader header;
        find_table();
        count(header, progress);
        plan_table(*source_, table_, header);
        info_.column_guess = roles_as_text(table_.roles) + " (by their number)";
        if (pose) {
            header.site_from_scan = parse_pose(*pose);
            header.has_pose = true;
        } else {
            header.notes.emplace_back("no .pose file beside it");
        }
        clouds_.push_back(std::move(header));
    }

  protected:
    ReadSummary read_cloud(std::size_t cloud, const PointSink& sink, const ReadOptions& options,
                           Progress& progress) override {
        return read_table(*source_, table_, clouds_[cloud], sink, options, progress);
    }

  private:
    // The first line may hold the size of the grid or a remark.
    void find_table() {
        LineReader lines(*source_, 0, 1, 65536);
        while (true) {
            const std::uint64_t offset = lines.offset();
            if (!lines.next() || lines.number() > 10)
                throw Error(ErrorCode::BadInput, fmt::format("line {}: no line of points x y z",
                                                             std::max<std::uint64_t>(lines.number(), 1)));
            const std::vector<std::string_view> fields = split_line(lines.line(), ' ');
            if (!is_data_line(lines.line()) || fields.size() < 3) continue;
            table_.offset = offset;
            table_.first_line = lines.number();
            table_.roles = guess_roles(*source_, table_, fields.size());
            return;
        }
    }

    void count(CloudHeader& header, Progress& progress) {
        LineReader lines(*source_, table_.offset, table_.first_line);
        Meter meter(progress, source_->size());
        while (lines.next()) {
            if ((lines.number() & 0xFFFFU) == 0) meter.at(lines.offset());
            if (is_data_line(lines.line())) ++header.records;
        }
    }

    std::unique_ptr<ByteSource> source_;
    TextTable table_;
};

} // namespace

std::unique_ptr<ScanReader> make_3dtk_reader(std::unique_ptr<ByteSource> source, const std::optional<std::string>& pose,
                                             Progress& progress) {
    return std::make_unique<ThreeDtkReader>(std::move(source), pose, progress);
}

} // namespace planum::scans
