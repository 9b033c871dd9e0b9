// SPDX-License-Identifier: MIT
#include "gui/viewmodels/outline_edit.hpp"

#include <cmath>
#include <limits>

#include "app/regions/outline.hpp"
#include "core/base/error.hpp"
#include "gui/viewmodels/models.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

namespace {

EditGround plan() {
    EditGround ground;
    ground.to_view = [](const geometry::Point3& p) { return QPointF(p[0], p[1]); };
    ground.to_site = [](QPointF from, QPointF to) {
        constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
        return geometry::Line3{{from.x(), from.y(), kUnknown}, {to.x(), to.y(), kUnknown}};
    };
    return ground;
}

// A square of 4 m whose lines were followed over the ground: a point every 0.5 m, with heights, less than 3 cm off.
geometry::Line3 followed_square() {
    geometry::Line3 ring;
    const auto line = [&](double x0, double y0, double x1, double y1) {
        for (int i = 0; i < 8; ++i) {
            const double t = i / 8.0;
            const double aside = i % 2 == 0 ? 0.0 : 0.01;
            ring.push_back({x0 + t * (x1 - x0) + aside, y0 + t * (y1 - y0) + aside, 10.0 + 0.1 * t});
        }
    };
    line(0, 0, 4, 0);
    line(4, 0, 4, 4);
    line(4, 4, 0, 4);
    line(0, 4, 0, 0);
    return ring;
}

struct Editing {
    test::GuiProject site;
    Models models{app::Session{"Ada"}};
    QStringList failures;
    OutlineEdit& edit = models.edit;

    Editing() {
        QObject::connect(&models.workspace, &Workspace::failed, [this](const QString& s) { failures << s; });
        {
            app::Project project = app::Project::open(site.file, store::OpenMode::ReadWrite, {"Ada"});
            app::record_kind("surface").add(project, "2025-06-01", {{"area", "A"}});
            project.change("Draw", [&] {
                model::Region region;
                region.surface = project.record().surfaces.front().id;
                region.unit = project.record().units[project.unit_named("3")].id;
                region.drawn_on = "panorama";
                region.outline = app::outline_of({{followed_square()}});
                project.file().insert(region);
            });
        }
        models.workspace.open(site.file, store::OpenMode::ReadWrite);
        settle(models.workspace);
        edit.begin(QStringLiteral("plan"), plan());
        edit.choose(region().id);
    }

    [[nodiscard]] const model::Region& region() const { return models.workspace.snapshot()->record().regions.front(); }

    void finish() {
        edit.finish();
        settle(models.workspace);
    }

    // Somebody takes the corner at a place and drags it.
    void drag(QPointF from, QPointF to) {
        const auto corner = edit.corner_at(from, 0.1);
        REQUIRE(corner);
        edit.grab(*corner);
        edit.move((from + to) / 2.0);
        edit.move(to);
    }
};

bool holds(const model::Ring& ring, double x, double y) {
    return std::any_of(ring.begin(), ring.end(), [&](const auto& p) { return std::hypot(p[0] - x, p[1] - y) < 1e-9; });
}

} // namespace

TEST_CASE("Of an outline with many points only the corners show") {
    const OutlineEdit::Ring corners = corners_of(followed_square(), plan());
    REQUIRE(corners.size() == 4);
    for (const auto& corner : corners) CHECK(corner.original.has_value());
    CHECK(ring_of(corners, followed_square(), plan()) == followed_square());
}

TEST_CASE("A point in the middle of a line is no corner even where the ring begins with it") {
    geometry::Line3 ring = followed_square();
    std::rotate(ring.begin(), ring.begin() + 4, ring.end());
    CHECK(corners_of(ring, plan()).size() == 4);
}

TEST_CASE("A corner moved takes its two lines along and leaves the others to the last digit; one undo step") {
    Editing e;
    const model::Region before = e.region();
    e.drag({4, 4}, {5, 5});
    e.finish();
    CHECK(e.failures.isEmpty());
    const model::Region after = e.region();
    REQUIRE(after.outline.size() == 1);
    const model::Ring& ring = after.outline.front().outer;
    CHECK(holds(ring, 5.0, 5.0));
    CHECK_FALSE(holds(ring, 4.0, 4.0));
    for (int i = 0; i < 8; ++i) { // the south side
        const auto& p = before.outline.front().outer[static_cast<std::size_t>(i)];
        CHECK(std::find(ring.begin(), ring.end(), p) != ring.end());
    }
    CHECK(after.drawn_on == "panorama");
    for (const auto& p : ring) CHECK(p[2] >= 10.0); // heights are those of the outline, where the view has none
    CHECK_FALSE(e.models.workspace.undo_label().isEmpty());
    e.models.workspace.undo();
    settle(e.models.workspace);
    CHECK(e.region() == before);
}

TEST_CASE("A corner is set on a line and another taken away; three always stay") {
    Editing e;
    const auto line = e.edit.middle_at({2.0, 0.0}, 0.1);
    REQUIRE(line);
    e.edit.insert(*line, {2.0, 0.0});
    e.edit.move({2.0, -1.0});
    CHECK(e.edit.rings().front().size() == 5);
    for (const QPointF corner : {QPointF(4, 0), QPointF(0, 0)}) e.edit.remove(*e.edit.corner_at(corner, 0.1));
    CHECK(e.edit.rings().front().size() == 3);
    e.edit.remove(*e.edit.corner_at({4, 4}, 0.1));
    CHECK(e.edit.rings().front().size() == 3);
    e.finish();
    CHECK(e.failures.isEmpty());
    const model::Ring& ring = e.region().outline.front().outer;
    CHECK(holds(ring, 2.0, -1.0));
    CHECK_FALSE(holds(ring, 0.0, 0.0));
}

TEST_CASE("Steps are taken back one by one; Esc takes all, and they come again") {
    Editing e;
    e.drag({4, 4}, {5, 5});
    e.drag({0, 0}, {-1, -1});
    e.edit.take_back();
    CHECK(e.edit.corner_at({0, 0}, 0.1));
    CHECK(e.edit.corner_at({5, 5}, 0.1));
    e.edit.take_forward();
    CHECK(e.edit.corner_at({-1, -1}, 0.1));
    e.edit.cancel();
    CHECK_FALSE(e.edit.is_changed());
    CHECK(e.edit.corner_at({4, 4}, 0.1));
    e.edit.take_forward();
    CHECK(e.edit.corner_at({5, 5}, 0.1));
    e.edit.cancel();
    e.edit.cancel();
    CHECK(e.edit.region().is_nil());
    CHECK(e.edit.is_active(QStringLiteral("plan")));
    e.edit.cancel();
    CHECK_FALSE(e.edit.is_active(QStringLiteral("plan")));
}

TEST_CASE("What crosses itself is refused or mended; what somebody else drew meanwhile is kept") {
    Editing e;
    const model::Region before = e.region();
    e.drag({4, 4}, {-6, 2});
    e.finish();
    CHECK((e.failures.size() == 1 || e.region().outline != before.outline));
    e.edit.choose({});
    e.edit.choose(e.region().id);
    {
        app::Project other = app::Project::open(e.site.file, store::OpenMode::ReadWrite, {"Bob"});
        app::record_kind("region").set(other, "2025-06-01/3#1", {{"outline", "0 0 1, 9 0 1, 9 9 1"}});
    }
    const auto corner = e.edit.rings().front().front().at;
    e.drag(corner, corner - QPointF(1, 1));
    const qsizetype said = e.failures.size();
    e.finish();
    CHECK(e.failures.size() == said + 1);
    CHECK(holds(e.site.reopened().record().regions.front().outline.front().outer, 9.0, 9.0));
}

TEST_CASE("Where part of an outline is out of sight, what is seen can be changed and the rest stays") {
    EditGround half = plan();
    half.to_view = [](const geometry::Point3& p) {
        return p[0] > 2.2 ? std::optional<QPointF>() : std::optional(QPointF(p[0], p[1]));
    };
    OutlineEdit::Ring corners = corners_of(followed_square(), half);
    REQUIRE(corners.size() == followed_square().size());
    CHECK(ring_of(corners, followed_square(), half) == followed_square());
    corners[4].at += QPointF(0.0, -0.5); // (2, 0), the last that is seen of the south side
    corners[4].original.reset();
    corners[4].runs_to.reset();
    const geometry::Line3 ring = ring_of(corners, followed_square(), half);
    CHECK(ring.size() == followed_square().size());
    CHECK(ring[4][1] == Approx(-0.5));
    CHECK(ring[5] == followed_square()[5]);
}
