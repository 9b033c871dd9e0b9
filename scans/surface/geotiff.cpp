// SPDX-License-Identifier: MIT
#include "scans/surface/geotiff.hpp"

#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.hpp"

namespace planum::scans {

namespace {

static_assert(std::endian::native == std::endian::little, "rasters are written as they lie in memory");

constexpr float kNothing = -9999.0F;
constexpr std::uint16_t kShort = 3;
constexpr std::uint16_t kLong = 4;
constexpr std::uint16_t kAscii = 2;
constexpr std::uint16_t kDouble = 12;

template<class Value>
void put(std::string& out, Value value) {
    char bytes[sizeof(Value)];
    std::memcpy(bytes, &value, sizeof(Value));
    out.append(bytes, sizeof(Value));
}

template<class Value>
std::string bytes_of(const std::vector<Value>& values) {
    std::string bytes;
    for (const Value value : values) put(bytes, value);
    return bytes;
}

/// A directory of tags in ascending order; values over four bytes follow it.
class Directory {
  public:
    void add(std::uint16_t tag, std::uint16_t type, std::size_t count, std::string bytes) {
        entries_.push_back({tag, type, static_cast<std::uint32_t>(count), std::move(bytes)});
    }

    void add_number(std::uint16_t tag, std::uint32_t value) { add(tag, kLong, 1, bytes_of(std::vector{value})); }

    void add_short(std::uint16_t tag, std::uint16_t value) { add(tag, kShort, 1, bytes_of(std::vector{value})); }

    [[nodiscard]] std::size_t size() const {
        std::size_t size = 2 + entries_.size() * 12 + 4;
        for (const Entry& entry : entries_) size += entry.bytes.size() > 4 ? padded(entry.bytes.size()) : 0;
        return size;
    }

    /// As it lies at byte `at` of the file.
    [[nodiscard]] std::string write(std::size_t at) const {
        std::string head;
        std::string tail;
        put(head, static_cast<std::uint16_t>(entries_.size()));
        const std::size_t behind = at + 2 + entries_.size() * 12 + 4;
        for (const Entry& entry : entries_) {
            put(head, entry.tag);
            put(head, entry.type);
            put(head, entry.count);
            if (entry.bytes.size() > 4) {
                put(head, static_cast<std::uint32_t>(behind + tail.size()));
                tail += entry.bytes;
                tail.resize(padded(tail.size()));
            } else {
                std::string value = entry.bytes;
                value.resize(4);
                head += value;
            }
        }
        put(head, std::uint32_t{0}); // no further picture
        return head + tail;
    }

  private:
    struct Entry {
        std::uint16_t tag;
        std::uint16_t type;
        std::uint32_t count;
        std::string bytes;
    };

    static std::size_t padded(std::size_t size) { return (size + 7) / 8 * 8; }

    std::vector<Entry> entries_;
};

/// GeoKeys: projected by EPSG code, or a local grid; pixels are areas; metres.
std::vector<std::uint16_t> geo_keys(std::int64_t epsg) {
    const bool known = epsg > 0 && epsg < 32767;
    std::vector<std::uint16_t> keys = {1, 1, 0, static_cast<std::uint16_t>(known ? 4 : 3)};
    const auto add = [&](std::uint16_t key, std::uint16_t value) { keys.insert(keys.end(), {key, 0, 1, value}); };
    add(1024, known ? 1 : 32767); // GTModelType: projected, user-defined
    add(1025, 1);                 // GTRasterType: pixel is area
    if (known) add(3072, static_cast<std::uint16_t>(epsg));
    add(3076, 9001); // metre
    return keys;
}

/// Names of the bands, as GDAL keeps them (tag 42112).
std::string band_names(std::span<const RasterBand> bands) {
    std::string xml = "<GDALMetadata>";
    for (std::size_t i = 0; i < bands.size(); ++i) {
        xml += fmt::format(R"(<Item name="DESCRIPTION" sample="{}" role="description">{}</Item>)", i, bands[i].name);
    }
    xml += "</GDALMetadata>";
    xml.push_back('\0');
    return xml;
}

/// Strips begin at `at`, one after the other.
Directory describe(const GridFrame& frame, std::span<const RasterBand> bands, std::int64_t epsg, std::uint32_t at) {
    const double north = static_cast<double>(frame.south + frame.rows) * frame.cell;
    const double west = static_cast<double>(frame.west) * frame.cell;
    const std::string nothing("-9999\0", 6);
    const std::vector<std::uint16_t> keys = geo_keys(epsg);
    const std::string names = band_names(bands);
    const auto bytes = static_cast<std::uint32_t>(frame.cells() * sizeof(float));
    const std::size_t n = bands.size();
    std::vector<std::uint32_t> strips;
    for (std::uint32_t i = 0; i < n; ++i) strips.push_back(at + i * bytes);
    const auto shorts = [n](std::uint16_t value) { return bytes_of(std::vector<std::uint16_t>(n, value)); };
    Directory directory;
    directory.add_number(256, static_cast<std::uint32_t>(frame.columns));
    directory.add_number(257, static_cast<std::uint32_t>(frame.rows));
    directory.add(258, kShort, n, shorts(32));                         // bits a sample
    directory.add_short(259, 1);                                       // not compressed
    directory.add_short(262, 1);                                       // more is brighter
    directory.add(273, kLong, n, bytes_of(strips));                    // a strip a band
    directory.add_short(277, static_cast<std::uint16_t>(n));           // samples a pixel
    directory.add_number(278, static_cast<std::uint32_t>(frame.rows)); // rows a strip
    directory.add(279, kLong, n, bytes_of(std::vector<std::uint32_t>(n, bytes)));
    directory.add_short(284, 2); // band after band
    if (n > 1) directory.add(338, kShort, n - 1, bytes_of(std::vector<std::uint16_t>(n - 1, 0)));
    directory.add(339, kShort, n, shorts(3)); // floating point
    directory.add(33550, kDouble, 3, bytes_of(std::vector{frame.cell, frame.cell, 0.0}));
    directory.add(33922, kDouble, 6, bytes_of(std::vector{0.0, 0.0, 0.0, west, north, 0.0}));
    directory.add(34735, kShort, keys.size(), bytes_of(keys));
    directory.add(42112, kAscii, names.size(), names);
    directory.add(42113, kAscii, nothing.size(), nothing); // GDAL's word for no data
    return directory;
}

} // namespace

std::string geotiff(const GridFrame& frame, std::span<const RasterBand> bands, std::int64_t epsg) {
    if (bands.empty()) throw Error(ErrorCode::Usage, "a raster without bands");
    for (const RasterBand& band : bands) {
        if (band.values.size() != frame.cells()) throw Error(ErrorCode::Usage, "a band that is not of its frame");
    }
    constexpr std::size_t kMostBytes = 4'000'000'000; // TIFF counts with 32 bits
    const std::size_t bytes = frame.cells() * sizeof(float) * bands.size();
    if (bytes > kMostBytes) throw Error(ErrorCode::BadInput, "a raster over 4 GB; use larger cells");
    constexpr std::size_t kDirectoryAt = 8;
    const std::size_t directory_size = describe(frame, bands, epsg, 0).size();
    const auto data_at = static_cast<std::uint32_t>((kDirectoryAt + directory_size + 15) / 16 * 16);
    std::string out = "II*";
    out.push_back('\0');
    put(out, static_cast<std::uint32_t>(kDirectoryAt));
    out += describe(frame, bands, epsg, data_at).write(kDirectoryAt);
    out.resize(data_at);
    out.reserve(data_at + bytes);
    for (const RasterBand& band : bands) {
        for (std::int32_t row = frame.rows; row-- > 0;) {
            for (std::int32_t column = 0; column < frame.columns; ++column) {
                const float value = band.values[frame.at(row, column)];
                put(out, std::isnan(value) ? kNothing : value);
            }
        }
    }
    return out;
}

std::string world_file(const GridFrame& frame) {
    return fmt::format("{:.10g}\n0\n0\n{:.10g}\n{:.6f}\n{:.6f}\n", frame.cell, -frame.cell, frame.x(0),
                       frame.y(frame.rows - 1));
}

} // namespace planum::scans
