// SPDX-License-Identifier: MIT
#include "gui/viewmodels/difference_model.hpp"

#include <cmath>
#include <limits>

#include "gui/viewmodels/time_model.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"
#include "tests/support/measured_days.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

// Two days of a floor: what covered its western half, 12 cm thick, is gone on the second.
struct Days {
    test::TemporaryFolder folder;
    Workspace workspace{app::Session{"Ada"}};
    TimeModel time{workspace};
    DifferenceModel difference{workspace, time};

    Days() {
        test::ensure_core_application();
        static_cast<void>(test::make_measured_days(folder, folder / "site.gpkg"));
        workspace.open(folder / "site.gpkg", store::OpenMode::ReadWrite);
        settle(workspace);
    }

    [[nodiscard]] std::uint32_t at(double x, double y) const {
        const GroundColours& ground = *difference.colours();
        const auto column = static_cast<std::size_t>(std::floor((x - ground.low_x) / ground.cell));
        const auto row = static_cast<std::size_t>(std::floor((y - ground.low_y) / ground.cell));
        return ground.rgb.at(row * static_cast<std::size_t>(ground.columns) + column);
    }
};

unsigned red(std::uint32_t rgb) { return (rgb >> 16U) & 0xffU; }

unsigned blue(std::uint32_t rgb) { return rgb & 0xffU; }

bool is_grey(std::uint32_t rgb) { return red(rgb) == blue(rgb) && rgb != 0; }

} // namespace

TEST_CASE("A surface is compared with the one before: lower ground is orange, ground that stayed grey") {
    Days days;
    CHECK(days.difference.colours() == nullptr); // nobody looks
    days.difference.set_watched(true);
    settle(days.workspace);
    REQUIRE(days.difference.colours() != nullptr);
    CHECK(red(days.at(0.5, 0.5)) > blue(days.at(0.5, 0.5)));
    CHECK(is_grey(days.at(1.5, 0.5)));
    CHECK(days.at(-0.4, 0.5) == 0); // nobody saw it
    const DifferenceKey& key = days.difference.key();
    CHECK(key.span == Approx(0.2)); // the round number above 12 cm
    CHECK(key.detectable > 0.0);
    CHECK(key.detectable < 0.1);
    CHECK(key.lower.contains(QStringLiteral("2025-06-01")));
    CHECK_FALSE(key.summary.isEmpty());
    CHECK(days.difference.said().isEmpty());
}

TEST_CASE("The first surface is compared with the one after: what lay on it is blue") {
    Days days;
    days.difference.set_watched(true);
    days.time.go_to(0);
    settle(days.workspace);
    REQUIRE(days.difference.colours() != nullptr);
    CHECK(blue(days.at(0.5, 0.5)) > red(days.at(0.5, 0.5)));
    CHECK(is_grey(days.at(1.5, 0.5)));
    CHECK(days.difference.choices().size() == 1);
    CHECK(days.difference.other() == days.time.stops()[1].surface);
}

TEST_CASE("An edit of the record compares nothing again; a surface alone says that there is none to compare with") {
    Days days;
    days.difference.set_watched(true);
    settle(days.workspace);
    const auto before = days.difference.colours();
    days.workspace.edit(QStringLiteral("another unit"),
                        [](app::Project& project, Progress&) { app::record_kind("unit").add(project, "9", {}); });
    settle(days.workspace);
    CHECK(days.difference.colours() == before);
    days.workspace.close();
    CHECK(days.difference.colours() == nullptr);

    test::GuiProject bare;
    days.workspace.open(bare.file, store::OpenMode::ReadOnly);
    settle(days.workspace);
    CHECK(days.difference.colours() == nullptr);
    CHECK_FALSE(days.difference.said().isEmpty());
    CHECK(days.difference.choices().empty());
}

TEST_CASE("Colours grow stronger up to the span; below the level of detection all is the same grey") {
    CHECK(difference_colour(0.01, 0.02, 0.3) == difference_colour(-0.02, 0.02, 0.3));
    CHECK(is_grey(difference_colour(0.0, 0.02, 0.3)));
    CHECK(difference_colour(0.3, 0.02, 0.3) == difference_colour(2.0, 0.02, 0.3));
    CHECK(red(difference_colour(0.05, 0.02, 0.3)) > red(difference_colour(0.25, 0.02, 0.3))); // paler
    for (const double change : {-9.0, -0.1, 0.0, 0.1, 9.0}) CHECK(difference_colour(change, 0.02, 0.3) != 0);
}

TEST_CASE("The strongest colours stand for a round number that a few strays do not move") {
    app::HeightChange change;
    change.columns = 200;
    change.rows = 1;
    change.change.assign(200, -0.12F);
    change.detectable.assign(200, 0.02F);
    change.change[7] = 4.0F;
    change.change[8] = kNone;
    CHECK(difference_span(change) == Approx(0.2));
    change.change.assign(200, 0.001F);
    CHECK(difference_span(change) == Approx(0.02)); // nothing that can be detected
    change.change.assign(200, kNone);
    CHECK(difference_span(change) == Approx(0.02));
}

TEST_CASE("A very wide difference is drawn with cells left out") {
    app::HeightChange change;
    change.columns = 7000;
    change.rows = 2;
    change.cell = 0.02;
    change.change.assign(14000, 0.5F);
    change.detectable.assign(14000, 0.02F);
    const GroundColours colours = colours_of(change, 1.0);
    CHECK(colours.columns <= 3000);
    CHECK(colours.cell * colours.columns >= 140.0);
    CHECK(colours.rgb.size() == static_cast<std::size_t>(colours.columns) * static_cast<std::size_t>(colours.rows));
}
