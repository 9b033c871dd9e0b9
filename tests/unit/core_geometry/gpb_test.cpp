// SPDX-License-Identifier: MIT
#include "core/geometry/gpb.hpp"

#include <limits>
#include <string_view>

#include "core/base/error.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using namespace planum::geometry;

namespace {

std::vector<std::byte> from_hex(std::string_view hex) {
    std::vector<std::byte> bytes;
    const auto digit = [](char c) { return static_cast<unsigned>(c <= '9' ? c - '0' : c - 'a' + 10); };
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
        bytes.push_back(static_cast<std::byte>(digit(hex[i]) * 16 + digit(hex[i + 1])));
    }
    return bytes;
}

Geometry with_hole() {
    const Line3 outer{{0, 0, 1}, {4, 0, 1}, {4, 4, 1.5}, {0, 4, 1}};
    const Line3 hole{{1, 1, 1}, {1, 2, 1}, {2, 2, 1}};
    return {25832, true, MultiPolygon{Rings{outer, hole}, Rings{{{9, 9, 0}, {10, 9, 0}, {9, 10, 0}}}}};
}

} // namespace

TEST_CASE("Points, lines and polygons come back as they were written") {
    const Geometry point{-1, true, Point3{1.25, -2.5, 103.75}};
    CHECK(decode_gpb(encode_gpb(point)) == point);
    const Geometry line{4326, true, Line3{{0, 0, 0}, {3, 4, 5}}};
    CHECK(decode_gpb(encode_gpb(line)) == line);
    CHECK(decode_gpb(encode_gpb(with_hole())) == with_hole());
}

TEST_CASE("Polygons without heights are written without z, as OGC 06-103 numbers them, and come back so") {
    const Geometry flat{-1, false, MultiPolygon{Rings{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}}}};
    const std::vector<std::byte> blob = encode_gpb(flat);
    CHECK(decode_gpb(blob) == flat);
    CHECK(blob.size() == encode_gpb({-1, true, flat.shape}).size() - 4 * sizeof(double));
    CHECK(blob[8 + 4 * sizeof(double) + 1] == std::byte{6}); // MULTIPOLYGON, behind header and envelope
}

TEST_CASE("An empty geometry stays empty") {
    const Geometry empty{-1, true, {}};
    CHECK(decode_gpb(encode_gpb(empty)) == empty);
    CHECK(decode_gpb(encode_gpb({-1, true, MultiPolygon{}})) == empty);
}

TEST_CASE("A big-endian point without z is read, and says that it has no z") {
    // 'GP', version 0, big-endian, srs 4326, then WKB: order 0, type 1, x = 1, y = 2.
    const auto blob = from_hex("47500000000010e600000000013ff00000000000004000000000000000");
    const Geometry expected{4326, false, Point3{1, 2, 0}};
    CHECK(decode_gpb(blob) == expected);
}

TEST_CASE("A measured point loses its measure and keeps its height") {
    // ISO type 3001: x = 1, y = 2, z = 3, m = 4.
    const auto blob = from_hex("47500001ffffffff01b90b0000000000000000f03f0000000000000040"
                               "00000000000008400000000000001040");
    const Geometry expected{-1, true, Point3{1, 2, 3}};
    CHECK(decode_gpb(blob) == expected);
}

TEST_CASE("A single polygon reads as a multipolygon of one") {
    // Type 1003 with one closed ring of four points.
    std::vector<std::byte> blob = encode_gpb({-1, true, MultiPolygon{Rings{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}});
    blob.erase(blob.begin() + 40, blob.begin() + 49); // the multipolygon's own head
    const Geometry expected{-1, true, MultiPolygon{Rings{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}};
    CHECK(decode_gpb(blob) == expected);
}

TEST_CASE("Every prefix of a geometry is refused, none is read beyond its end") {
    const auto blob = encode_gpb(with_hole());
    for (std::size_t length = 0; length < blob.size(); ++length) {
        INFO("length " << length);
        CHECK_THROWS_AS(decode_gpb(std::span{blob}.first(length)), Error);
    }
}

TEST_CASE("A count that the blob cannot hold is refused before memory is asked for") {
    const auto blob = from_hex("47500001ffffffff01ea030000ffffffff");
    CHECK_THROWS_AS(decode_gpb(blob), Error);
}

TEST_CASE("Coordinates that are not finite are neither written nor read") {
    const double infinite = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS(encode_gpb({-1, true, Point3{infinite, 0, 0}}), Error);
    CHECK_THROWS_AS(decode_gpb(from_hex("47500001ffffffff0101000000000000000000f07f0000000000000000")), Error);
}
