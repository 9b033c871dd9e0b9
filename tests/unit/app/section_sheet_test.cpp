// SPDX-License-Identifier: MIT
#include "app/surfaces/section_sheet.hpp"

#include <cstddef>
#include <cstdint>

#include "tests/support/catch.hpp"
#include "tests/support/measured_days.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;

namespace {

app::SectionRequest along_trench() {
    app::SectionRequest request;
    request.from = {0.0, 0.5};
    request.to = {2.0, 0.5};
    return request;
}

// Of the first pixel that shows anything.
geometry::SheetColour colour_of(const geometry::SheetPicture& picture) {
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
        if (picture.rgba[i + 3] != 0)
            return static_cast<geometry::SheetColour>(picture.rgba[i] << 16 | picture.rgba[i + 1] << 8 |
                                                      picture.rgba[i + 2]);
    }
    return 0;
}

} // namespace

TEST_CASE("Each surface has a tone of its own in a section through all, named in the key") {
    const test::TemporaryFolder folder;
    app::Project project = test::make_measured_days(folder, folder / "site.gpkg");
    app::SectionRequest request = along_trench();
    request.surfaces_apart = true;
    const geometry::MapSheet sheet = app::section_sheet(project, request, Progress::none()).sheet;
    REQUIRE(sheet.pictures.size() == 2);
    REQUIRE(sheet.keys.size() == 2);
    CHECK(sheet.keys[0].text == "2025-06-01");
    CHECK(sheet.keys[1].text == "2025-06-02");
    CHECK(sheet.keys[0].look.line != sheet.keys[1].look.line);
    for (std::size_t i = 0; i < 2; ++i) CHECK(colour_of(sheet.pictures[i]) == sheet.keys[i].look.line);
}

TEST_CASE("A section through one surface, or to draw on, is one picture without a key") {
    const test::TemporaryFolder folder;
    app::Project project = test::make_measured_days(folder, folder / "site.gpkg");
    app::SectionRequest request = along_trench();
    const app::SectionSheet to_draw_on = app::section_sheet(project, request, Progress::none());
    CHECK(to_draw_on.sheet.pictures.size() == 1);
    CHECK(to_draw_on.sheet.keys.empty());
    request.surfaces_apart = true;
    request.surface = "2025-06-02";
    const app::SectionSheet one = app::section_sheet(project, request, Progress::none());
    CHECK(one.sheet.pictures.size() == 1);
    CHECK(one.sheet.keys.empty());
    CHECK(one.points < to_draw_on.points);
}
