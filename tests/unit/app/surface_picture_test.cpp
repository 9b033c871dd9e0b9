// SPDX-License-Identifier: MIT
#include "app/surfaces/surface_picture.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/catch.hpp"

using namespace planum;

namespace {

geometry::SheetPicture picture_of(const std::vector<std::string>& rows) {
    geometry::SheetPicture picture;
    picture.width = static_cast<std::int32_t>(rows.front().size());
    picture.height = static_cast<std::int32_t>(rows.size());
    for (const std::string& row : rows) {
        for (const char c : row) {
            for (int k = 0; k < 3; ++k) picture.rgba.push_back(c == '#' ? 100 : 0);
            picture.rgba.push_back(c == '#' ? 255 : 0);
        }
    }
    return picture;
}

std::vector<std::string> rows_of(const geometry::SheetPicture& picture) {
    std::vector<std::string> rows(static_cast<std::size_t>(picture.height));
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
        rows[i / 4 / static_cast<std::size_t>(picture.width)] += picture.rgba[i + 3] != 0 ? '#' : '.';
    }
    return rows;
}

} // namespace

TEST_CASE("Closing fills what lies between seen pixels and leaves the outside clear") {
    auto picture = picture_of({"............", //
                               "............", //
                               "...##..##...", //
                               "............", //
                               "............"});
    app::close_holes(picture, 2);
    CHECK(rows_of(picture)[2] == "...######...");
    CHECK(rows_of(picture)[1] == "............");
    CHECK(rows_of(picture)[3] == "............");
    CHECK(picture.rgba[4 * (2 * 12 + 5)] == 100);

    auto far_apart = picture_of({"..#........#.."});
    app::close_holes(far_apart, 2);
    CHECK(rows_of(far_apart) == std::vector<std::string>{"..#........#.."});
}

TEST_CASE("Closing a hole in a face fills it whole") {
    auto picture = picture_of({"######", "##..##", "##..##", "######"});
    app::close_holes(picture, 1);
    for (const std::string& row : rows_of(picture)) CHECK(row == "######");
}
