// SPDX-License-Identifier: MIT
// Every scan beside the repository, skipped by name where it is absent.
#include <fstream>
#include <iterator>

#include "scans/formats/scan_reader.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/read_scan.hpp"
#include "tests/support/real_data.hpp"

using namespace planum;
using namespace planum::scans;
using planum::test::open_file;
using planum::test::read_whole;

namespace {

// Where the data are absent a case has nothing to check, and says so.
std::optional<std::filesystem::path> real_data(std::string_view name) {
    SUCCEED("looked for " << name);
    return planum::test::real_data(name);
}

std::string refused(const std::filesystem::path& file) {
    try {
        const auto reader = open_file(file);
        for (std::size_t i = 0; i < reader->clouds().size(); ++i) read_whole(*reader, i);
    } catch (const Error& e) {
        CHECK(e.code() == ErrorCode::BadInput);
        return e.what();
    }
    return {};
}

void check_bounds(const Bounds& found, const Bounds& stated, double within) {
    for (std::size_t i = 0; i < 3; ++i) {
        INFO("axis " << i);
        CHECK(found.minimum[i] == Approx(stated.minimum[i]).margin(within));
        CHECK(found.maximum[i] == Approx(stated.maximum[i]).margin(within));
    }
}

} // namespace

TEST_CASE("pumpA reads with its grid, colour, 15-bit intensity and image") {
    const auto file = real_data("scans/e57/pye57_pumpAVisualReferenceImage.e57");
    if (!file) return;
    const auto reader = open_file(*file);
    REQUIRE(reader->clouds().size() == 1);
    const CloudHeader& header = reader->clouds()[0];
    CHECK(header.records == 155201);
    CHECK(header.rows == 1074);
    CHECK(header.columns == 345);
    CHECK(header.name == "pumpA");
    CHECK(header.has == Columns{true, true, true, false});
    CHECK(header.intensity.scale == Approx(3.0518509475997192e-005));
    const auto whole = read_whole(*reader, 0, Misses::Keep);
    CHECK(whole.summary.records == 155201);
    CHECK(whole.summary.clamped == 0);
    CHECK(whole.points.size() == 155201);
    check_bounds(whole.summary.bounds, *header.stated_bounds, 1e-9);
    CHECK(*std::max_element(whole.points.intensity.begin(), whole.points.intensity.end()) > 255);
    CHECK(*std::max_element(whole.points.intensity.begin(), whole.points.intensity.end()) <= 32767);
    CHECK(*std::max_element(whole.points.row.begin(), whole.points.row.end()) <= 1073);
    CHECK(*std::max_element(whole.points.column.begin(), whole.points.column.end()) == 344);
    REQUIRE(reader->info().images.size() == 1);
    CHECK(reader->info().images[0].width == 3072);
    const std::string image = reader->read_image(0);
    CHECK(image.size() == 1504576);
    CHECK(image.substr(0, 2) == "\xFF\xD8");
    CHECK(reader->info().created_at.substr(0, 4) == "2011");
}

TEST_CASE("Both bunnies have the bounds that their XML states") {
    for (const char* name : {"scans/e57/asm_bunnyDouble.e57", "scans/e57/asm_bunnyInt32.e57"}) {
        const auto file = real_data(name);
        if (!file) return;
        const auto reader = open_file(*file);
        const auto whole = read_whole(*reader);
        CHECK(whole.summary.valid == 30571);
        check_bounds(whole.summary.bounds, *reader->clouds()[0].stated_bounds, 1e-9);
    }
}

TEST_CASE("Coloured cubes have the same points as float and as double") {
    const auto first = real_data("scans/e57/asm_ColouredCubeDouble.e57");
    const auto second = real_data("scans/e57/asm_ColouredCubeFloat.e57");
    if (!first || !second) return;
    const auto a = read_whole(*open_file(*first));
    const auto b = read_whole(*open_file(*second));
    REQUIRE(a.points.size() == 7680);
    CHECK(a.points.colour == b.points.colour);
    check_bounds(a.summary.bounds, {{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}, 1e-6);
    check_bounds(b.summary.bounds, a.summary.bounds, 1e-6);
}

TEST_CASE("16-bit colours of an E57 become 8 bits by the range of their type") {
    const auto file = real_data("scans/e57/asm_ColourRepresentation.e57");
    if (!file) return;
    const auto reader = open_file(*file);
    const auto whole = read_whole(*reader);
    CHECK(whole.points.size() == 153);
    CHECK(whole.summary.clamped == 0);
    check_bounds(whole.summary.bounds, *reader->clouds()[0].stated_bounds, 1e-9);
}

TEST_CASE("Spherical coordinates become cartesian ones") {
    const auto file = real_data("scans/e57/cryinc_tiny_spherical.e57");
    if (!file) return;
    const auto whole = read_whole(*open_file(*file));
    CHECK(whole.summary.records == 360);
    CHECK(whole.summary.misses == 180);
    for (std::size_t i = 0; i < whole.points.size(); ++i) {
        const double range = std::hypot(whole.points.x[i], whole.points.y[i], whole.points.z[i]);
        CHECK(range == Approx(1.0));
    }
}

TEST_CASE("Several scans with poses come out of one E57 file") {
    const auto file = real_data("scans/e57/pdal_A_B.e57");
    if (!file) return;
    const auto reader = open_file(*file);
    REQUIRE(reader->clouds().size() == 2);
    CHECK(reader->clouds()[0].records == 2);
    CHECK(reader->clouds()[1].records == 4);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto whole = read_whole(*reader, i);
        check_bounds(whole.summary.bounds, *reader->clouds()[i].stated_bounds, 1e-5);
    }
}

TEST_CASE("A moved scan states where it was moved to") {
    const auto still = real_data("scans/e57/pdal_A4.e57");
    const auto moved = real_data("scans/e57/pdal_A4_moved.e57");
    if (!still || !moved) return;
    const auto a = open_file(*still);
    const auto b = open_file(*moved);
    CHECK(read_whole(*a).summary.valid == 4);
    CHECK(read_whole(*b).summary.valid == 4);
}

TEST_CASE("E57 files without points or scans are read as such") {
    for (const char* name : {"scans/e57/asm_ZeroPoints.e57", "scans/e57/asm_ZeroPointsInvalid.e57"}) {
        const auto file = real_data(name);
        if (!file) return;
        const auto reader = open_file(*file);
        REQUIRE(reader->clouds().size() == 1);
        CHECK(read_whole(*reader).summary.records == 0);
    }
    if (const auto file = real_data("scans/e57/asm_empty.e57")) CHECK(open_file(*file)->clouds().empty());
    if (const auto file = real_data("scans/e57/asm_PinholeImageWithDistortionParameters.e57")) {
        const auto reader = open_file(*file);
        REQUIRE(!reader->info().images.empty());
        CHECK(reader->read_image(0).size() == 375);
    }
}

TEST_CASE("Damaged E57 files are refused with the page or place named") {
    if (const auto file = real_data("scans/e57/asm_bad-crc.e57")) {
        CHECK_THAT(refused(*file), Catch::Contains("page 0 of 1"));
    }
    if (const auto file = real_data("scans/e57/asm_InvalidCVHeader.e57")) {
        CHECK_THAT(refused(*file), Catch::Contains("scan 1") && Catch::Contains("byte 48"));
    }
}

TEST_CASE("LAS 1.2 reads with intensity, colour and time") {
    const auto coloured = real_data("scans/las/pdal_1.2-with-color.las");
    const auto simple = real_data("scans/las/pdal_simple.las");
    if (!coloured || !simple) return;
    const auto a = open_file(*coloured);
    const auto whole = read_whole(*a);
    CHECK(whole.points.size() == 1065);
    check_bounds(whole.summary.bounds, *a->clouds()[0].stated_bounds, 1e-6);
    CHECK(whole.points.colour[0] == Rgb{68, 77, 88});
    CHECK(whole.points.intensity[0] == 143);
    CHECK(whole.points.x[0] == Approx(637012.24));
    const auto b = read_whole(*open_file(*simple));
    CHECK(b.points.size() == 1065);
    CHECK(b.points.time.size() == 1065);
}

TEST_CASE("PTX samples read with grid, colour and pose") {
    if (const auto file = real_data("scans/ptx_pts/pdal_1.2-with-color.ptx")) {
        const auto reader = open_file(*file);
        REQUIRE(reader->clouds().size() == 1);
        CHECK(reader->clouds()[0].columns == 15);
        CHECK(reader->clouds()[0].rows == 71);
        const auto whole = read_whole(*reader);
        CHECK(whole.summary.valid == 1065);
        CHECK(whole.points.colour[0] == Rgb{68, 77, 88});
    }
    if (const auto file = real_data("scans/ptx_pts/pdal_complex-transform.ptx")) {
        const auto reader = open_file(*file);
        const auto whole = read_whole(*reader);
        CHECK(whole.summary.records == 12);
        CHECK(whole.summary.misses == 8);
        const Eigen::Vector3d site = reader->clouds()[0].site_from_scan *
                                     Eigen::Vector3d(whole.points.x[0], whole.points.y[0], whole.points.z[0]);
        // -0.00563 0.645218 -0.440506 by the matrix in the file, by hand.
        CHECK(site.x() == Approx(-3.034408).margin(1e-4));
        CHECK(site.y() == Approx(-3.173774).margin(1e-4));
        CHECK(site.z() == Approx(-1.823750).margin(1e-4));
    }
    if (const auto file = real_data("scans/ptx_pts/pdal_no-color.ptx")) {
        CHECK(read_whole(*open_file(*file)).points.colour.empty());
    }
}

TEST_CASE("Several clouds of one PTX stand on the same place, a stretching matrix included") {
    const auto file = real_data("scans/ptx_pts/pdal_multiple-and-transform.ptx");
    if (!file) return;
    const auto reader = open_file(*file);
    REQUIRE(reader->clouds().size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto whole = read_whole(*reader, i);
        REQUIRE(whole.points.size() == 4);
        const Eigen::Vector3d site = reader->clouds()[i].site_from_scan *
                                     Eigen::Vector3d(whole.points.x[0], whole.points.y[0], whole.points.z[0]);
        CHECK(site.x() == Approx(637012.24).margin(1e-6));
        CHECK(site.y() == Approx(849028.31).margin(1e-6));
        CHECK(site.z() == Approx(431.66).margin(1e-6));
    }
}

TEST_CASE("The simulated trench reads with the pose of its header") {
    const auto file = real_data("scans/trench/2012-05-01/station0.ptx");
    const auto truth = real_data("scans/trench/2012-05-01/station0.true_site_from_scan.txt");
    if (!file || !truth) return;
    const auto reader = open_file(*file);
    CHECK(reader->clouds()[0].columns == 720);
    CHECK(reader->clouds()[0].rows == 194);
    std::ifstream in(*truth);
    for (int r = 0; r < 4; ++r) {
        for (int c = 0; c < 4; ++c) {
            double value = 0.0;
            in >> value;
            CHECK(reader->clouds()[0].site_from_scan.matrix()(r, c) == Approx(value).margin(2e-6));
        }
    }
    const auto whole = read_whole(*reader);
    CHECK(whole.summary.records == 720 * 194);
    CHECK(whole.summary.valid > 90000);
    CHECK(day_of_folder(*file) == "2012-05-01");
}

TEST_CASE("PTS samples read with their columns") {
    if (const auto file = real_data("scans/ptx_pts/pdal_autzen.pts")) {
        const auto reader = open_file(*file);
        const auto whole = read_whole(*reader);
        CHECK(whole.points.size() == 10);
        CHECK(reader->clouds()[0].intensity.value(whole.points.intensity[0]) == -1613.0);
        CHECK(whole.points.colour[0] == Rgb{52, 70, 64});
    }
    if (const auto file = real_data("scans/ptx_pts/pdal_bunny_8.pts")) {
        const auto reader = open_file(*file); // states 8 points, has 9
        CHECK(read_whole(*reader).points.size() == 9);
        CHECK_THAT(reader->clouds()[0].notes.at(0), Catch::Contains("states 8 points"));
    }
    if (const auto file = real_data("scans/ptx_pts/pdal_site_56_8.pts")) {
        CHECK(read_whole(*open_file(*file)).points.intensity.size() == 8);
    }
    if (const auto file = real_data("scans/ptx_pts/pdal_test.pts")) {
        CHECK(read_whole(*open_file(*file)).points.size() == 19);
    }
}

TEST_CASE("A PLY pair and CSV tables read with intensity") {
    if (const auto file = real_data("scans/pairs/small_gicp_source.ply")) {
        const auto whole = read_whole(*open_file(*file));
        CHECK(whole.points.size() == 69792);
        CHECK(whole.points.intensity.size() == 69792);
        CHECK(whole.summary.clamped == 0);
    }
    if (const auto file = real_data("scans/m3c2/autzen-bmx-largersample.txt")) {
        const auto reader = open_file(*file);
        CHECK(reader->clouds()[0].has == Columns{true, true, false, true});
        CHECK(read_whole(*reader).points.x[0] == 194506.86);
        CHECK_THAT(reader->info().column_guess, Catch::Contains("by the names"));
    }
}

TEST_CASE("3DTK scans come out in metres, right-handed and z up, and their poses bring them together") {
    std::vector<Eigen::Vector3d> mean;
    for (const char* name : {"scans/3dtk/scan000.3d", "scans/3dtk/scan001.3d", "scans/3dtk/scan002.3d"}) {
        const auto file = real_data(name);
        if (!file) return;
        const auto reader = open_file(*file);
        CHECK(reader->clouds()[0].has_pose);
        CHECK(read_whole(*reader).points.size() == 81360);
        CHECK(reader->clouds()[0].site_from_scan.linear().determinant() == Approx(1.0));
        mean.push_back(reader->clouds()[0].site_from_scan.translation());
    }
    // The second scan stands 1.57 m further forward: z in cm there, x in m here.
    CHECK(mean[1].x() == Approx(1.56917));
    CHECK(mean[1].y() == Approx(0.0310605));
    CHECK(mean[1].z() == Approx(-0.0750803));
}
