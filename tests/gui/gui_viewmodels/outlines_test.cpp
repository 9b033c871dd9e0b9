// SPDX-License-Identifier: MIT
#include "gui/viewmodels/outline_tool.hpp"

#include <cmath>

#include "gui/viewmodels/models.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

namespace {

OutlineTool::ToOutlines on_day(const std::string& day) {
    return [day](app::Project&, const app::DrawnOutline& labels, const PointList& corners, Progress&) {
        app::DrawnOutline outline = labels;
        outline.day = day;
        outline.area = "A";
        geometry::Line3 ring;
        for (const QPointF& p : corners) ring.push_back({p.x(), p.y(), 10.0});
        outline.shape = {{ring}};
        return app::OutlineFile{{outline}, {}};
    };
}

struct Drawing {
    test::GuiProject site;
    Models models{app::Session{"Ada"}};
    QStringList failures;

    Drawing() {
        QObject::connect(&models.workspace, &Workspace::failed, [this](const QString& s) { failures << s; });
        models.workspace.open(site.file, store::OpenMode::ReadWrite);
        settle(models.workspace);
    }

    void draw(const std::string& day, const char* unit, const PointList& corners) {
        OutlineTool& tool = models.outline;
        tool.begin(QStringLiteral("plan"), on_day(day));
        tool.set_unit(QString::fromLatin1(unit));
        for (const QPointF& p : corners) tool.add(p);
        tool.finish();
        settle(models.workspace);
    }
};

PointList square(double x, double y, double side) {
    return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

} // namespace

TEST_CASE("A drawn outline is a region of its surface, named after its unit, and one undo step") {
    Drawing d;
    d.draw("2025-06-01", "3", square(0, 0, 4));
    CHECK(d.failures.isEmpty());
    const auto& record = d.models.workspace.snapshot()->record();
    REQUIRE(record.regions.size() == 1);
    CHECK(d.models.workspace.snapshot()->index().name(record.regions.front().unit) == "3");
    CHECK(d.models.time.stops().size() == 1);
    d.models.workspace.undo();
    settle(d.models.workspace);
    CHECK(d.models.workspace.snapshot()->record().regions.empty());
    CHECK(d.models.time.stops().empty());
}

TEST_CASE("A number without a unit makes one, and the tool says so before") {
    Drawing d;
    d.models.outline.set_unit(QStringLiteral("30"));
    CHECK(d.models.outline.unit_sentence().contains(QStringLiteral("30")));
    d.draw("2025-06-01", "30", square(0, 0, 4));
    CHECK(d.models.units.total() == 4);
}

TEST_CASE("Corners are taken back one by one, and an outline cancelled by Esc comes back") {
    Drawing d;
    OutlineTool& tool = d.models.outline;
    tool.begin(QStringLiteral("plan"), on_day("2025-06-01"));
    for (const QPointF& p : square(0, 0, 4)) tool.add(p);
    tool.take_back();
    CHECK(tool.corners().size() == 3);
    tool.take_forward();
    CHECK(tool.corners().size() == 4);
    tool.cancel();
    CHECK(tool.corners().isEmpty());
    CHECK(tool.is_active(QStringLiteral("plan")));
    tool.take_back();
    CHECK(tool.corners().size() == 4);
    CHECK(tool.can_finish());
}

TEST_CASE("Two corners are no outline, and one that crosses itself is refused with a sentence or mended") {
    Drawing d;
    d.draw("2025-06-01", "3", {{0, 0}, {1, 1}});
    CHECK(d.models.workspace.snapshot()->record().regions.empty());
    d.draw("2025-06-01", "3", {{0, 0}, {2, 2}, {2, 0}, {0, 2}});
    CHECK((d.failures.size() == 1 || d.models.workspace.snapshot()->record().regions.size() == 1));
}

TEST_CASE("The smaller region lies on top, labels stand inside, and new corners snap to old ones") {
    Drawing d;
    d.draw("2025-06-01", "3", square(0, 0, 4));
    d.draw("2025-06-01", "2", square(1, 1, 1));
    const auto shapes = regions_in_plan(*d.models.workspace.snapshot(), d.models.time.surface());
    REQUIRE(shapes.size() == 2);
    CHECK(shapes[0].label == QStringLiteral("3"));
    CHECK(std::abs(shapes[0].area - 16.0) < 1e-9);
    const RegionShape* small = region_under(shapes, {1.5, 1.5});
    REQUIRE(small != nullptr);
    CHECK(small->label == QStringLiteral("2"));
    CHECK(region_under(shapes, {9.0, 9.0}) == nullptr);
    for (const RegionShape& shape : shapes) CHECK(region_under({shape}, shape.middle) != nullptr);
    CHECK(snap(shapes, {0.05, 0.03}, 0.1) == QPointF(0.0, 0.0));
    const auto on_line = snap(shapes, {3.0, 0.06}, 0.1);
    REQUIRE(on_line);
    CHECK(std::abs(on_line->y()) < 1e-9);
    CHECK_FALSE(snap(shapes, {8.0, 8.0}, 0.1));
}

TEST_CASE("The time line stands on the last surface, and goes where a selected unit was last seen") {
    Drawing d;
    d.draw("2025-06-01", "3", square(0, 0, 4));
    d.draw("2025-06-02", "2", square(0, 0, 4));
    d.draw("2025-06-03", "1", square(0, 0, 4));
    REQUIRE(d.models.time.stops().size() == 3);
    d.models.time.go_to(2);
    const auto& snapshot = *d.models.workspace.snapshot();
    d.models.workspace.select(snapshot.record().units[snapshot.index().named("2").front()].id);
    CHECK(d.models.time.current() == 1);
    d.models.time.go_to(-1);
    CHECK(d.models.time.current() == 1);
}
