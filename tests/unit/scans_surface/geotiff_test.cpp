// SPDX-License-Identifier: MIT
#include "scans/surface/geotiff.hpp"

#include <array>
#include <cstring>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using namespace planum::scans;

namespace {

template<class Value>
Value at(const std::string& bytes, std::size_t place) {
    Value value;
    REQUIRE(place + sizeof(Value) <= bytes.size());
    std::memcpy(&value, bytes.data() + place, sizeof(Value));
    return value;
}

/// Tag → (type, count, value or place), in the order of the file.
std::map<std::uint16_t, std::array<std::uint32_t, 3>> tags_of(const std::string& tiff) {
    std::map<std::uint16_t, std::array<std::uint32_t, 3>> tags;
    const auto directory = at<std::uint32_t>(tiff, 4);
    std::uint16_t last = 0;
    for (std::size_t i = 0; i < at<std::uint16_t>(tiff, directory); ++i) {
        const std::size_t entry = directory + 2 + 12 * i;
        const auto tag = at<std::uint16_t>(tiff, entry);
        CHECK(tag > last);
        last = tag;
        tags[tag] = {at<std::uint16_t>(tiff, entry + 2), at<std::uint32_t>(tiff, entry + 4),
                     at<std::uint32_t>(tiff, entry + 8)};
    }
    return tags;
}

const GridFrame kFrame{100, -50, 3, 2, 0.02};
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
const std::vector<float> kHeights = {1.0F, 2.0F, 3.0F, 4.0F, kUnknown, 6.0F};
const std::vector<float> kErrors = {0.1F, 0.2F, 0.3F, 0.4F, kUnknown, 0.6F};

} // namespace

TEST_CASE("A raster of heights says where it lies and has north on top") {
    const std::string tiff = geotiff(kFrame, std::vector<RasterBand>{{"height", kHeights}}, 25832);
    CHECK(tiff.substr(0, 4) == std::string("II*\0", 4));
    auto tags = tags_of(tiff);
    CHECK(tags[256][2] == 3);
    CHECK(tags[257][2] == 2);
    CHECK(tags[258][2] == 32);
    CHECK(tags[339][2] == 3);
    CHECK(at<double>(tiff, tags[33550][2]) == 0.02);
    CHECK(at<double>(tiff, tags[33922][2] + 24) == Approx(2.0));   // west
    CHECK(at<double>(tiff, tags[33922][2] + 32) == Approx(-0.96)); // north
    CHECK(tags[34735][1] == 20);
    CHECK(at<std::uint16_t>(tiff, tags[34735][2] + 24 + 0) == 3072);
    CHECK(at<std::uint16_t>(tiff, tags[34735][2] + 24 + 6) == 25832);
    CHECK(tags[279][2] == 24);
    const std::size_t data = tags[273][2];
    CHECK(data + 24 == tiff.size());
    const float expected[] = {4.0F, -9999.0F, 6.0F, 1.0F, 2.0F, 3.0F};
    for (std::size_t i = 0; i < 6; ++i) CHECK(at<float>(tiff, data + 4 * i) == expected[i]);
}

TEST_CASE("Bands of a raster lie one after the other, each with its name") {
    const std::string tiff = geotiff(kFrame, std::vector<RasterBand>{{"change", kHeights}, {"detectable", kErrors}}, 0);
    auto tags = tags_of(tiff);
    CHECK(tags[277][2] == 2);
    CHECK(tags[284][2] == 2);
    CHECK(tags[258][1] == 2);
    const std::array strips = {at<std::uint32_t>(tiff, tags[273][2]), at<std::uint32_t>(tiff, tags[273][2] + 4)};
    CHECK(at<float>(tiff, strips[0]) == 4.0F);
    CHECK(at<float>(tiff, strips[1]) == 0.4F);
    CHECK(strips[1] + 24 == tiff.size());
    CHECK(tiff.find(R"(sample="1" role="description">detectable<)") != std::string::npos);
    CHECK_THROWS_AS(geotiff(kFrame, {}, 0), Error);
    CHECK_THROWS_AS(geotiff(kFrame, std::vector<RasterBand>{{"short", std::span(kErrors).first(3)}}, 0), Error);
}

TEST_CASE("A world file gives the centre of the north-western cell") {
    CHECK(world_file(kFrame) == "0.02\n0\n0\n-0.02\n2.010000\n-0.970000\n");
}
