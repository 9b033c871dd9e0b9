// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "tests/support/e57_writer.hpp"

namespace planum::test {

/// Small scan files of our own, one a format.

inline std::string ptx_header(std::int64_t columns, std::int64_t rows,
                              const std::string& matrix = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n") {
    return fmt::format("{}\n{}\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n{}", columns, rows, matrix);
}

inline std::string sample_ptx() {
    return ptx_header(2, 2, "0 1 0 0\n-1 0 0 0\n0 0 1 0\n10 20 30 1\n") +
           "1 2 3 0.25 10 20 30\n0 0 0 0.5 0 0 0\n-1.5 2.5e0 3 1 255 254 253\n4 5 6 0 1 2 3\n" + ptx_header(1, 2) +
           "7.5 8 9 0.5\n1 1 1 0.75\n";
}

inline std::string sample_pts() { return "2\n1.5 2 3 -2048 1 2 3\n4 5 6 2047 255 0 7\n"; }

inline std::string sample_xyz() { return "# remark\n1 2 3\n4.25 5 6\n-7 8 9e-1\n"; }

inline std::string sample_3d() { return "100 200 300\n-50 0 25.5\n"; }

inline std::string sample_ply_ascii() {
    return "ply\nformat ascii 1.0\ncomment own\nelement camera 1\nproperty float f\nelement vertex "
           "2\nproperty float x\n"
           "property float y\nproperty float z\nproperty uchar red\nproperty uchar green\nproperty uchar "
           "blue\n"
           "property ushort intensity\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n"
           "35\n1 2 3 10 20 30 40000\n4 5 6.5 0 255 1 7\n";
}

template<class T>
void put_value(std::string& out, T value, bool big_endian = false) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    for (std::size_t i = 0; i < sizeof(T); ++i) out.push_back(bytes[big_endian ? sizeof(T) - 1 - i : i]);
}

inline std::string sample_ply_binary(bool big_endian) {
    std::string out =
        fmt::format("ply\nformat binary_{}_endian 1.0\nelement vertex 2\nproperty double x\nproperty double y\n"
                    "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
                    "property ushort intensity\nend_header\n",
                    big_endian ? "big" : "little");
    for (int i = 0; i < 2; ++i) {
        put_value(out, 1.0 + 3 * i, big_endian);
        put_value(out, 2.0 + 3 * i, big_endian);
        put_value(out, 3.0F + 3.5F * static_cast<float>(i), big_endian);
        out += i == 0 ? "\x0a\x14\x1e" : std::string("\x00\xff\x01", 3);
        put_value(out, static_cast<std::uint16_t>(i == 0 ? 40000 : 7), big_endian);
    }
    return out;
}

inline std::string pcd_header(const std::string& data) {
    return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F "
           "F F U\n"
           "COUNT 1 1 1 1\nWIDTH 2\nHEIGHT 2\nVIEWPOINT 1 2 3 1 0 0 0\nPOINTS 4\nDATA " +
           data + "\n";
}

inline std::string sample_pcd_ascii() {
    return pcd_header("ascii") + "1 2 3 658188\nnan nan nan 0\n4 5 6 255\n7 8 9.5 65280\n";
}

inline std::vector<std::vector<float>> pcd_places() { return {{1, NAN, 4, 7}, {2, NAN, 5, 8}, {3, NAN, 6, 9.5F}}; }

inline std::string sample_pcd_binary() {
    std::string out = pcd_header("binary");
    const std::uint32_t colours[] = {658188, 0, 255, 65280};
    const auto places = pcd_places();
    for (std::size_t i = 0; i < 4; ++i) {
        for (const auto& axis : places) put_value(out, axis[i]);
        put_value(out, colours[i]);
    }
    return out;
}

/// The same, its bytes packed as runs without any reference (which LZF allows).
inline std::string sample_pcd_compressed() {
    std::string flat;
    for (const auto& axis : pcd_places()) {
        for (const float value : axis) put_value(flat, value);
    }
    for (const std::uint32_t colour : {658188U, 0U, 255U, 65280U}) put_value(flat, colour);
    std::string packed;
    for (std::size_t at = 0; at < flat.size(); at += 32) {
        const std::size_t count = std::min<std::size_t>(32, flat.size() - at);
        packed.push_back(static_cast<char>(count - 1));
        packed += flat.substr(at, count);
    }
    std::string out = pcd_header("binary_compressed");
    put_number(out, packed.size(), 4);
    put_number(out, flat.size(), 4);
    return out + packed;
}

struct LasSample {
    int format = 3;
    int minor = 2;
    int points = 3;
    bool wide_colours = false;
};

/// Point i at (i, 2i, -i) + (100, 200, 300), intensity 1000 i, colour (i, i + 1, i + 2), time i + 0.5.
inline std::string sample_las(const LasSample& sample = {}) {
    const int header_bytes = sample.minor == 4 ? 375 : sample.minor == 3 ? 235 : 227;
    const int lengths[] = {20, 28, 26, 34, 0, 0, 30, 36, 38};
    const int length = lengths[sample.format];
    std::string out(static_cast<std::size_t>(header_bytes), '\0');
    const auto put = [&](std::size_t at, std::uint64_t value, std::size_t bytes) {
        for (std::size_t i = 0; i < bytes; ++i) out[at + i] = static_cast<char>(value >> (8 * i));
    };
    const auto put_real = [&](std::size_t at, double value) { std::memcpy(out.data() + at, &value, 8); };
    out.replace(0, 4, "LASF");
    put(24, 1, 1);
    put(25, static_cast<std::uint64_t>(sample.minor), 1);
    out.replace(58, 4, "test");
    put(90, 32, 2);
    put(92, 2025, 2);
    put(94, static_cast<std::uint64_t>(header_bytes), 2);
    put(96, static_cast<std::uint64_t>(header_bytes), 4);
    put(104, static_cast<std::uint64_t>(sample.format), 1);
    put(105, static_cast<std::uint64_t>(length), 2);
    if (sample.minor < 4) put(107, static_cast<std::uint64_t>(sample.points), 4);
    if (sample.minor == 4) put(247, static_cast<std::uint64_t>(sample.points), 8);
    for (std::size_t i = 0; i < 3; ++i) {
        put_real(131 + 8 * i, 0.001);
        put_real(155 + 8 * i, 100.0 * static_cast<double>(i + 1));
    }
    for (int i = 0; i < sample.points; ++i) {
        const std::size_t at = out.size();
        out.append(static_cast<std::size_t>(length), '\0');
        const auto raw = [&](int value) {
            return static_cast<std::uint64_t>(static_cast<std::uint32_t>(value * 1000));
        };
        put(at, raw(i), 4);
        put(at + 4, raw(2 * i), 4);
        put(at + 8, raw(-i), 4);
        put(at + 12, static_cast<std::uint64_t>(1000 * i), 2);
        const std::size_t time = sample.format >= 6 ? 22 : sample.format == 1 || sample.format == 3 ? 20 : 0;
        const std::size_t colour = sample.format >= 7 ? 30 : sample.format == 2 ? 20 : sample.format == 3 ? 28 : 0;
        if (time > 0) put_real(at + time, i + 0.5);
        for (std::size_t k = 0; k < 3 && colour > 0; ++k) {
            put(at + colour + 2 * k,
                static_cast<std::uint64_t>(i + static_cast<int>(k)) * (sample.wide_colours ? 256U : 1U), 2);
        }
    }
    return out;
}

/// `count` points on a helix: scaled 24-bit coordinates, 15-bit intensity, colour, rows × columns, every
/// tenth a miss; one image.
inline std::string sample_e57(std::size_t count = 500) {
    std::vector<std::vector<std::int64_t>> v(9, std::vector<std::int64_t>(count));
    for (std::size_t i = 0; i < count; ++i) {
        const auto n = static_cast<std::int64_t>(i);
        v[0][i] = static_cast<std::int64_t>(std::lround(1e6 * std::cos(0.01 * static_cast<double>(i))));
        v[1][i] = static_cast<std::int64_t>(std::lround(1e6 * std::sin(0.01 * static_cast<double>(i))));
        v[2][i] = 100 * n % 4000000 - 2000000;
        v[3][i] = n * 37 % 32768;
        v[4][i] = n % 256;
        v[5][i] = n / 3 % 256;
        v[6][i] = n % 20;
        v[7][i] = n / 20;
        v[8][i] = n % 10 == 9 ? 2 : 0;
    }
    const auto scaled = [](const char* name, std::int64_t low, std::int64_t high, const char* scale) {
        return fmt::format("<{} type=\"ScaledInteger\" minimum=\"{}\" maximum=\"{}\" scale=\"{}\"/>", name, low, high,
                           scale);
    };
    const auto integer = [](const char* name, std::int64_t high) {
        return fmt::format("<{} type=\"Integer\" minimum=\"0\" maximum=\"{}\"/>", name, high);
    };
    const auto columns = static_cast<std::int64_t>(count / 20 + 1);
    E57Writer writer;
    E57Writer::Scan scan;
    scan.records = count;
    scan.packet_bytes = count > 10000 ? 60000 : 3000;
    scan.extra = fmt::format(
        "<guid type=\"String\"><![CDATA[helix]]></guid><pose type=\"Structure\"><rotation type=\"Structure\">"
        "<w type=\"Float\">0</w><z type=\"Float\">1</z></rotation><translation type=\"Structure\">"
        "<x type=\"Float\">10</x></translation></pose><indexBounds type=\"Structure\">"
        "<rowMaximum type=\"Integer\">19</rowMaximum><columnMaximum "
        "type=\"Integer\">{}</columnMaximum></indexBounds>",
        columns - 1);
    scan.columns = {{scaled("cartesianX", -8388608, 8388607, "1e-6"), pack_bits(v[0], -8388608, 24)},
                    {scaled("cartesianY", -8388608, 8388607, "1e-6"), pack_bits(v[1], -8388608, 24)},
                    {scaled("cartesianZ", -8388608, 8388607, "1e-6"), pack_bits(v[2], -8388608, 24)},
                    {scaled("intensity", 0, 32767, "3.0518509475997192e-005"), pack_bits(v[3], 0, 15)},
                    {integer("colorRed", 255), pack_bits(v[4], 0, 8)},
                    {integer("colorGreen", 255), pack_bits(v[5], 0, 8)},
                    {"<colorBlue type=\"Integer\" minimum=\"77\" maximum=\"77\"/>", ""},
                    {integer("rowIndex", 31), pack_bits(v[6], 0, 5)},
                    {integer("columnIndex", 1048575), pack_bits(v[7], 0, 20)},
                    {integer("cartesianInvalidState", 2), pack_bits(v[8], 0, 2)}};
    writer.add_scan(scan);
    writer.add_image("\xFF\xD8\xFF picture", "jpeg");
    return writer.finish();
}

} // namespace planum::test
