// SPDX-License-Identifier: MIT
// PTX: docs/formats/ptx.md says what is read and what is made of it.
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "scans/formats/block_builder.hpp"
#include "scans/formats/line_reader.hpp"
#include "scans/formats/parse_number.hpp"
#include "scans/formats/point_plan.hpp"
#include "scans/formats/readers.hpp"
#include "scans/formats/rigid_pose.hpp"

namespace planum::scans {

namespace {

constexpr std::uint64_t kShortestPoint = 6;   // "0 0 0\n"
constexpr std::uint64_t kSampledLines = 8192; // to tell which range the intensities have
constexpr std::uint64_t kMostClouds = 10000;
constexpr std::uint64_t kSampleWindow = 65536;

struct PtxCloud {
    std::uint64_t offset = 0; ///< of the first point [byte]
    std::uint64_t first_line = 0;
    int fields = 0; ///< 3: xyz, 4: + intensity, 6: xyz + colour, 7: both
    std::optional<Eigen::Matrix3d> scan_from_file;
};

class PtxReader final : public ScanReader {
  public:
    PtxReader(std::unique_ptr<ByteSource> source, Progress& progress) : source_(std::move(source)) {
        info_.format = ScanFormat::Ptx;
        LineReader lines(*source_);
        Meter meter(progress, source_->size());
        while (next_filled(lines)) {
            if (parts_.size() == kMostClouds) lines.fail(fmt::format("more than {} clouds", kMostClouds));
            read_header(lines);
            sample(parts_.back(), clouds_.back());
            skip_points(lines, clouds_.back().records, meter);
        }
        if (parts_.empty())
            throw Error(ErrorCode::BadInput, "line 1: empty, a PTX file starts with its number of columns");
    }

  protected:
    ReadSummary read_cloud(std::size_t cloud, const PointSink& sink, const ReadOptions& options,
                           Progress& progress) override;

  private:
    static bool next_filled(LineReader& lines) {
        while (lines.next()) {
            if (!text::trim(lines.line()).empty()) return true;
        }
        return false;
    }

    void read_header(LineReader& lines);
    void sample(PtxCloud& part, CloudHeader& header) const;

    static void skip_points(LineReader& lines, std::uint64_t points, Meter& meter) {
        std::uint64_t done = 0;
        while (done < points) {
            const std::uint64_t step = std::min<std::uint64_t>(points - done, 65536);
            const std::uint64_t skipped = lines.skip(step);
            done += skipped;
            meter.at(lines.offset());
            if (skipped < step) {
                lines.fail(fmt::format("the file ends after {} of {} points of this cloud", done, points));
            }
        }
    }

    std::unique_ptr<ByteSource> source_;
    std::vector<PtxCloud> parts_;
};

std::uint64_t read_count(const LineReader& lines, std::string_view what) {
    const std::optional<long long> count = text::parse_integer(lines.line());
    if (!count || *count < 1 || *count > 0xFFFFFFFFLL) {
        lines.fail(fmt::format("no number of {}; a PTX cloud starts with columns and rows, each at least 1", what));
    }
    return static_cast<std::uint64_t>(*count);
}

void read_numbers(LineReader& lines, std::span<double> out, std::string_view what) {
    if (!lines.next()) lines.fail(fmt::format("the file ends before the {}", what));
    const int got = parse_row(lines.begin(), lines.end(), out.data(), static_cast<int>(out.size()));
    if (got != static_cast<int>(out.size())) lines.fail(fmt::format("{} numbers expected, the {}", out.size(), what));
}

void PtxReader::read_header(LineReader& lines) {
    CloudHeader header;
    PtxCloud part;
    header.columns = read_count(lines, "columns");
    if (!lines.next()) lines.fail("the file ends before the number of rows");
    header.rows = read_count(lines, "rows");
    header.records = header.rows * header.columns;
    const std::uint64_t header_line = lines.number();
    std::array<double, 3> three{};
    read_numbers(lines, three, "scanner's position");
    for (int i = 0; i < 3; ++i) read_numbers(lines, three, "scanner's axes");
    // Row vectors from the left: x_site = x_file * M. Ours stand on the right, so M is transposed.
    Eigen::Matrix4d site_from_file;
    for (int i = 0; i < 4; ++i) {
        std::array<double, 4> four{};
        read_numbers(lines, four, "lines of the 4x4 matrix");
        for (int k = 0; k < 4; ++k) site_from_file(k, i) = four[static_cast<std::size_t>(k)];
    }
    try {
        const SplitPose split = split_pose(site_from_file);
        header.site_from_scan = split.site_from_scan;
        part.scan_from_file = split.scan_from_file;
    } catch (Error& e) {
        e.add_context(fmt::format("line {}", lines.number()));
        throw;
    }
    header.has_pose = true;
    if (part.scan_from_file)
        header.notes.emplace_back("the header's matrix stretches space; the points were stretched, the pose is rigid");
    part.offset = lines.offset();
    part.first_line = lines.number() + 1;
    if (header.records > (source_->size() - part.offset) / kShortestPoint + 1) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("line {}: {} x {} points do not fit into the {} bytes that follow", header_line,
                                header.columns, header.rows, source_->size() - part.offset));
    }
    parts_.push_back(part);
    clouds_.push_back(std::move(header));
}

// The first point's line says which columns there are, the first thousands which range they have.
void PtxReader::sample(PtxCloud& part, CloudHeader& header) const {
    LineReader lines(*source_, part.offset, part.first_line, kSampleWindow);
    ValueSampler intensities;
    std::array<double, 7> row{};
    const std::uint64_t count = std::min(header.records, kSampledLines);
    for (std::uint64_t i = 0; i < count; ++i) {
        if (!lines.next())
            lines.fail(fmt::format("the file ends after {} of {} points of this cloud", i, header.records));
        const int fields = parse_row(lines.begin(), lines.end(), row.data(), 7);
        if (i == 0) part.fields = fields;
        if (fields >= 4 && part.fields != 6) intensities.add(row[3]);
    }
    if (part.fields != 3 && part.fields != 4 && part.fields != 6 && part.fields != 7) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("line {}: no point; 3, 4, 6 or 7 numbers expected: x y z, intensity, red green blue",
                                part.first_line));
    }
    header.has.grid = true;
    header.has.intensity = part.fields == 4 || part.fields == 7;
    header.has.colour = part.fields >= 6;
    header.intensity = intensities.intensity_coding();
    header.attributes = {"x", "y", "z"};
    if (header.has.intensity) header.attributes.emplace_back("intensity");
    if (header.has.colour) header.attributes.insert(header.attributes.end(), {"red", "green", "blue"});
}

[[noreturn]] void bad_point(const LineReader& lines, int got, int wanted) {
    if (got < 0) lines.fail(fmt::format("field {} is no number", -got));
    if (got > wanted) lines.fail(fmt::format("more numbers than the {} of the cloud's first point", wanted));
    lines.fail(fmt::format("{} numbers expected as in the cloud's first point, this line has {}", wanted, got));
}

ReadSummary PtxReader::read_cloud(std::size_t cloud, const PointSink& sink, const ReadOptions& options,
                                  Progress& progress) {
    const PtxCloud& part = parts_[cloud];
    const CloudHeader& header = clouds_[cloud];
    LineReader lines(*source_, part.offset, part.first_line);
    BlockBuilder builder(header, sink, options);
    Meter meter(progress, header.records);
    const std::size_t colour_at = part.fields == 7 ? 4 : 3;
    std::array<double, 7> v{};
    for (std::uint64_t column = 0, i = 0; column < header.columns; ++column) {
        for (std::uint64_t row = 0; row < header.rows; ++row, ++i) {
            if ((i & 0xFFFFU) == 0) meter.at(i);
            if (!lines.next())
                lines.fail(fmt::format("the file ends after {} of {} points of this cloud", i, header.records));
            const int got = parse_row(lines.begin(), lines.end(), v.data(), part.fields);
            const bool nothing = v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0;
            // Some programs write a missing return without its colour.
            if (got != part.fields && !(nothing && got >= 3 && got < part.fields)) bad_point(lines, got, part.fields);
            if (nothing && !builder.keeps_misses()) {
                builder.miss(Validity::Invalid);
                continue;
            }
            if (got < part.fields) v[3] = v[4] = v[5] = v[6] = 0.0;
            builder.set_place(v[0], v[1], v[2]);
            if (part.scan_from_file) {
                const Eigen::Vector3d p = *part.scan_from_file * Eigen::Vector3d(v[0], v[1], v[2]);
                builder.set_place(p.x(), p.y(), p.z());
            }
            builder.set_grid(row, column);
            if (header.has.intensity) builder.set_intensity(v[3], header.intensity);
            if (header.has.colour) builder.set_colour(v[colour_at], v[colour_at + 1], v[colour_at + 2]);
            if (nothing) {
                builder.miss(Validity::Invalid);
            } else {
                builder.commit();
            }
        }
    }
    return builder.finish();
}

} // namespace

std::unique_ptr<ScanReader> make_ptx_reader(std::unique_ptr<ByteSource> source, Progress& progress) {
    return std::make_unique<PtxReader>(std::move(source), progress);
}

} // namespace planum::scans
