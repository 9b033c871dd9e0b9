// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "scans/formats/line_reader.hpp"
#include "scans/formats/parse_number.hpp"
#include "scans/formats/point_plan.hpp"
#include "scans/formats/rigid_pose.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/read_scan.hpp"
#include "tests/support/scan_samples.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;
using namespace planum::scans;
using namespace planum::test;

namespace {

std::optional<double> number(std::string text, char point = '.') {
    const std::size_t size = text.size();
    text += '\n';
    double value = 0.0;
    const char* end = parse_number(text.data(), text.data() + size, value, point);
    if (end != text.data() + size) return std::nullopt;
    return value;
}

} // namespace

TEST_CASE("A number is the double nearest to its digits, whichever way it is read") {
    for (const char* digits :
         {"0", "-0.5", "637012.240000", "0.1", "9007199254740993", "123456789012345678", "1e22", "-1.5E-3",
          "0.000000000000000000001", "99999999999999999999999999", "+7", ".5", "5.", "1.7976931348623157e308"}) {
        INFO(digits);
        REQUIRE(number(digits).has_value());
        CHECK(*number(digits) == std::strtod(digits, nullptr));
    }
    CHECK(*number("1,25", ',') == 1.25);
    CHECK(std::isnan(*number("nan")));
}

TEST_CASE("What is no number is told from one") {
    for (const char* digits : {"", "-", ".", "abc", "1e999", "--1", "1.2.3", "0x10"}) {
        INFO(digits);
        CHECK_FALSE(number(digits).has_value());
    }
}

TEST_CASE("Lines are found across windows, with and without carriage return and last line end") {
    std::string text;
    for (int i = 0; i < 3000; ++i) text += fmt::format("line {}{}", i, i % 2 == 0 ? "\r\n" : "\n");
    text += "last";
    const auto source = memory_source(text);
    LineReader lines(*source, 0, 1, 1000);
    for (int i = 0; i < 3000; ++i) {
        REQUIRE(lines.next());
        REQUIRE(lines.line() == fmt::format("line {}", i));
    }
    REQUIRE(lines.next());
    CHECK(lines.line() == "last");
    CHECK(lines.number() == 3001);
    CHECK_FALSE(lines.next());
    LineReader skipping(*source, 0, 1, 1000);
    CHECK(skipping.skip(2999) == 2999);
    REQUIRE(skipping.next());
    CHECK(skipping.line() == "line 2999");
    CHECK(skipping.skip(10) == 1);
}

TEST_CASE("A line without end is refused instead of held in memory") {
    const auto source = memory_source(std::string(200000, '1'));
    LineReader lines(*source);
    CHECK_THROWS_WITH(lines.next(), Catch::Contains("line 1: longer than 65536 bytes"));
}

TEST_CASE("PTX keeps the grid, the pose and every cloud") {
    const auto reader = open_bytes(sample_ptx(), ScanFormat::Ptx);
    REQUIRE(reader->clouds().size() == 2);
    const CloudHeader& header = reader->clouds()[0];
    CHECK(header.rows == 2);
    CHECK(header.columns == 2);
    CHECK(header.has == Columns{true, true, true, false});
    // The file's row vectors: (x, y, z) * M, so (1, 2, 3) goes to (-2, 1, 3) + (10, 20, 30).
    const Eigen::Vector3d x_in_site = header.site_from_scan * Eigen::Vector3d(1, 2, 3);
    CHECK(x_in_site.isApprox(Eigen::Vector3d(8, 21, 33)));
    const WholeCloud whole = read_whole(*reader);
    CHECK(whole.points.x == std::vector<double>{1, -1.5, 4});
    CHECK(whole.points.row == std::vector<std::uint32_t>{0, 0, 1});
    CHECK(whole.points.column == std::vector<std::uint32_t>{0, 1, 1});
    CHECK(whole.points.intensity == std::vector<std::uint16_t>{16384, 65535, 0});
    CHECK(whole.points.colour[1] == Rgb{255, 254, 253});
    CHECK(whole.summary.misses == 1);
    const WholeCloud kept = read_whole(*reader, 0, Misses::Keep);
    CHECK(kept.points.size() == 4);
    CHECK(kept.points.validity[1] == Validity::Invalid);
    const WholeCloud second = read_whole(*reader, 1);
    CHECK(second.points.y == std::vector<double>{8, 1});
    CHECK(second.points.colour.empty());
}

TEST_CASE("Blocks of any size give the same points") {
    const auto reader = open_bytes(sample_ptx(), ScanFormat::Ptx);
    const PointBlock all = read_whole(*reader).points;
    CHECK(read_whole(*reader, 0, Misses::Skip, 1).points == all);
    CHECK(read_whole(*reader, 0, Misses::Skip, 2).points == all);
}

TEST_CASE("PTX intensities of -2048 to 2047 are kept as whole steps") {
    const auto reader = open_bytes(ptx_header(1, 2) + "1 2 3 -2048\n1 2 3 2047\n", ScanFormat::Ptx);
    const WholeCloud whole = read_whole(*reader);
    const IntensityCoding& coding = reader->clouds()[0].intensity;
    CHECK(coding.value(whole.points.intensity[0]) == -2048.0);
    CHECK(coding.value(whole.points.intensity[1]) == 2047.0);
}

TEST_CASE("A PTX that cannot be right is refused with its line") {
    CHECK_THAT(refusal("", ScanFormat::Ptx), Catch::Contains("line 1"));
    CHECK_THAT(refusal("two\n", ScanFormat::Ptx), Catch::Contains("line 1: no number of columns"));
    CHECK_THAT(refusal("2\n-1\n", ScanFormat::Ptx), Catch::Contains("line 2: no number of rows"));
    CHECK_THAT(refusal(ptx_header(2, 2) + "1.000000 2.000000 3.000000 0.5\n", ScanFormat::Ptx),
               Catch::Contains("1 of 4 points"));
    CHECK_THAT(refusal(ptx_header(4000000000, 4000000000) + "1 2 3 0.5\n", ScanFormat::Ptx),
               Catch::Contains("do not fit"));
    CHECK_THAT(refusal(ptx_header(1, 2) + "1 2 3 0.5\n1 x 3 0.5\n", ScanFormat::Ptx),
               Catch::Contains("line 12: field 2"));
    CHECK_THAT(refusal(ptx_header(1, 2) + "1 2 3 0.5\n1 2 3 0.5 6\n", ScanFormat::Ptx),
               Catch::Contains("line 12: more numbers"));
    CHECK_THAT(refusal(ptx_header(1, 1, "-1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n") + "1 2 3 0.5\n", ScanFormat::Ptx),
               Catch::Contains("line 10: the matrix mirrors"));
    CHECK_THAT(refusal(ptx_header(1, 1, "0 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n") + "1 2 3 0.5\n", ScanFormat::Ptx),
               Catch::Contains("flattens"));
}

TEST_CASE("A matrix is a rotation and a stretch, and together they are the matrix") {
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    m.topLeftCorner<3, 3>() = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix() *
                              Eigen::Vector3d(1, 2, 0.5).asDiagonal();
    m.topRightCorner<3, 1>() = Eigen::Vector3d(4, 5, 6);
    const SplitPose split = split_pose(m);
    REQUIRE(split.scan_from_file);
    CHECK(split.site_from_scan.linear().determinant() == Approx(1.0));
    CHECK((split.site_from_scan.linear() * *split.scan_from_file).isApprox(m.topLeftCorner<3, 3>(), 1e-12));
}

TEST_CASE("PTS counts, and without a count takes all lines") {
    const auto reader = open_bytes(sample_pts(), ScanFormat::Pts);
    const WholeCloud whole = read_whole(*reader);
    CHECK(whole.points.size() == 2);
    CHECK(reader->clouds()[0].intensity.value(whole.points.intensity[0]) == -2048.0);
    CHECK(whole.points.colour[1] == Rgb{255, 0, 7});
    CHECK(read_whole(*open_bytes("1 2 3\n4 5 6\n7 8 9\n", ScanFormat::Pts)).points.size() == 3);
    const auto two = open_bytes("1\n1 2 3\n2\n4 5 6\n7 8 9\n", ScanFormat::Pts);
    REQUIRE(two->clouds().size() == 2);
    CHECK(read_whole(*two, 1).points.x == std::vector<double>{4, 7});
    CHECK_THAT(refusal("3\n1.0000 2.0000 3.0000\n", ScanFormat::Pts), Catch::Contains("1 of 3 points"));
    CHECK_THAT(refusal("1000000\n1 2 3\n", ScanFormat::Pts), Catch::Contains("do not fit"));
    CHECK_THAT(refusal("1\n1 2 3 4 5\n", ScanFormat::Pts), Catch::Contains("line 2: 5 columns"));
}

TEST_CASE("XYZ shows which columns it guessed and why") {
    const auto guess = [](const std::string& bytes, const std::string& columns = {}) {
        return open_bytes(bytes, ScanFormat::Xyz, std::nullopt, columns)->info().column_guess;
    };
    CHECK(guess(sample_xyz()) == "x y z (by number and values; cut by blanks)");
    CHECK(guess("1 2 3 0.5\n") == "x y z intensity (by number and values; cut by blanks)");
    CHECK(guess("1 2 3 10 20 30\n") == "x y z red green blue (by number and values; cut by blanks)");
    CHECK(guess("1 2 3 0.1 0.2 -0.3\n") == "x y z - - - (by number and values; cut by blanks)");
    CHECK(guess("1,2,3,77.5,10,20,30\n") == "x y z intensity red green blue (by number and values; cut by commas)");
    CHECK(guess("1\t2\t3\t10\t20\t30\t0.5\n") == "x y z red green blue intensity (by number and values; cut by tabs)");
    CHECK(guess("nr;Y;X;Z\n9;2;1;3\n") == "- y x z (by the names in the file; cut by semicolons)");
    CHECK(guess("1,5;2,5;3,5\n") == "x y z (by number and values; cut by semicolons; decimal comma)");
    CHECK(guess("P1 1 2 3\nP2 4 5 6\n") == "- x y z (by number and values; cut by blanks)");
    CHECK(guess("1\t2\t3\tpeg\t40\n") == "x y z - intensity (by number and values; cut by tabs)");
    CHECK(guess("East;North;Height\n1;2;3\n") == "x y z (by the names in the file; cut by semicolons)");
    CHECK(guess("Höhe;Rechtswert;Hochwert\n3;1;2\n") == "z x y (by the names in the file; cut by semicolons)");
    CHECK(guess("1 2 3 4 5\n", "y,x,z,-,intensity") == "y x z - intensity (as told; cut by blanks)");
}

TEST_CASE("XYZ reads what it guessed") {
    CHECK(read_whole(*open_bytes(sample_xyz(), ScanFormat::Xyz)).points.x == std::vector<double>{1, 4.25, -7});
    CHECK(read_whole(*open_bytes("1,5;2,5;3,5\n4;5;6;\n", ScanFormat::Xyz)).points.y == std::vector<double>{2.5, 5});
    CHECK(read_whole(*open_bytes("1,5 2,5 3,5\n", ScanFormat::Xyz)).points.z == std::vector<double>{3.5});
    const WholeCloud named =
        read_whole(*open_bytes("\"Name\",\"X\",\"Y\",\"Z\"\n\"a b\",1,2,3\nc,4,5,6\n", ScanFormat::Xyz));
    CHECK(named.points.y == std::vector<double>{2, 5});
    CHECK(read_whole(*open_bytes("\xEF\xBB\xBF"
                                 "1 2 3\n",
                                 ScanFormat::Xyz))
              .points.x == std::vector<double>{1});
    CHECK_THAT(refusal("1 2 3\n1 2\n", ScanFormat::Xyz), Catch::Contains("line 2: 3 columns expected"));
    CHECK_THAT(refusal("1 2 3\n1 2 3 4\n", ScanFormat::Xyz), Catch::Contains("line 2: more than the 3 columns"));
    CHECK_THAT(refusal("1 2 3\n1 b 3\n", ScanFormat::Xyz), Catch::Contains("line 2: column 2 (y)"));
    CHECK_THAT(refusal("words only\n", ScanFormat::Xyz), Catch::Contains("no line with x, y and z"));
    CHECK_THROWS_AS(open_bytes("1 2 3\n", ScanFormat::Xyz, std::nullopt, "x,y,zz"), Error);
}

TEST_CASE("3DTK centimetres, left-handed with y up, become metres, right-handed with z up") {
    const auto reader = open_bytes(sample_3d(), ScanFormat::ThreeDtk, "0 0 100\n0 90 0\n");
    const WholeCloud whole = read_whole(*reader);
    // x right, y up, z forward = (100, 200, 300) cm: forward 3 m, left -1 m, up 2 m.
    CHECK(whole.points.x[0] == Approx(3.0));
    CHECK(whole.points.y[0] == Approx(-1.0));
    CHECK(whole.points.z[0] == Approx(2.0));
    const Eigen::Isometry3d& pose = reader->clouds()[0].site_from_scan;
    CHECK(pose.linear().determinant() == Approx(1.0));
    CHECK(pose.translation().isApprox(Eigen::Vector3d(1, 0, 0)));
    // 90° about their y takes their z (forward) to their x (right): ours forward to right, so -y.
    CHECK((pose.linear() * Eigen::Vector3d::UnitX()).isApprox(-Eigen::Vector3d::UnitY()));
    CHECK_THROWS_WITH(open_bytes(sample_3d(), ScanFormat::ThreeDtk, "1 2 3"),
                      Catch::Contains("3 numbers instead of six"));
    CHECK_FALSE(open_bytes(sample_3d(), ScanFormat::ThreeDtk)->clouds()[0].has_pose);
}

TEST_CASE("Intensities are spread over 16 bits by what they look like") {
    const auto coding = [](std::initializer_list<double> values) {
        ValueSampler sampler;
        for (const double v : values) sampler.add(v);
        return sampler.intensity_coding();
    };
    CHECK(coding({0.0, 0.3, 1.0}) == IntensityCoding{0.0, 1.0 / 65535.0});
    CHECK(coding({0.0, 4000.0}) == IntensityCoding{0.0, 1.0});
    CHECK(coding({-5.0, 2.0}) == IntensityCoding{-32768.0, 1.0});
    CHECK(coding({0.5, 200.5}) == IntensityCoding{0.0, 256.0 / 65535.0});
    CHECK(coding({-0.5, 3.5}) == IntensityCoding{-4.0, 8.0 / 65535.0});
}

TEST_CASE("A folder named by its date is the day") {
    CHECK(day_of_folder("/dig/2025-06-01/station1.ptx") == "2025-06-01");
    CHECK(day_of_folder("dig/2025-06-01 morning/faro/station1.ptx") == "2025-06-01");
    CHECK_FALSE(day_of_folder("dig/2025-13-01/station1.ptx"));
    CHECK_FALSE(day_of_folder("dig/2025-02-29/station1.ptx"));
    CHECK(day_of_folder("dig/2024-02-29/station1.ptx") == "2024-02-29");
    CHECK_FALSE(day_of_folder("2025-06-01.ptx"));
}

TEST_CASE("A file is known by its content before its ending, and a stranger is told the endings") {
    const TemporaryFolder folder;
    CHECK(open_file(folder.write("a.PTX", sample_ptx()))->info().format == ScanFormat::Ptx);
    CHECK(open_file(folder.write("b.xyz", sample_ply_ascii()))->info().format == ScanFormat::Ply);
    const auto tdtk = folder.write("c.3d", sample_3d());
    folder.write("c.pose", "1 2 3\n0 0 0\n");
    CHECK(open_file(tdtk)->clouds()[0].has_pose);
    CHECK_THROWS_WITH(open_file(folder.write("d.doc", "x")),
                      Catch::Contains("no scan format") && Catch::Contains(".e57"));
    CHECK_THROWS_WITH(open_file(folder / "missing.ptx"), Catch::Contains("missing.ptx"));
    CHECK_THROWS_WITH(open_file(folder.path()), Catch::Contains("not an ordinary file"));
}

TEST_CASE("What is wrong with a point names the file, once, as what is wrong with the header does") {
    const TemporaryFolder folder;
    const std::string cut_short = sample_pcd_compressed().substr(0, sample_pcd_compressed().size() - 3);
    const std::vector<std::pair<const char*, std::string>> damaged = {
        {"points.ptx", ptx_header(1, 2) + "1 2 3 0.5\n4 5 6\n"},
        {"points.pts", "2\n1 2 3\n4 x 6\n"},
        {"points.xyz", "1 2 3\n4 5 6\n7 8\n"},
        {"points.3d", "100 200 300\n-50 0\n"},
        {"points.pcd", cut_short},
    };
    for (const auto& [name, bytes] : damaged) {
        INFO(name);
        const auto file = folder.write(name, bytes);
        std::string said;
        try {
            const auto reader = open_file(file);
            read_whole(*reader);
        } catch (const Error& e) {
            CHECK(e.code() == ErrorCode::BadInput);
            said = e.what();
        }
        INFO(said);
        CHECK(said.rfind(file.string() + ": ", 0) == 0);
        CHECK(said.find(name) == said.rfind(name));
    }
}

TEST_CASE("Reading stops when the user says so") {
    std::stop_source stop;
    stop.request_stop();
    Progress progress(stop.get_token());
    try {
        static_cast<void>(open_scan(memory_source(sample_ptx()), ScanFormat::Ptx, {}, progress));
        FAIL("was not stopped");
    } catch (const Error& e) {
        CHECK(e.code() == ErrorCode::Cancelled);
    }
}
