// SPDX-License-Identifier: MIT
#include "app/surfaces/plan_sheet.hpp"

#include <algorithm>
#include <string>

#include "app/records/record_kind.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/measured_days.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;

namespace {

app::PlanSheet plan_with_cut(const test::TemporaryFolder& folder, bool colour) {
    app::Project project = test::make_measured_days(folder, folder / "site.gpkg");
    app::record_kind("unit").set(project, "2", {{"kind", "cut"}});
    app::PlanRequest request;
    request.surface = "2025-06-02";
    request.colour = colour;
    return app::plan_sheet(project, request, Progress::none());
}

const geometry::SheetKey* key_named(const geometry::MapSheet& sheet, const std::string& words) {
    const auto found = std::find_if(sheet.keys.begin(), sheet.keys.end(), [&](const geometry::SheetKey& key) {
        return key.text.find(words) != std::string::npos;
    });
    return found == sheet.keys.end() ? nullptr : &*found;
}

} // namespace

TEST_CASE("Dashes of a cut stay dashes where a solid line runs along the same edge") {
    const test::TemporaryFolder folder;
    const geometry::MapSheet sheet = plan_with_cut(folder, false).sheet;
    const auto dashed = std::find_if(sheet.shapes.begin(), sheet.shapes.end(), [](const geometry::SheetShape& shape) {
        return shape.look.dash == geometry::SheetDash::Dashed;
    });
    REQUIRE(dashed != sheet.shapes.end());
    REQUIRE(dashed != sheet.shapes.begin());
    const geometry::SheetLook& below = (dashed - 1)->look;
    CHECK(below.line == 0xffffffU);
    CHECK(below.dash == geometry::SheetDash::Solid);
    CHECK(below.width >= dashed->look.width);
    REQUIRE(key_named(sheet, "cut") != nullptr);
    CHECK(key_named(sheet, "cut")->look == dashed->look);
}

TEST_CASE("Over scan colour the legend shows units as they are drawn") {
    const test::TemporaryFolder folder;
    const geometry::MapSheet sheet = plan_with_cut(folder, true).sheet;
    for (const std::string kind : {"layer", "cut"}) {
        const geometry::SheetKey* key = key_named(sheet, kind);
        REQUIRE(key != nullptr);
        CHECK(key->look.opacity == 0.0);
        CHECK(std::any_of(sheet.shapes.begin(), sheet.shapes.end(),
                          [&](const geometry::SheetShape& shape) { return shape.look == key->look; }));
    }
    CHECK(key_named(sheet, "layer")->look.line != key_named(sheet, "cut")->look.line);
}

TEST_CASE("The legend of a plan says what the ground is that no scan saw") {
    const test::TemporaryFolder folder; // the frame goes 30 cm beyond what was scanned
    CHECK(key_named(plan_with_cut(folder, false).sheet, "no scan saw") != nullptr);
}
