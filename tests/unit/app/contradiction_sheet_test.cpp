// SPDX-License-Identifier: MIT
#include "app/checks/contradiction_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "app/checks/daily_check.hpp"
#include "app/records/record_kind.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/measured_days.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;

namespace {

// Unit 1 lay above 2 in the western half of the trench; the record says the opposite.
app::ContradictionSheet drawn_contradiction() {
    const test::TemporaryFolder folder;
    app::Project project = test::make_measured_days(folder, folder / "site.gpkg");
    app::record_kind("relation").add(project, "2 covers 1", {});
    for (const auto& problem : app::check_project(project, {}, Progress::none()).problems) {
        if (problem.code == "height-contradiction")
            return app::contradiction_sheet(project, problem.id, {}, Progress::none());
    }
    FAIL("no contradiction was found");
    return {};
}

bool has_key(const geometry::MapSheet& sheet, const std::string& words) {
    return std::any_of(sheet.keys.begin(), sheet.keys.end(),
                       [&](const geometry::SheetKey& key) { return key.text.find(words) != std::string::npos; });
}

} // namespace

TEST_CASE("Both faces of a contradiction lie whole in the plan, in a frame they fill") {
    const app::ContradictionSheet made = drawn_contradiction();
    REQUIRE(made.group.sheets.size() == 2);
    const geometry::MapSheet& plan = made.group.sheets[0].sheet;
    CHECK(plan.title == "Both faces in plan");
    geometry::Extent drawn;
    for (const geometry::SheetShape& shape : plan.shapes) drawn.add(geometry::extent(shape.shape));
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(plan.extent.low[k] < drawn.low[k]);
        CHECK(plan.extent.high[k] > drawn.high[k]);
        CHECK(drawn.high[k] - drawn.low[k] > 0.5 * (plan.extent.high[k] - plan.extent.low[k]));
    }
}

TEST_CASE("The cross-section of a contradiction ends a little beyond the faces") {
    const app::ContradictionSheet made = drawn_contradiction();
    const geometry::ScaledSheet& section = made.group.sheets.at(1);
    // Both faces are a square of a metre; a direction may run aslant.
    CHECK(section.sheet.extent.high[0] > 0.8);
    CHECK(section.sheet.extent.high[0] < std::sqrt(2.0) + 2.0 * 0.006 * 20.0);
    for (const geometry::SheetLine& line : made.group.sheets[0].sheet.lines) {
        for (const geometry::Point3& p : line.points) {
            CHECK(std::abs(p[0] - 0.5) < 0.7);
            CHECK(std::abs(p[1] - 0.5) < 0.7);
        }
    }
}

TEST_CASE("The legend of a contradiction holds what is drawn, with the area the text names") {
    const app::ContradictionSheet made = drawn_contradiction();
    const std::string area = fmt::format("{:.2f} m²", made.area);
    CHECK(made.group.text.find(area) != std::string::npos);
    CHECK(has_key(made.group.sheets.at(0).sheet, area));
    for (const geometry::ScaledSheet& sheet : made.group.sheets) {
        for (const geometry::SheetKey& key : sheet.sheet.keys) {
            const bool is_line = key.look.opacity == 0.0;
            const bool drawn =
                !is_line || std::any_of(sheet.sheet.lines.begin(), sheet.sheet.lines.end(),
                                        [&](const geometry::SheetLine& line) { return line.look == key.look; });
            INFO(key.text);
            CHECK(drawn);
        }
    }
}
