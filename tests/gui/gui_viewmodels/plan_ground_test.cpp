// SPDX-License-Identifier: MIT
#include "gui/viewmodels/plan_ground.hpp"

#include <algorithm>
#include <cmath>

#include "gui/viewmodels/models.hpp"
#include "gui/viewmodels/panorama_model.hpp"
#include "gui/viewmodels/space_model.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"
#include "tests/support/measured_days.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

namespace {

// Two scanned days of a floor of 2 × 1 m at 5.0 m, whose western half lies at 5.12 m on the first day; the outlines of
// the project have no heights.
struct Drawing {
    test::TemporaryFolder folder;
    Models models{app::Session{"Ada"}};
    QStringList failures;

    Drawing() {
        test::ensure_core_application();
        QObject::connect(&models.workspace, &Workspace::failed, [this](const QString& s) { failures << s; });
        test::make_measured_days(folder, folder / "site.gpkg");
        models.workspace.open(folder / "site.gpkg", store::OpenMode::ReadWrite);
        settle(models.workspace);
        models.time.go_to(0);
    }

    [[nodiscard]] const model::Record& record() const { return models.workspace.snapshot()->record(); }

    void draw(const char* unit, const PointList& corners) {
        OutlineTool& tool = models.outline;
        tool.begin(QStringLiteral("plan"), plan_ground(models.time.surface()));
        tool.set_unit(QString::fromLatin1(unit));
        for (const QPointF& p : corners) tool.add(p);
        tool.finish();
        settle(models.workspace);
    }

    [[nodiscard]] const model::Region& region_of(const char* unit) const {
        const auto& regions = record().regions;
        const auto found = std::find_if(regions.begin(), regions.end(), [&](const model::Region& region) {
            return region.surface == models.time.surface() &&
                   models.workspace.snapshot()->index().name(region.unit) == unit;
        });
        if (found == regions.end()) throw std::runtime_error("no region of that unit");
        return *found;
    }
};

double height_at(const model::Ring& ring, double x, double y) {
    for (const auto& p : ring) {
        if (std::hypot(p[0] - x, p[1] - y) < 1e-6) return p[2];
    }
    return -1.0;
}

} // namespace

TEST_CASE("An outline drawn in plan has the heights of its surface, and follows the step that it crosses") {
    Drawing d;
    d.draw("7", {{0.5, 0.2}, {1.5, 0.2}, {1.5, 0.8}, {0.5, 0.8}});
    CHECK(d.failures.isEmpty());
    const model::Region& region = d.region_of("7");
    REQUIRE(region.has_heights);
    const model::Ring& ring = region.outline.front().outer;
    CHECK(height_at(ring, 0.5, 0.2) == Approx(5.12));
    CHECK(height_at(ring, 1.5, 0.8) == Approx(5.0));
    const auto below_step =
        std::count_if(ring.begin(), ring.end(), [](const auto& p) { return p[0] > 0.6 && p[0] < 1.4; });
    CHECK(below_step >= 4); // either side of the step, in both lines that cross it
    SpaceModel space(d.models.workspace, d.models.time);
    const auto outlines = space.outlines();
    CHECK(std::count_if(outlines.begin(), outlines.end(), [&](const auto& one) { return one.unit == region.unit; }) ==
          1);
}

TEST_CASE("Beyond the scans an outline takes the heights of its neighbours; without scans it has none, and says so") {
    Drawing d;
    d.draw("7", {{1.5, 0.2}, {9.0, 0.2}, {9.0, 0.8}});
    const model::Region& region = d.region_of("7");
    REQUIRE(region.has_heights);
    CHECK(height_at(region.outline.front().outer, 9.0, 0.8) == Approx(5.0));
    d.draw("8", {{20.0, 20.0}, {21.0, 20.0}, {21.0, 21.0}});
    CHECK_FALSE(d.region_of("8").has_heights);
    CHECK(d.failures.isEmpty());
}

TEST_CASE(
    "An outline without heights is not in 3D; a corner moved in plan gives it those of the ground, one undo step") {
    Drawing d;
    REQUIRE_FALSE(d.region_of("1").has_heights);
    const model::Region before = d.region_of("1");
    SpaceModel space(d.models.workspace, d.models.time);
    CHECK(space.outlines().empty());
    OutlineEdit& edit = d.models.edit;
    edit.begin(QStringLiteral("plan"), plan_edit_ground(d.models.time.surface()));
    edit.choose(before.id);
    const auto corner = edit.corner_at({1.0, 1.0}, 0.05);
    REQUIRE(corner);
    edit.grab(*corner);
    edit.move({0.8, 0.8});
    edit.finish();
    settle(d.models.workspace);
    CHECK(d.failures.isEmpty());
    const model::Region& after = d.region_of("1");
    REQUIRE(after.has_heights);
    CHECK(height_at(after.outline.front().outer, 0.8, 0.8) == Approx(5.12));
    CHECK(height_at(after.outline.front().outer, 0.0, 0.0) == Approx(5.12));
    CHECK(space.outlines().size() == 1);
    d.models.workspace.undo();
    settle(d.models.workspace);
    CHECK(d.region_of("1") == before);
}

TEST_CASE("On a site whose datum is 0 an outline at 0 is seen in 3D") {
    Drawing d;
    {
        app::Project other = app::Project::open(d.folder / "site.gpkg", store::OpenMode::ReadWrite, {"Bob"});
        app::record_kind("region").set(other, "2025-06-01/3#1", {{"outline", "1 0 0, 2 0 0, 2 1 0.1, 1 1 0"}});
        app::record_kind("region").set(other, "2025-06-01/1#1", {{"outline", "0 0 0, 1 0 0, 1 1 0, 0 1 0"}});
    }
    d.models.workspace.open(d.folder / "site.gpkg", store::OpenMode::ReadWrite);
    settle(d.models.workspace);
    d.models.time.go_to(0);
    SpaceModel space(d.models.workspace, d.models.time);
    CHECK(space.outlines().size() == 2);
}

TEST_CASE("On a panorama an outline without heights has no corners to take hold of") {
    Drawing d;
    PanoramaModel panorama(d.models.workspace, d.models.time);
    panorama.set_watched(true);
    panorama.set_scan(panorama.scans().front());
    settle(d.models.workspace);
    REQUIRE(panorama.loaded());
    CHECK(panorama.shapes().empty());
    const EditGround ground = panorama.edit_ground();
    REQUIRE(ground.to_view);
    CHECK_FALSE(ground.to_view({0.5, 0.5, std::nan("")}));
    CHECK(ground.to_view({0.5, 0.5, 5.12}));
    d.draw("7", {{0.5, 0.2}, {1.5, 0.2}, {1.5, 0.8}, {0.5, 0.8}});
    CHECK(panorama.shapes().size() == 1);
    OutlineEdit& edit = d.models.edit;
    edit.begin(QStringLiteral("panorama"), panorama.edit_ground());
    edit.choose(d.region_of("7").id);
    REQUIRE_FALSE(edit.rings().empty());
    CHECK(std::any_of(edit.rings().front().begin(), edit.rings().front().end(), [](const auto& c) { return c.seen; }));
}
