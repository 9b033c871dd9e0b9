// SPDX-License-Identifier: MIT
#include "app/surfaces/height_change.hpp"

#include <cmath>

#include "app/surfaces/recorded_surface.hpp"
#include "core/base/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/measured_days.hpp"

using namespace planum;

TEST_CASE("The change between two surfaces is given cell by cell, and says the same as its report") {
    const test::TemporaryFolder folder;
    app::Project project = test::make_measured_days(folder, folder / "site.gpkg");
    const auto& surfaces = project.record().surfaces;
    REQUIRE(surfaces.size() == 2);
    const app::HeightChange change = app::height_change(project, surfaces[0].id, surfaces[1].id, Progress::none());
    REQUIRE(change.change.size() == static_cast<std::size_t>(change.columns) * static_cast<std::size_t>(change.rows));
    REQUIRE(change.detectable.size() == change.change.size());
    const auto at = [&](double x, double y) {
        const auto column = static_cast<std::size_t>(std::floor((x - change.low_x) / change.cell));
        const auto row = static_cast<std::size_t>(std::floor((y - change.low_y) / change.cell));
        return static_cast<double>(change.change.at(row * static_cast<std::size_t>(change.columns) + column));
    };
    CHECK(change.cell == Approx(0.02));
    CHECK(at(0.5, 0.5) == Approx(-0.12).margin(1e-4));
    CHECK(at(1.5, 0.5) == Approx(0.0).margin(1e-4));
    CHECK(std::isnan(at(-0.3, 0.5)));
    CHECK(change.report.before == "2025-06-01");
    CHECK(change.report.after == "2025-06-02");
    const app::ChangeReport written =
        app::write_change(project, "2025-06-01", "2025-06-02", 0.02, {}, Progress::none());
    CHECK(written.lowered_area == Approx(change.report.lowered_area));
    CHECK(written.detectable == Approx(change.report.detectable));
}

TEST_CASE("Surfaces of two areas, and those that are gone, are not compared") {
    const test::TemporaryFolder folder;
    app::Project project = test::make_measured_days(folder, folder / "site.gpkg");
    const model::SurfaceId first = project.record().surfaces.front().id;
    CHECK_THROWS_AS(app::height_change(project, first, {}, Progress::none()), Error);
    app::record_kind("area").add(project, "B", {});
    app::record_kind("surface").add(project, "other", {{"area", "B"}, {"first-day", "2025-06-03"}});
    const model::SurfaceId other = app::known_surface(project.record(), "other").id;
    CHECK_THROWS_AS(app::height_change(project, first, other, Progress::none()), Error);
}
