// SPDX-License-Identifier: MIT
// LAS 1.2 to 1.4: docs/formats/las.md says what is read and what is made of it.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "scans/formats/block_builder.hpp"
#include "scans/formats/e57_pages.hpp"
#include "scans/formats/gps_time.hpp"
#include "scans/formats/readers.hpp"

namespace planum::scans {

namespace {

constexpr std::uint64_t kShortestHeader = 227; // LAS 1.2
constexpr std::uint64_t kHeader14 = 375;
constexpr std::size_t kSampledColours = 65536;
constexpr std::uint64_t kMostVariableRecords = 10000;
constexpr std::uint64_t kLargestWkt = 1U << 20U;

[[noreturn]] void bad(const std::string& message) { throw Error(ErrorCode::BadInput, message); }

double real_at(const char* bytes) noexcept { return std::bit_cast<double>(little_endian<std::uint64_t>(bytes)); }

/// Where the attributes of a point format stand (ASPRS LAS 1.4 R15, tables 7 to 17).
struct PointFormat {
    unsigned number = 0;
    std::size_t length = 0; ///< at least [bytes]
    std::size_t time = 0;   ///< 0: absent
    std::size_t colour = 0;
    std::size_t flags = 0; ///< of the byte with the withheld bit
    unsigned withheld = 0; ///< mask
};

constexpr std::array kPointFormats = {
    PointFormat{0, 20, 0, 0, 15, 0x80},   PointFormat{1, 28, 20, 0, 15, 0x80}, PointFormat{2, 26, 0, 20, 15, 0x80},
    PointFormat{3, 34, 20, 28, 15, 0x80}, PointFormat{6, 30, 22, 0, 15, 0x04}, PointFormat{7, 36, 22, 30, 15, 0x04},
    PointFormat{8, 38, 22, 30, 15, 0x04},
};

class LasReader final : public ScanReader {
  public:
    explicit LasReader(std::unique_ptr<ByteSource> source) : source_(std::move(source)) {
        if (source_->size() < kShortestHeader) bad(fmt::format("{} bytes are too few for a LAS file", source_->size()));
        const std::string head = source_->read_string(0, std::min(source_->size(), kHeader14));
        if (!head.starts_with("LASF")) bad("no LAS file: it does not start with LASF");
        read_header(head);
        read_variable_records(head);
        guess_colour_depth();
    }

  protected:
    ReadSummary read_cloud(std::size_t cloud, const PointSink& sink, const ReadOptions& options,
                           Progress& progress) override;

  private:
    void read_header(const std::string& head);
    void choose_format(unsigned number);
    void read_counts(const std::string& head, unsigned minor);
    void read_variable_records(const std::string& head);
    void guess_colour_depth();

    [[nodiscard]] double coordinate(const char* record, std::size_t axis) const noexcept {
        const auto raw = static_cast<std::int32_t>(little_endian<std::uint32_t>(record + 4 * axis));
        return static_cast<double>(raw) * scale_[axis] + offset_[axis];
    }

    std::unique_ptr<ByteSource> source_;
    PointFormat format_;
    std::uint64_t points_at_ = 0;
    std::size_t record_length_ = 0;
    std::array<double, 3> scale_{};
    std::array<double, 3> offset_{};
    unsigned colour_shift_ = 0; ///< 8 where the colours fill 16 bits
};

void LasReader::choose_format(unsigned number) {
    if ((number & 0xC0U) != 0) {
        bad(fmt::format("this is LAZ, compressed LAS (point format {}), which is not read here; unpack it first, for "
                        "example with `laszip -i FILE.laz -o FILE.las` or `pdal translate FILE.laz FILE.las`",
                        number & 0x3FU));
    }
    const auto* const found = std::find_if(kPointFormats.begin(), kPointFormats.end(),
                                           [&](const PointFormat& f) { return f.number == number; });
    if (found == kPointFormats.end()) {
        bad(fmt::format("point format {}; 0 to 3 and 6 to 8 are read, waveforms are not", number));
    }
    format_ = *found;
}

void LasReader::read_header(const std::string& head) {
    const auto major = static_cast<unsigned char>(head[24]);
    const auto minor = static_cast<unsigned char>(head[25]);
    if (major != 1 || minor > 4) bad(fmt::format("LAS version {}.{}, this program knows up to 1.4", major, minor));
    choose_format(static_cast<unsigned char>(head[104]));
    points_at_ = little_endian<std::uint32_t>(head.data() + 96);
    record_length_ = little_endian<std::uint16_t>(head.data() + 105);
    if (record_length_ < format_.length) {
        bad(fmt::format("records of {} bytes, point format {} needs {}", record_length_, format_.number,
                        format_.length));
    }
    for (std::size_t i = 0; i < 3; ++i) {
        scale_[i] = real_at(head.data() + 131 + 8 * i);
        offset_[i] = real_at(head.data() + 155 + 8 * i);
        if (!std::isfinite(scale_[i]) || scale_[i] == 0.0 || !std::isfinite(offset_[i])) {
            bad(fmt::format("scale {} or offset {} of axis {} is impossible", scale_[i], offset_[i], "xyz"[i]));
        }
    }
    info_.format = ScanFormat::Las;
    info_.variant = fmt::format("{}.{}, point format {}", major, minor, format_.number);
    info_.software = text::clean_utf8(text::trim(std::string_view(head.data() + 58, 32)
                                                     .substr(0, std::strlen(std::string(head.substr(58, 32)).c_str()))))
                         .text;
    info_.created_at = iso_date_of_year_day(little_endian<std::uint16_t>(head.data() + 92),
                                            little_endian<std::uint16_t>(head.data() + 90));
    read_counts(head, minor);
    CloudHeader& cloud = clouds_.front();
    Bounds stated;
    for (std::size_t i = 0; i < 3; ++i) {
        stated.maximum[i] = real_at(head.data() + 179 + 16 * i);
        stated.minimum[i] = real_at(head.data() + 187 + 16 * i);
    }
    cloud.stated_bounds = stated;
    const bool standard_time = (little_endian<std::uint16_t>(head.data() + 6) & 1U) != 0;
    cloud.time_zero = standard_time ? "GPS seconds minus 1e9" : "seconds of the GPS week";
}

void LasReader::read_counts(const std::string& head, unsigned minor) {
    CloudHeader cloud;
    cloud.records = little_endian<std::uint32_t>(head.data() + 107);
    if (minor == 4 && head.size() >= kHeader14 && little_endian<std::uint16_t>(head.data() + 94) >= kHeader14) {
        const auto large = little_endian<std::uint64_t>(head.data() + 247);
        if (large != 0) cloud.records = large;
    }
    if (points_at_ < kShortestHeader || points_at_ > source_->size()) {
        bad(fmt::format("points at byte {}, the file has {}", points_at_, source_->size()));
    }
    const std::uint64_t room = (source_->size() - points_at_) / record_length_;
    if (cloud.records > room) {
        bad(fmt::format("the file ends after record {} of {}: cut short or damaged", room, cloud.records));
    }
    cloud.has.intensity = true;
    cloud.has.time = format_.time != 0;
    cloud.has.colour = format_.colour != 0;
    cloud.intensity = {0.0, 1.0};
    cloud.attributes = {
        "X", "Y", "Z", "intensity", "return number", "classification", "scan angle", "user data", "point source id"};
    if (cloud.has.time) cloud.attributes.emplace_back("GPS time");
    if (cloud.has.colour) cloud.attributes.insert(cloud.attributes.end(), {"red", "green", "blue"});
    if (format_.number == 8) cloud.attributes.emplace_back("near infrared");
    if (record_length_ > format_.length)
        cloud.attributes.emplace_back(fmt::format("{} extra bytes", record_length_ - format_.length));
    clouds_.push_back(std::move(cloud));
}

// Only the coordinate system is wanted of them: WKT, or the EPSG code among the GeoTIFF keys.
void LasReader::read_variable_records(const std::string& head) {
    std::uint64_t at = little_endian<std::uint16_t>(head.data() + 94);
    const std::uint64_t count =
        std::min<std::uint64_t>(little_endian<std::uint32_t>(head.data() + 100), kMostVariableRecords);
    for (std::uint64_t i = 0; i < count && at + 54 <= points_at_; ++i) {
        const std::string record = source_->read_string(at, 54);
        const std::uint64_t length = little_endian<std::uint16_t>(record.data() + 20);
        if (at + 54 + length > points_at_) bad(fmt::format("variable record {} reaches into the points", i + 1));
        const auto id = little_endian<std::uint16_t>(record.data() + 18);
        if (record.compare(2, 15, "LASF_Projection") == 0 && (id == 2112 || id == 34735) && length < kLargestWkt) {
            const std::string body = source_->read_string(at + 54, length);
            if (id == 2112) info_.coordinate_system = text::clean_utf8(body.c_str()).text;
            for (std::size_t key = 8; id == 34735 && key + 8 <= body.size(); key += 8) {
                const auto name = little_endian<std::uint16_t>(body.data() + key);
                const auto code = little_endian<std::uint16_t>(body.data() + key + 6);
                // ProjectedCSTypeGeoKey; 32767 means "user-defined".
                if (name == 3072 && code != 0 && code != 32767 && info_.coordinate_system.empty()) {
                    info_.coordinate_system = fmt::format("EPSG:{}", code);
                }
            }
        }
        at += 54 + length;
    }
}

// The standard asks for 16 bits, but many programs write 0 … 255: points from all over the file decide.
void LasReader::guess_colour_depth() {
    const CloudHeader& cloud = clouds_.front();
    if (!cloud.has.colour || cloud.records == 0) return;
    const std::uint64_t step = std::max<std::uint64_t>(cloud.records / kSampledColours, 1);
    const std::uint64_t run = std::min<std::uint64_t>(cloud.records, 256);
    std::vector<char> bytes(static_cast<std::size_t>(run) * record_length_);
    for (std::uint64_t first = 0; first < cloud.records; first += run * step) {
        const std::uint64_t count = std::min(run, cloud.records - first);
        source_->read(points_at_ + first * record_length_,
                      std::span(bytes).first(static_cast<std::size_t>(count) * record_length_));
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                if (little_endian<std::uint16_t>(bytes.data() + i * record_length_ + format_.colour + 2 * k) > 255) {
                    colour_shift_ = 8;
                    return;
                }
            }
        }
    }
}

ReadSummary LasReader::read_cloud(std::size_t cloud, const PointSink& sink, const ReadOptions& options,
                                  Progress& progress) {
    const CloudHeader& header = clouds_[cloud];
    BlockBuilder builder(header, sink, options);
    Meter meter(progress, header.records);
    const std::uint64_t batch = std::max<std::uint64_t>((1U << 20U) / record_length_, 1);
    std::vector<char> bytes(static_cast<std::size_t>(std::min(batch, header.records)) * record_length_);
    for (std::uint64_t first = 0; first < header.records; first += batch) {
        meter.at(first);
        const std::uint64_t count = std::min(batch, header.records - first);
        source_->read(points_at_ + first * record_length_,
                      std::span(bytes).first(static_cast<std::size_t>(count) * record_length_));
        for (std::size_t i = 0; i < count; ++i) {
            const char* record = bytes.data() + i * record_length_;
            builder.set_place(coordinate(record, 0), coordinate(record, 1), coordinate(record, 2));
            builder.block.intensity[builder.slot()] = little_endian<std::uint16_t>(record + 12);
            if (header.has.colour) {
                const auto channel = [&](std::size_t k) {
                    return static_cast<double>(little_endian<std::uint16_t>(record + format_.colour + 2 * k) >>
                                               colour_shift_);
                };
                builder.set_colour(channel(0), channel(1), channel(2));
            }
            if (header.has.time) builder.block.time[builder.slot()] = real_at(record + format_.time);
            const bool withheld = (static_cast<unsigned char>(record[format_.flags]) & format_.withheld) != 0;
            if (withheld) {
                builder.miss(Validity::Invalid);
            } else {
                builder.commit();
            }
        }
    }
    return builder.finish();
}

} // namespace

std::unique_ptr<ScanReader> make_las_reader(std::unique_ptr<ByteSource> source) {
    return std::make_unique<LasReader>(std::move(source));
}

} // namespace planum::scans
