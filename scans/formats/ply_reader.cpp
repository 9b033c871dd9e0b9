// SPDX-License-Identifier: MIT
// PLY: docs/formats/ply.md says what is read and what is made of it.
#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "scans/formats/binary_value.hpp"
#include "scans/formats/block_builder.hpp"
#include "scans/formats/line_reader.hpp"
#include "scans/formats/parse_number.hpp"
#include "scans/formats/point_plan.hpp"
#include "scans/formats/readers.hpp"

namespace planum::scans {

namespace {

constexpr std::size_t kMostProperties = 1000;
constexpr std::uint64_t kMostHeaderLines = 10000;
constexpr std::uint64_t kSampled = 8192;
constexpr std::uint64_t kBatchBytes = 1U << 20U;

[[noreturn]] void bad(const std::string& message) { throw Error(ErrorCode::BadInput, message); }

struct Property {
    std::string name;
    BinaryType type = BinaryType::Float32;
    std::optional<BinaryType> list_count; ///< type of the length in front of a list
    std::size_t offset = 0;               ///< in the record [bytes]
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;

    [[nodiscard]] bool has_lists() const noexcept {
        return std::any_of(properties.begin(), properties.end(),
                           [](const Property& p) { return p.list_count.has_value(); });
    }

    [[nodiscard]] std::uint64_t record_bytes() const noexcept {
        std::uint64_t bytes = 0;
        for (const Property& p : properties) bytes += p.list_count ? 0 : size_of(p.type);
        return bytes;
    }
};

std::optional<BinaryType> type_of_name(std::string_view name) {
    if (name == "char" || name == "int8") return BinaryType::Int8;
    if (name == "uchar" || name == "uint8") return BinaryType::UInt8;
    if (name == "short" || name == "int16") return BinaryType::Int16;
    if (name == "ushort" || name == "uint16") return BinaryType::UInt16;
    if (name == "int" || name == "int32") return BinaryType::Int32;
    if (name == "uint" || name == "uint32") return BinaryType::UInt32;
    if (name == "float" || name == "float32") return BinaryType::Float32;
    if (name == "double" || name == "float64") return BinaryType::Float64;
    return std::nullopt;
}

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    for (const std::string_view word : text::split(line, ' ')) {
        if (!text::trim(word).empty()) words.push_back(text::trim(word));
    }
    return words;
}

class PlyReader final : public ScanReader {
  public:
    explicit PlyReader(std::unique_ptr<ByteSource> source) : source_(std::move(source)) {
        LineReader lines(*source_, 0, 1, 65536);
        if (!lines.next() || lines.line() != "ply") bad("line 1: no PLY file: it does not start with ply");
        read_header(lines);
        find_vertices(lines.offset(), lines.number() + 1);
        make_cloud();
    }

  protected:
    ReadSummary read_cloud(std::size_t cloud, const PointSink& sink, const ReadOptions& options,
                           Progress& progress) override;

  private:
    void read_header(LineReader& lines);
    void header_line(LineReader& lines, const std::vector<std::string_view>& words);
    void add_property(LineReader& lines, const std::vector<std::string_view>& words);
    void find_vertices(std::uint64_t offset, std::uint64_t line);
    void pass_over(const Element& element);
    void make_cloud();
    void sample();

    /// Calls `each(values)` for the first `count` vertices.
    template<class Each>
    void for_vertices(std::uint64_t count, Each each) const;

    std::unique_ptr<ByteSource> source_;
    bool ascii_ = false;
    std::endian order_ = std::endian::little;
    std::vector<Element> elements_;
    Element vertices_;
    std::uint64_t vertices_at_ = 0; ///< [byte]
    std::uint64_t vertices_line_ = 0;
    PointPlan plan_;
};

void PlyReader::read_header(LineReader& lines) {
    bool format_seen = false;
    while (true) {
        if (lines.number() > kMostHeaderLines || !lines.next()) lines.fail("the header has no end_header");
        const std::vector<std::string_view> words = words_of(lines.line());
        if (words.empty()) continue;
        if (words[0] == "end_header") break;
        if (words[0] == "format") {
            format_seen = true;
            const std::string_view kind = words.size() > 1 ? words[1] : std::string_view{};
            if (kind != "ascii" && kind != "binary_little_endian" && kind != "binary_big_endian") {
                lines.fail(
                    fmt::format("format '{}'; ascii, binary_little_endian and binary_big_endian are known", kind));
            }
            ascii_ = kind == "ascii";
            order_ = kind == "binary_big_endian" ? std::endian::big : std::endian::little;
            info_.variant = std::string(kind);
            continue;
        }
        header_line(lines, words);
    }
    if (!format_seen) lines.fail("the header does not state its format");
}

void PlyReader::header_line(LineReader& lines, const std::vector<std::string_view>& words) {
    if (words[0] == "comment" || words[0] == "obj_info") {
        if (words.size() > 2 && words[1] == "Created" && info_.software.empty()) {
            info_.software = text::clean_utf8(lines.line().substr(8)).text;
        }
        return;
    }
    if (words[0] == "property") {
        add_property(lines, words);
        return;
    }
    const long long count = words.size() == 3 ? text::parse_integer(words[2]).value_or(-1) : -1;
    if (words[0] != "element" || count < 0) lines.fail("neither element, property, comment nor end_header");
    elements_.push_back({text::clean_utf8(words[1]).text, static_cast<std::uint64_t>(count), {}});
}

void PlyReader::add_property(LineReader& lines, const std::vector<std::string_view>& words) {
    if (elements_.empty()) lines.fail("a property before any element");
    Element& element = elements_.back();
    if (element.properties.size() == kMostProperties)
        lines.fail(fmt::format("more than {} properties", kMostProperties));
    const bool list = words.size() == 5 && words[1] == "list";
    if (!list && words.size() != 3) lines.fail("a property is: property TYPE NAME, or: property list TYPE TYPE NAME");
    const std::optional<BinaryType> type = type_of_name(list ? words[3] : words[1]);
    const std::optional<BinaryType> count = list ? type_of_name(words[2]) : std::nullopt;
    if (!type || (list && !count)) lines.fail("a type that PLY does not know");
    Property property{text::clean_utf8(words.back()).text, *type, count,
                      static_cast<std::size_t>(element.record_bytes())};
    element.properties.push_back(std::move(property));
}

void PlyReader::find_vertices(std::uint64_t offset, std::uint64_t line) {
    vertices_at_ = offset;
    vertices_line_ = line;
    for (const Element& element : elements_) {
        if (element.name != "vertex") {
            pass_over(element);
            continue;
        }
        vertices_ = element;
        const std::uint64_t room = source_->size() - vertices_at_;
        const std::uint64_t least = ascii_ ? 2 * element.properties.size() : element.record_bytes();
        if (element.has_lists()) bad("element vertex has a list, which is no table of points");
        if (least == 0) bad("element vertex has no properties");
        if (element.count > room / least + (ascii_ ? 1 : 0)) {
            bad(fmt::format("{} vertices do not fit into the {} bytes that follow the header", element.count, room));
        }
        return;
    }
    bad("no element vertex, so no points");
}

// Goes behind an element that stands in front of the vertices.
void PlyReader::pass_over(const Element& element) {
    const std::uint64_t room = source_->size() - vertices_at_;
    if (ascii_) {
        LineReader lines(*source_, vertices_at_, vertices_line_);
        if (lines.skip(element.count) < element.count)
            lines.fail(fmt::format("the file ends within element {}", element.name));
        vertices_at_ = lines.offset();
        vertices_line_ += element.count;
        return;
    }
    if (element.has_lists())
        bad(fmt::format("element {} with lists stands before the vertices; save the vertices first", element.name));
    const std::uint64_t bytes = element.record_bytes();
    if (bytes > 0 && element.count > room / bytes) bad(fmt::format("the file ends within element {}", element.name));
    vertices_at_ += element.count * bytes;
}

void PlyReader::make_cloud() {
    std::vector<Role> roles;
    CloudHeader cloud;
    for (const Property& property : vertices_.properties) {
        Role role = role_of_name(property.name);
        if (role == Role::PackedRgb) role = Role::Other; // a habit of PCD, not of PLY
        roles.push_back(role);
        cloud.attributes.push_back(property.name);
    }
    plan_ = plan_of(roles);
    if (!plan_.has_place()) bad("element vertex lacks x, y or z");
    // Rows and columns without their extent are no grid one could rely on.
    plan_.at[static_cast<std::size_t>(Role::Row)] = -1;
    cloud.records = vertices_.count;
    cloud.has = plan_.columns();
    clouds_.push_back(std::move(cloud));
    info_.format = ScanFormat::Ply;
    sample();
}

void PlyReader::sample() {
    ValueSampler intensities;
    ValueSampler colours;
    for_vertices(std::min(vertices_.count, kSampled),
                 [&](std::span<const double> v) { plan_.sample(v, intensities, colours); });
    const auto type_at = [&](Role role) {
        return vertices_.properties[static_cast<std::size_t>(plan_.index(role))].type;
    };
    plan_.intensity = intensities.intensity_coding();
    if (plan_.has(Role::Intensity)) {
        const BinaryType type = type_at(Role::Intensity);
        if (type == BinaryType::UInt8 || type == BinaryType::UInt16) plan_.intensity = {0.0, 1.0};
    }
    if (plan_.has_colour()) {
        const BinaryType type = type_at(Role::Red);
        plan_.colour_scale = type == BinaryType::UInt8    ? 1.0
                             : type == BinaryType::UInt16 ? 1.0 / 257.0
                                                          : colours.colour_scale();
    }
    clouds_.front().intensity = plan_.intensity;
}

template<class Each>
void PlyReader::for_vertices(std::uint64_t count, Each each) const {
    const std::size_t width = vertices_.properties.size();
    std::vector<double> values(width);
    if (ascii_) {
        LineReader lines(*source_, vertices_at_, vertices_line_);
        for (std::uint64_t i = 0; i < count; ++i) {
            if (!lines.next()) lines.fail(fmt::format("the file ends after {} of {} vertices", i, vertices_.count));
            const int got = parse_row(lines.begin(), lines.end(), values.data(), static_cast<int>(width));
            if (got < 0) lines.fail(fmt::format("field {} is no number", -got));
            if (got != static_cast<int>(width))
                lines.fail(fmt::format("{} numbers expected, one for each property", width));
            each(std::span<const double>(values));
        }
        return;
    }
    const auto record = static_cast<std::size_t>(vertices_.record_bytes());
    const std::uint64_t batch = std::max<std::uint64_t>(kBatchBytes / record, 1);
    std::vector<char> bytes(static_cast<std::size_t>(std::min(batch, count)) * record);
    for (std::uint64_t first = 0; first < count; first += batch) {
        const auto here = static_cast<std::size_t>(std::min(batch, count - first));
        source_->read(vertices_at_ + first * record, std::span(bytes).first(here * record));
        for (std::size_t i = 0; i < here; ++i) {
            const char* at = bytes.data() + i * record;
            for (std::size_t k = 0; k < width; ++k) {
                values[k] = load_value(at + vertices_.properties[k].offset, vertices_.properties[k].type, order_);
            }
            each(std::span<const double>(values));
        }
    }
}

ReadSummary PlyReader::read_cloud(std::size_t cloud, const PointSink& sink, const ReadOptions& options,
                                  Progress& progress) {
    BlockBuilder builder(clouds_[cloud], sink, options);
    Meter meter(progress, vertices_.count);
    std::uint64_t done = 0;
    for_vertices(vertices_.count, [&](std::span<const double> values) {
        if ((done++ & 0xFFFFU) == 0) meter.at(done);
        plan_.place(values, builder);
        builder.commit();
    });
    return builder.finish();
}

} // namespace

std::unique_ptr<ScanReader> make_ply_reader(std::unique_ptr<ByteSource> source) {
    return std::make_unique<PlyReader>(std::move(source));
}

} // namespace planum::scans
