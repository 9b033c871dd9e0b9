// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <numbers>

#include <fmt/format.h>
#include <png.h>

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "scans/panorama/panorama.hpp"

namespace planum::scans {

namespace {

/// The value below which `share` of all lie.
template<class T>
T quantile(LargeVector<T> values, double share) {
    if (values.empty()) return T{};
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

constexpr double kDarkestRange = 0.85; ///< how much darker than white the farthest is

// 1 … 255, so that 0 stays for "nothing".
std::uint8_t grey(double share) noexcept {
    return static_cast<std::uint8_t>(1.0 + 254.0 * std::clamp(share, 0.0, 1.0));
}

std::string json_text(std::string_view s) {
    std::string out = "\"";
    for (const char c : text::clean_utf8(s).text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) < 0x20U)
            out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else
            out += c;
    }
    return out + '"';
}

void append_bytes(png_structp png, png_bytep bytes, png_size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

void flush_nothing(png_structp /*png*/) {}

} // namespace

std::string_view channel_name(Channel channel) noexcept {
    switch (channel) {
    case Channel::Reflectance: return "reflectance";
    case Channel::Range: return "range";
    case Channel::Colour: return "colour";
    case Channel::Normals: return "normals";
    }
    return "";
}

// Light from the scanner: the cosine between ray and surface normal.
std::uint8_t Panorama::shade(int column, int row) const noexcept {
    const auto neighbour = [&](int c, int r) -> std::optional<Eigen::Vector3d> {
        const auto points = points_at(c, r);
        const float here = front_range(column, row);
        if (points.empty() || std::abs(ranges_[points.front()] - here) > 0.05F * here) return std::nullopt;
        return place(points.front());
    };
    const Eigen::Vector3d here = place(points_at(column, row).front());
    const auto along = [&](int dc, int dr) -> Eigen::Vector3d {
        const auto before = neighbour(column - dc, row - dr);
        const auto after = neighbour(column + dc, row + dr);
        return (after ? *after : here) - (before ? *before : here);
    };
    const Eigen::Vector3d normal = along(2, 0).cross(along(0, 2));
    const double length = normal.norm() * here.norm();
    return length > 0.0 ? grey(std::abs(normal.dot(here)) / length) : grey(0.5);
}

Picture Panorama::picture(Channel channel) const {
    if ((channel == Channel::Reflectance && !has_.intensity) || (channel == Channel::Colour && !has_.colour)) {
        throw Error(ErrorCode::BadInput, fmt::format("the scan has no {}", channel_name(channel)));
    }
    Picture picture{width(), height(), channel == Channel::Colour ? 3 : 1, {}};
    picture.values.resize(static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()) *
                          static_cast<std::size_t>(picture.channels));
    // A few very bright or far points shall not make the rest black.
    const double dark = channel == Channel::Reflectance ? quantile(intensities_, 0.01) : 0.0;
    const double bright = channel == Channel::Reflectance ? quantile(intensities_, 0.99) : 1.0;
    const double near = channel == Channel::Range ? static_cast<double>(quantile(ranges_, 0.01)) : 1.0;
    const double far = channel == Channel::Range ? static_cast<double>(quantile(ranges_, 0.99)) : 1.0;
    const double depth = std::log(std::max(far / near, 1.001));
    std::size_t at = 0;
    for (int row = 0; row < height(); ++row) {
        for (int column = 0; column < width(); ++column, at += static_cast<std::size_t>(picture.channels)) {
            const std::span<const std::uint32_t> points = points_at(column, row);
            if (points.empty()) continue;
            const std::uint32_t front = points.front();
            switch (channel) {
            case Channel::Reflectance:
                picture.values[at] = grey((intensities_[front] - dark) / std::max(1.0, bright - dark));
                break;
            case Channel::Range:
                // Near is bright. By the logarithm, so that a trench near the scanner has its share of the tones though
                // a house far away is in the picture too; and never as dark as where there is nothing.
                picture.values[at] = grey(
                    1.0 - kDarkestRange * std::min(1.0, std::log(static_cast<double>(ranges_[front]) / near) / depth));
                break;
            case Channel::Normals: picture.values[at] = shade(column, row); break;
            case Channel::Colour:
                picture.values[at] = colours_[front].red;
                picture.values[at + 1] = colours_[front].green;
                picture.values[at + 2] = colours_[front].blue;
                break;
            }
        }
    }
    return picture;
}

std::string encode_png(const Picture& picture) {
    std::string out;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
    if (info == nullptr) throw Error(ErrorCode::Internal, "libpng cannot be used");
    std::vector<png_bytep> rows;
    const auto stride = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.channels);
    for (int row = 0; row < picture.height; ++row) {
        rows.push_back(const_cast<png_bytep>(picture.values.data()) + static_cast<std::size_t>(row) * stride);
    }
    if (setjmp(png_jmpbuf(png)) != 0) { // NOLINT: libpng's way to fail
        png_destroy_write_struct(&png, &info);
        throw Error(ErrorCode::Internal, "the picture cannot be written as PNG");
    }
    png_set_write_fn(png, &out, append_bytes, flush_nothing);
    png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width), static_cast<png_uint_32>(picture.height), 8,
                 picture.channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(png, 6);
    png_set_rows(png, info, rows.data());
    png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    png_destroy_write_struct(&png, &info);
    return out;
}

void write_panorama(const Panorama& panorama, Channel channel, const std::filesystem::path& png,
                    const std::string& scan, const std::optional<Eigen::Isometry3d>& site_from_scan) {
    const ProjectionOptions& o = panorama.projection().options();
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    std::string pose = "null";
    if (site_from_scan) {
        pose = "[";
        for (int i = 0; i < 16; ++i)
            pose += fmt::format("{}{}", i == 0 ? "" : ", ", site_from_scan->matrix()(i / 4, i % 4));
        pose += "]";
    }
    const std::string json = fmt::format(
        "{{\n  \"scan\": {},\n  \"channel\": \"{}\",\n  \"projection\": \"{}\",\n  \"width\": "
        "{},\n  \"height\": {},\n"
        "  \"azimuth_left_deg\": {},\n  \"azimuth_right_deg\": {},\n  \"elevation_top_deg\": "
        "{},\n  \"elevation_bottom_deg\": {},\n"
        "  \"views\": {},\n  \"pannini_distance\": {},\n  \"site_from_scan\": {}\n}}\n",
        json_text(scan), channel_name(channel), projection_name(o.kind), o.width, o.height, o.azimuth_to * kDegrees,
        o.azimuth_from * kDegrees, o.elevation_to * kDegrees, o.elevation_from * kDegrees, o.views, o.distance, pose);
    write_file_atomically(png, encode_png(panorama.picture(channel)));
    std::filesystem::path beside = png;
    write_file_atomically(beside.replace_extension(".json"), json);
}

} // namespace planum::scans
