// SPDX-License-Identifier: MIT
// PCD: docs/formats/pcd.md says what is read and what is made of it.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "scans/formats/binary_value.hpp"
#include "scans/formats/block_builder.hpp"
#include "scans/formats/e57_pages.hpp"
#include "scans/formats/line_reader.hpp"
#include "scans/formats/lzf.hpp"
#include "scans/formats/parse_number.hpp"
#include "scans/formats/point_plan.hpp"
#include "scans/formats/readers.hpp"
#include "scans/formats/rigid_pose.hpp"

namespace planum::scans {

namespace {

constexpr std::size_t kMostFields = 1000;
constexpr std::uint64_t kMostHeaderLines = 1000;
constexpr std::uint64_t kMostValues = 8192; // in one point; the largest descriptors have some hundred
constexpr std::uint64_t kSampled = 8192;
constexpr std::uint64_t kBatchBytes = 1U << 20U;

[[noreturn]] void bad(const std::string& message) { throw Error(ErrorCode::BadInput, message); }

struct Field {
    std::string name;
    BinaryType type = BinaryType::Float32;
    std::uint64_t count = 1;
    std::uint64_t offset = 0; ///< in a record [bytes]
    std::uint64_t value = 0;  ///< index of its first value among a record's values
    Role role = Role::Other;
};

enum class Storage { Ascii, Binary, Compressed };

std::optional<BinaryType> type_of(char kind, std::uint64_t size) noexcept {
    if (kind == 'F' && size == 4) return BinaryType::Float32;
    if (kind == 'F' && size == 8) return BinaryType::Float64;
    if (kind != 'I' && kind != 'U') return std::nullopt;
    const bool is_signed = kind == 'I';
    switch (size) {
    case 1: return is_signed ? BinaryType::Int8 : BinaryType::UInt8;
    case 2: return is_signed ? BinaryType::Int16 : BinaryType::UInt16;
    case 4: return is_signed ? BinaryType::Int32 : BinaryType::UInt32;
    case 8: return is_signed ? BinaryType::Int64 : BinaryType::UInt64;
    default: return std::nullopt;
    }
}

std::vector<std::string> words_after_first(std::string_view line) {
    std::vector<std::string> words;
    for (const std::string_view word : text::split(line, ' ')) {
        if (!text::trim(word).empty()) words.emplace_back(text::trim(word));
    }
    if (!words.empty()) words.erase(words.begin());
    return words;
}

/// The lines of the header, before they are understood together.
struct RawHeader {
    std::vector<std::string> fields;
    std::vector<std::string> sizes;
    std::vector<std::string> types;
    std::vector<std::string> counts;
    std::vector<std::string> viewpoint;
    std::optional<std::uint64_t> width;
    std::optional<std::uint64_t> height;
    std::optional<std::uint64_t> points;
    std::string data;
};

class PcdReader final : public ScanReader {
  public:
    explicit PcdReader(std::unique_ptr<ByteSource> source) : source_(std::move(source)) {
        LineReader lines(*source_, 0, 1, 65536);
        const RawHeader raw = read_header(lines);
        points_at_ = lines.offset();
        points_line_ = lines.number() + 1;
        make_fields(raw);
        make_cloud(raw);
        check_size();
        sample();
    }

  protected:
    ReadSummary read_cloud(std::size_t cloud, const PointSink& sink, const ReadOptions& options,
                           Progress& progress) override;

  private:
    static RawHeader read_header(LineReader& lines);
    void make_fields(const RawHeader& raw);
    void make_cloud(const RawHeader& raw);
    void check_size();
    void sample();
    [[nodiscard]] std::string unpack() const;

    template<class Each>
    void for_points(std::uint64_t count, Each each) const;
    template<class Each>
    void for_ascii(std::uint64_t count, Each each) const;
    template<class Each>
    void for_binary(std::uint64_t count, Each each) const;
    template<class Each>
    void for_compressed(std::uint64_t count, Each each) const;

    [[nodiscard]] static double load(const Field& field, const char* at) noexcept {
        // Four bytes of colour, whatever number type they claim to be.
        if (field.role == Role::PackedRgb) return load_as<std::uint32_t>(at, std::endian::little);
        return load_value(at, field.type, std::endian::little);
    }

    std::unique_ptr<ByteSource> source_;
    Storage storage_ = Storage::Ascii;
    std::vector<Field> fields_;
    std::uint64_t record_bytes_ = 0;
    std::uint64_t record_values_ = 0;
    std::uint64_t points_at_ = 0; ///< [byte]
    std::uint64_t points_line_ = 0;
    PointPlan plan_;
};

std::uint64_t natural(const LineReader& lines, const std::vector<std::string>& words) {
    const std::optional<long long> value = words.empty() ? std::nullopt : text::parse_integer(words[0]);
    if (!value || *value < 0) lines.fail("a whole number, not negative, is expected");
    return static_cast<std::uint64_t>(*value);
}

RawHeader PcdReader::read_header(LineReader& lines) {
    RawHeader raw;
    while (raw.data.empty()) {
        if (lines.number() > kMostHeaderLines || !lines.next()) lines.fail("the header ends before its line DATA");
        const std::string_view line = text::trim(lines.line());
        if (line.empty() || line.front() == '#') continue;
        const std::string_view word = line.substr(0, line.find(' '));
        std::vector<std::string> rest = words_after_first(line);
        if (word == "FIELDS" || word == "COLUMNS")
            raw.fields = std::move(rest);
        else if (word == "SIZE")
            raw.sizes = std::move(rest);
        else if (word == "TYPE")
            raw.types = std::move(rest);
        else if (word == "COUNT")
            raw.counts = std::move(rest);
        else if (word == "VIEWPOINT")
            raw.viewpoint = std::move(rest);
        else if (word == "WIDTH")
            raw.width = natural(lines, rest);
        else if (word == "HEIGHT")
            raw.height = natural(lines, rest);
        else if (word == "POINTS")
            raw.points = natural(lines, rest);
        else if (word == "DATA" && !rest.empty())
            raw.data = rest[0];
        else if (word != "VERSION")
            lines.fail(fmt::format("'{}' is no line of a PCD header", text::clean_utf8(word.substr(0, 40)).text));
    }
    return raw;
}

void PcdReader::make_fields(const RawHeader& raw) {
    const std::size_t count = raw.fields.size();
    if (count == 0 || count > kMostFields)
        bad(fmt::format("PCD header: {} fields; from 1 to {} are possible", count, kMostFields));
    if (raw.sizes.size() != count || raw.types.size() != count || (!raw.counts.empty() && raw.counts.size() != count)) {
        bad("PCD header: SIZE, TYPE and COUNT must have as many words as FIELDS");
    }
    for (std::size_t i = 0; i < count; ++i) {
        const std::optional<long long> size = text::parse_integer(raw.sizes[i]);
        const std::optional<long long> values = raw.counts.empty() ? 1 : text::parse_integer(raw.counts[i]);
        const bool sane = size && *size > 0 && values && *values >= 0 && *values <= static_cast<long long>(kMostValues);
        const std::optional<BinaryType> type =
            sane ? type_of(raw.types[i][0], static_cast<std::uint64_t>(*size)) : std::nullopt;
        if (!type) bad(fmt::format("PCD header: field {} has an impossible size, type or count", i + 1));
        Field field{text::clean_utf8(raw.fields[i]).text,
                    *type,
                    static_cast<std::uint64_t>(*values),
                    record_bytes_,
                    record_values_,
                    *values == 1 ? role_of_name(raw.fields[i]) : Role::Other};
        if (field.role == Role::PackedRgb && size_of(*type) != 4) field.role = Role::Other;
        record_bytes_ += field.count * size_of(field.type);
        record_values_ += field.count;
        if (record_values_ > kMostValues) bad(fmt::format("PCD header: more than {} values in a point", kMostValues));
        fields_.push_back(std::move(field));
    }
}

void PcdReader::make_cloud(const RawHeader& raw) {
    CloudHeader cloud;
    std::vector<Role> roles(static_cast<std::size_t>(record_values_), Role::Other);
    for (const Field& field : fields_) {
        if (field.role != Role::Other) roles[static_cast<std::size_t>(field.value)] = field.role;
        cloud.attributes.push_back(field.name);
    }
    plan_ = plan_of(roles);
    if (!plan_.has_place()) bad("PCD header: no fields x, y and z");
    const std::uint64_t width = raw.width.value_or(raw.points.value_or(0));
    const std::uint64_t height = raw.height.value_or(1);
    if (width > 0xFFFFFFFFULL || height > 0xFFFFFFFFULL)
        bad(fmt::format("PCD header: {} x {} points are too many", width, height));
    cloud.records = raw.points.value_or(width * height);
    if (cloud.records != width * height) {
        bad(fmt::format("PCD header: POINTS {} is not WIDTH {} times HEIGHT {}", cloud.records, width, height));
    }
    plan_.at[static_cast<std::size_t>(Role::Row)] = -1; // the grid is WIDTH × HEIGHT
    cloud.has = plan_.columns();
    if (height > 1) {
        cloud.has.grid = true;
        cloud.rows = height;
        cloud.columns = width;
    }
    if (raw.data == "ascii")
        storage_ = Storage::Ascii;
    else if (raw.data == "binary")
        storage_ = Storage::Binary;
    else if (raw.data == "binary_compressed")
        storage_ = Storage::Compressed;
    else
        bad("PCD header: DATA is ascii, binary or binary_compressed");
    if (raw.viewpoint.size() == 7) {
        std::array<double, 7> v{};
        for (std::size_t i = 0; i < 7; ++i) {
            const std::optional<double> value = text::parse_double(raw.viewpoint[i]);
            if (!value) bad("PCD header: VIEWPOINT is seven numbers");
            v[i] = *value;
        }
        cloud.site_from_scan = pose_from_quaternion(v[3], v[4], v[5], v[6], {v[0], v[1], v[2]});
        cloud.has_pose = true;
    }
    info_.format = ScanFormat::Pcd;
    info_.variant = raw.data;
    clouds_.push_back(std::move(cloud));
}

void PcdReader::check_size() {
    const std::uint64_t records = clouds_.front().records;
    const std::uint64_t room = source_->size() - points_at_;
    const bool fits = storage_ == Storage::Ascii    ? records <= room / (2 * record_values_) + 1
                      : storage_ == Storage::Binary ? records <= room / record_bytes_
                                                    : records == 0 || room >= 8;
    if (!fits) bad(fmt::format("{} points do not fit into the {} bytes that follow the header", records, room));
}

void PcdReader::sample() {
    if (storage_ == Storage::Compressed && !plan_.has(Role::Intensity) && !plan_.has(Role::Red)) return;
    ValueSampler intensities;
    ValueSampler colours;
    for_points(std::min(clouds_.front().records, kSampled),
               [&](std::span<const double> v) { plan_.sample(v, intensities, colours); });
    plan_.intensity = intensities.intensity_coding();
    plan_.colour_scale = colours.colour_scale();
    clouds_.front().intensity = plan_.intensity;
}

template<class Each>
void PcdReader::for_ascii(std::uint64_t count, Each each) const {
    const auto width = static_cast<int>(record_values_);
    std::vector<double> values(static_cast<std::size_t>(record_values_));
    LineReader lines(*source_, points_at_, points_line_);
    for (std::uint64_t i = 0; i < count; ++i) {
        if (!lines.next()) lines.fail(fmt::format("the file ends after {} of {} points", i, clouds_.front().records));
        const int got = parse_row(lines.begin(), lines.end(), values.data(), width);
        if (got < 0) lines.fail(fmt::format("field {} is no number", -got));
        if (got != width) lines.fail(fmt::format("{} numbers expected, as FIELDS and COUNT say", width));
        for (const Field& field : fields_) {
            // A colour packed into a float is printed as that float.
            if (field.role != Role::PackedRgb || field.type != BinaryType::Float32) continue;
            double& value = values[static_cast<std::size_t>(field.value)];
            value = std::bit_cast<std::uint32_t>(static_cast<float>(value));
        }
        each(std::span<const double>(values));
    }
}

template<class Each>
void PcdReader::for_binary(std::uint64_t count, Each each) const {
    std::vector<double> values(static_cast<std::size_t>(record_values_));
    const std::uint64_t batch = std::max<std::uint64_t>(kBatchBytes / record_bytes_, 1);
    std::vector<char> bytes(static_cast<std::size_t>(std::min(batch, count) * record_bytes_));
    for (std::uint64_t first = 0; first < count; first += batch) {
        const std::uint64_t here = std::min(batch, count - first);
        source_->read(points_at_ + first * record_bytes_,
                      std::span(bytes).first(static_cast<std::size_t>(here * record_bytes_)));
        for (std::uint64_t i = 0; i < here; ++i) {
            for (const Field& field : fields_) {
                if (field.role == Role::Other) continue;
                values[static_cast<std::size_t>(field.value)] =
                    load(field, bytes.data() + i * record_bytes_ + field.offset);
            }
            each(std::span<const double>(values));
        }
    }
}

std::string PcdReader::unpack() const {
    const std::uint64_t room = source_->size() - points_at_;
    if (room < 8) bad("the file ends before the compressed points");
    const std::string head = source_->read_string(points_at_, 8);
    const std::uint64_t packed = little_endian<std::uint32_t>(head.data());
    const std::uint64_t size = little_endian<std::uint32_t>(head.data() + 4);
    const std::uint64_t records = clouds_.front().records;
    if (packed > room - 8)
        bad(fmt::format("{} compressed bytes are stated, {} follow: cut short or damaged", packed, room - 8));
    if (size / record_bytes_ != records || size % record_bytes_ != 0) {
        bad(fmt::format("compressed points of {} bytes, {} points of {} are expected", size, records, record_bytes_));
    }
    return unpack_lzf(source_->read_string(points_at_ + 8, packed), static_cast<std::size_t>(size));
}

// Unpacked, the fields stand one behind the other: all x, all y, …
template<class Each>
void PcdReader::for_compressed(std::uint64_t count, Each each) const {
    const std::uint64_t records = clouds_.front().records;
    if (records == 0) return;
    const std::string bytes = unpack();
    std::vector<double> values(static_cast<std::size_t>(record_values_));
    for (std::uint64_t i = 0; i < count; ++i) {
        for (const Field& field : fields_) {
            if (field.role == Role::Other) continue;
            const std::uint64_t at = field.offset * records + i * size_of(field.type);
            values[static_cast<std::size_t>(field.value)] = load(field, bytes.data() + at);
        }
        each(std::span<const double>(values));
    }
}

template<class Each>
void PcdReader::for_points(std::uint64_t count, Each each) const {
    switch (storage_) {
    case Storage::Ascii: for_ascii(count, each); break;
    case Storage::Binary: for_binary(count, each); break;
    case Storage::Compressed: for_compressed(count, each); break;
    }
}

ReadSummary PcdReader::read_cloud(std::size_t cloud, const PointSink& sink, const ReadOptions& options,
                                  Progress& progress) {
    const CloudHeader& header = clouds_[cloud];
    BlockBuilder builder(header, sink, options);
    Meter meter(progress, header.records);
    std::uint64_t done = 0;
    for_points(header.records, [&](std::span<const double> values) {
        if ((done & 0xFFFFU) == 0) meter.at(done);
        plan_.place(values, builder);
        if (header.has.grid) builder.set_grid(done / header.columns, done % header.columns);
        ++done;
        builder.commit();
    });
    return builder.finish();
}

} // namespace

std::unique_ptr<ScanReader> make_pcd_reader(std::unique_ptr<ByteSource> source) {
    return std::make_unique<PcdReader>(std::move(source));
}

} // namespace planum::scans
