// SPDX-License-Identifier: MIT
#include "scans/formats/crc32c.hpp"
#include "scans/formats/e57_fields.hpp"
#include "scans/formats/gps_time.hpp"
#include "scans/formats/lzf.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/read_scan.hpp"
#include "tests/support/scan_samples.hpp"

using namespace planum;
using namespace planum::scans;
using namespace planum::test;

namespace {

// Values through a packed stream, fed in pieces of `piece` bytes.
std::vector<std::int64_t> through_stream(const E57Field& field, const std::string& bytes, std::size_t count,
                                         std::size_t piece) {
    E57Stream stream(field);
    std::vector<std::int64_t> out;
    std::size_t at = 0;
    while (out.size() < count) {
        const std::size_t ready = static_cast<std::size_t>(stream.available(count - out.size()));
        if (ready == 0) {
            if (at >= bytes.size()) break;
            const std::size_t more = std::min(piece, bytes.size() - at);
            std::copy_n(bytes.data() + at, more, stream.append(more));
            at += more;
            continue;
        }
        out.resize(out.size() + ready);
        stream.take_integers(out.data() + out.size() - ready, ready);
    }
    return out;
}

std::string damaged(std::string file, std::size_t at) {
    file[at] = static_cast<char>(file[at] ^ 1);
    return file;
}

} // namespace

TEST_CASE("CRC-32C is the one of the standard, by instruction and by table") {
    const std::string check = "123456789";
    CHECK(crc32c(check) == 0xE3069283U);
    CHECK(crc32c_by_table(check) == 0xE3069283U);
    std::string bytes;
    for (int i = 0; i < 1020; ++i) bytes.push_back(static_cast<char>(i * 7));
    for (std::size_t n = 0; n < bytes.size(); n += 13)
        CHECK(crc32c({bytes.data(), n}) == crc32c_by_table({bytes.data(), n}));
}

TEST_CASE("Integers of every width come back from the bit stream, however it is cut") {
    for (unsigned bits = 1; bits <= 64; ++bits) {
        E57Field field;
        field.bits = bits;
        field.minimum = bits == 64 ? INT64_MIN : -5;
        std::vector<std::int64_t> values;
        std::uint64_t state = bits;
        for (int i = 0; i < 100; ++i) {
            state = state * 6364136223846793005ULL + 1442695040888963407ULL;
            const std::uint64_t raw = bits == 64 ? state : state >> (64U - bits);
            values.push_back(static_cast<std::int64_t>(static_cast<std::uint64_t>(field.minimum) + raw));
        }
        const std::string packed = pack_bits(values, field.minimum, bits);
        for (const std::size_t piece : {1U, 3U, 64U, 4096U}) {
            INFO(bits << " bits in pieces of " << piece);
            CHECK(through_stream(field, packed, values.size(), piece) == values);
        }
    }
}

TEST_CASE("Texts in a table are passed over, short and long ones") {
    E57Field field;
    field.kind = E57Kind::String;
    E57Stream stream(field);
    std::string bytes = "\x06"
                        "abc";
    put_number(bytes, (300U << 1U) | 1U, 8);
    bytes += std::string(300, 'x') + '\0';
    std::copy(bytes.begin(), bytes.end() - 1, stream.append(bytes.size() - 1));
    CHECK(stream.available(9) == 2);
    *stream.append(1) = bytes.back();
    CHECK(stream.available(9) == 3);
    stream.skip(3);
    CHECK(stream.waiting() == 0);
}

TEST_CASE("E57 reads grid, pose, 15-bit intensity, constant colour and misses") {
    const auto reader = open_bytes(sample_e57(500), ScanFormat::E57);
    REQUIRE(reader->clouds().size() == 1);
    const CloudHeader& header = reader->clouds()[0];
    CHECK(header.guid == "helix");
    CHECK(header.rows == 20);
    CHECK(header.columns == 26);
    // Half a turn about z, then 10 m in x.
    CHECK((header.site_from_scan * Eigen::Vector3d(1, 2, 3)).isApprox(Eigen::Vector3d(9, -2, 3)));
    const WholeCloud whole = read_whole(*reader, 0, Misses::Keep, 100);
    REQUIRE(whole.points.size() == 500);
    CHECK(whole.summary.misses == 50);
    for (std::size_t i = 0; i < 500; ++i) {
        const double angle = 0.01 * static_cast<double>(i);
        REQUIRE(whole.points.x[i] == Approx(std::cos(angle)).margin(6e-7));
        REQUIRE(whole.points.z[i] == Approx(-2.0 + 1e-4 * static_cast<double>(i)));
        REQUIRE(whole.points.intensity[i] == i * 37 % 32768);
        REQUIRE(whole.points.colour[i] ==
                Rgb{static_cast<std::uint8_t>(i % 256), static_cast<std::uint8_t>(i / 3 % 256), 77});
        REQUIRE(whole.points.row[i] == i % 20);
        REQUIRE(whole.points.column[i] == i / 20);
        REQUIRE((whole.points.validity[i] == Validity::Invalid) == (i % 10 == 9));
    }
    CHECK(reader->read_image(0) == "\xFF\xD8\xFF picture");
    CHECK_THROWS_AS(reader->read_image(1), Error);
}

TEST_CASE("E57 reads floating point, spherical coordinates and 16-bit colours") {
    const std::vector<double> range = {2.0, 4.0};
    const std::vector<double> azimuth = {0.0, std::acos(0.0)};
    const std::vector<double> elevation = {0.0, std::acos(0.5)};
    const std::vector<std::int64_t> colour = {0, 65535};
    E57Writer::Scan scan;
    scan.records = 2;
    scan.columns = {{"<sphericalRange type=\"Float\" precision=\"single\"/>", pack_floats<float>(range)},
                    {"<sphericalAzimuth type=\"Float\"/>", pack_floats<double>(azimuth)},
                    {"<sphericalElevation type=\"Float\"/>", pack_floats<double>(elevation)},
                    {"<colorRed type=\"Integer\" minimum=\"0\" maximum=\"65535\"/>", pack_bits(colour, 0, 16)},
                    {"<colorGreen type=\"Integer\" minimum=\"0\" maximum=\"65535\"/>", pack_bits(colour, 0, 16)},
                    {"<colorBlue type=\"Integer\" minimum=\"0\" maximum=\"65535\"/>", pack_bits(colour, 0, 16)},
                    {"<sphericalInvalidState type=\"Float\" precision=\"single\"/>",
                     pack_floats<float>(std::vector<double>{0, 1})}};
    E57Writer writer;
    writer.add_scan(scan);
    const WholeCloud whole = read_whole(*open_bytes(writer.finish(), ScanFormat::E57), 0, Misses::Keep);
    REQUIRE(whole.points.size() == 2);
    CHECK(whole.points.x[0] == Approx(2.0));
    CHECK(whole.points.y[1] == Approx(2.0));
    CHECK(whole.points.z[1] == Approx(4.0 * std::sqrt(0.75)));
    CHECK(whole.points.colour[1] == Rgb{255, 255, 255});
    CHECK(whole.points.validity[1] == Validity::DirectionOnly);
}

TEST_CASE("A grid without stated bounds is as large as the indexes") {
    const std::vector<double> zeros = {0, 1, 2};
    const std::vector<std::int64_t> rows = {0, 4, 2};
    E57Writer::Scan scan;
    scan.records = 3;
    for (const char* name : {"cartesianX", "cartesianY", "cartesianZ"}) {
        scan.columns.push_back({fmt::format("<{} type=\"Float\"/>", name), pack_floats<double>(zeros)});
    }
    scan.columns.push_back({"<rowIndex type=\"Integer\" minimum=\"0\" maximum=\"7\"/>", pack_bits(rows, 0, 3)});
    scan.columns.push_back({"<columnIndex type=\"Integer\" minimum=\"0\" maximum=\"0\"/>", ""});
    E57Writer writer;
    writer.add_scan(scan);
    const auto reader = open_bytes(writer.finish(), ScanFormat::E57);
    CHECK(reader->clouds()[0].rows == 5);
    CHECK(reader->clouds()[0].columns == 1);
}

TEST_CASE("A damaged page is named, and only matters to who reads it") {
    const std::string good = sample_e57(5000);
    const std::string bad = damaged(good, 20 * 1024 + 100);
    const auto reader = open_bytes(bad, ScanFormat::E57);
    CHECK(reader->read_image(0) == "\xFF\xD8\xFF picture");
    CHECK_THROWS_WITH(read_whole(*reader), Catch::Contains("scan 1") && Catch::Contains("page 20 of"));
    CHECK_THAT(refusal(damaged(good, 60), ScanFormat::E57), Catch::Contains("page 0 of"));
}

TEST_CASE("E57 tables that promise what they cannot hold are refused") {
    const auto with = [](const std::string& element, std::uint64_t records) {
        E57Writer::Scan scan;
        scan.records = records;
        for (const char* name : {"cartesianX", "cartesianY", "cartesianZ"}) {
            scan.columns.push_back({fmt::format("<{} {}/>", name, element), {}});
        }
        E57Writer writer;
        writer.add_scan(scan);
        return writer.finish();
    };
    CHECK_THAT(refusal(with("type=\"Float\"", 1000000), ScanFormat::E57), Catch::Contains("do not fit"));
    CHECK_THAT(refusal(with("type=\"Float\"", 3), ScanFormat::E57), Catch::Contains("after 0 of 3 records"));
    CHECK_THAT(refusal(with("type=\"Integer\" minimum=\"3\" maximum=\"3\"", 1ULL << 60U), ScanFormat::E57),
               Catch::Contains("do not fit"));
    CHECK_THAT(refusal(with("type=\"Integer\" minimum=\"4\" maximum=\"3\"", 1), ScanFormat::E57),
               Catch::Contains("maximum below minimum"));
    CHECK_THAT(refusal(with("type=\"Vector\"", 1), ScanFormat::E57), Catch::Contains("cartesianX"));
}

TEST_CASE("LAS reads every point format, and colours of 8 and 16 bits") {
    for (const int format : {0, 1, 2, 3, 6, 7, 8}) {
        for (const int minor : {2, 3, 4}) {
            INFO("format " << format << ", 1." << minor);
            const auto reader = open_bytes(sample_las({format, minor, 3, false}), ScanFormat::Las);
            const WholeCloud whole = read_whole(*reader);
            REQUIRE(whole.points.size() == 3);
            CHECK(whole.points.y[2] == Approx(204.0));
            CHECK(whole.points.z[2] == Approx(298.0));
            CHECK(whole.points.intensity[2] == 2000);
            const bool timed = format != 0 && format != 2;
            CHECK(whole.points.time.size() == (timed ? 3U : 0U));
            if (timed) CHECK(whole.points.time[2] == 2.5);
            if (!whole.points.colour.empty()) CHECK(whole.points.colour[2] == Rgb{2, 3, 4});
        }
    }
    CHECK(read_whole(*open_bytes(sample_las({3, 2, 3, true}), ScanFormat::Las)).points.colour[2] == Rgb{2, 3, 4});
    CHECK(open_bytes(sample_las(), ScanFormat::Las)->info().created_at == "2025-02-01");
}

TEST_CASE("LAZ is named with what to do, and other LAS that cannot be read with its reason") {
    std::string laz = sample_las();
    laz[104] = static_cast<char>(laz[104] | 0x80);
    CHECK_THAT(refusal(laz, ScanFormat::Las), Catch::Contains("LAZ") && Catch::Contains("laszip"));
    std::string waves = sample_las();
    waves[104] = 4;
    CHECK_THAT(refusal(waves, ScanFormat::Las), Catch::Contains("point format 4"));
    std::string cut = sample_las();
    cut.resize(cut.size() - 1);
    CHECK_THAT(refusal(cut, ScanFormat::Las), Catch::Contains("after record 2 of 3"));
    CHECK_THAT(refusal("LASF", ScanFormat::Las), Catch::Contains("too few"));
}

TEST_CASE("PLY reads the same from text and from both byte orders") {
    const PointBlock text = read_whole(*open_bytes(sample_ply_ascii(), ScanFormat::Ply)).points;
    CHECK(text.z == std::vector<double>{3, 6.5});
    CHECK(text.intensity == std::vector<std::uint16_t>{40000, 7});
    CHECK(text.colour[0] == Rgb{10, 20, 30});
    CHECK(read_whole(*open_bytes(sample_ply_binary(false), ScanFormat::Ply)).points == text);
    CHECK(read_whole(*open_bytes(sample_ply_binary(true), ScanFormat::Ply)).points == text);
}

TEST_CASE("A PLY that cannot be right is refused") {
    CHECK_THAT(refusal("ply\nformat ascii 1.0\n", ScanFormat::Ply), Catch::Contains("end_header"));
    CHECK_THAT(refusal("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n", ScanFormat::Ply),
               Catch::Contains("lacks x, y or z"));
    CHECK_THAT(refusal("ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty float x\nproperty float "
                       "y\nproperty float z\nend_header\n1 2 3\n",
                       ScanFormat::Ply),
               Catch::Contains("do not fit"));
    CHECK_THAT(refusal("ply\nformat ascii 1.0\nelement vertex 1\nproperty floot x\n", ScanFormat::Ply),
               Catch::Contains("line 4"));
    std::string cut = sample_ply_binary(false);
    cut.resize(cut.size() - 1);
    CHECK_THAT(refusal(cut, ScanFormat::Ply), Catch::Contains("2 vertices do not fit"));
}

TEST_CASE("PCD reads the same from text, binary and compressed") {
    const auto reader = open_bytes(sample_pcd_ascii(), ScanFormat::Pcd);
    const WholeCloud text = read_whole(*reader);
    CHECK(reader->clouds()[0].rows == 2);
    CHECK(reader->clouds()[0].site_from_scan.translation().isApprox(Eigen::Vector3d(1, 2, 3)));
    CHECK(text.summary.misses == 1);
    CHECK(text.points.colour[0] == Rgb{10, 11, 12});
    CHECK(text.points.row == std::vector<std::uint32_t>{0, 1, 1});
    CHECK(text.points.column == std::vector<std::uint32_t>{0, 0, 1});
    CHECK(read_whole(*open_bytes(sample_pcd_binary(), ScanFormat::Pcd)).points == text.points);
    CHECK(read_whole(*open_bytes(sample_pcd_compressed(), ScanFormat::Pcd)).points == text.points);
}

TEST_CASE("LZF repeats what a reference points to, overlapping too") {
    // "ab", then 7 bytes from distance 2: abababab a.
    CHECK(unpack_lzf(std::string("\x01"
                                 "ab"
                                 "\xA0\x01",
                                 5),
                     9) == "ababababa");
    // A long reference: length byte behind the control.
    CHECK(unpack_lzf(std::string("\x00"
                                 "x"
                                 "\xE0\x03\x00",
                                 5),
                     13) == std::string(13, 'x'));
    CHECK_THROWS_WITH(unpack_lzf(std::string("\x00"
                                             "x"
                                             "\x20\x05",
                                             4),
                                 4),
                      Catch::Contains("damaged at their byte 2"));
    CHECK_THROWS_WITH(unpack_lzf(std::string("\x00x", 2), 1000000), Catch::Contains("cannot hold"));
    CHECK_THROWS_AS(unpack_lzf(std::string("\x05x", 2), 6), Error);
}

TEST_CASE("A PCD that cannot be right is refused") {
    CHECK_THAT(refusal("VERSION 0.7\nFIELDS x y z\n", ScanFormat::Pcd), Catch::Contains("DATA"));
    CHECK_THAT(refusal("FIELDS x y\nSIZE 4 4\nTYPE F F\nWIDTH 1\nPOINTS 1\nDATA ascii\n1 2\n", ScanFormat::Pcd),
               Catch::Contains("no fields x, y and z"));
    CHECK_THAT(
        refusal("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 5\nHEIGHT 2\nPOINTS 11\nDATA ascii\n", ScanFormat::Pcd),
        Catch::Contains("POINTS 11"));
    CHECK_THAT(refusal("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 1000\nDATA binary\n1", ScanFormat::Pcd),
               Catch::Contains("do not fit"));
    std::string cut = sample_pcd_compressed();
    cut.resize(cut.size() - 1);
    CHECK_THAT(refusal(cut, ScanFormat::Pcd), Catch::Contains("cut short"));
}

TEST_CASE("Any file cut at any byte is read or refused, and nothing else") {
    const std::pair<ScanFormat, std::string> samples[] = {{ScanFormat::Ptx, sample_ptx()},
                                                          {ScanFormat::E57, sample_e57(120)},
                                                          {ScanFormat::Las, sample_las()},
                                                          {ScanFormat::Las, sample_las({7, 4, 3, true})},
                                                          {ScanFormat::Ply, sample_ply_ascii()},
                                                          {ScanFormat::Ply, sample_ply_binary(true)},
                                                          {ScanFormat::Pcd, sample_pcd_ascii()},
                                                          {ScanFormat::Pcd, sample_pcd_binary()},
                                                          {ScanFormat::Pcd, sample_pcd_compressed()},
                                                          {ScanFormat::Pts, sample_pts()},
                                                          {ScanFormat::Xyz, sample_xyz()},
                                                          {ScanFormat::ThreeDtk, sample_3d()}};
    for (const auto& [format, bytes] : samples) {
        INFO(format_name(format));
        CHECK(refusal(bytes, format).empty());
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            CHECK_NOTHROW(refusal(bytes.substr(0, size), format));
        }
    }
}

TEST_CASE("GPS seconds are UTC with leap seconds") {
    CHECK(iso_time_of_gps(1e9) == "2011-09-14T01:46:25Z");
    CHECK(iso_time_of_gps(0.0).empty());
    CHECK(iso_time_of_gps(-1.0).empty());
    CHECK(iso_date_of_year_day(2024, 60) == "2024-02-29");
}
