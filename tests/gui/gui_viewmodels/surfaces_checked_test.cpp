// SPDX-License-Identifier: MIT
#include "gui/viewmodels/problem_list_model.hpp"

#include <algorithm>
#include <functional>

#include "app/records/record_kind.hpp"
#include "gui/viewmodels/models.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"
#include "tests/support/measured_days.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

namespace {

// Unit 1 lay measurably above 2; the record is as each test wants it.
struct MeasuredDesk {
    struct Application {
        Application() { test::ensure_core_application(); }
    } application;

    test::TemporaryFolder folder;
    Models models{app::Session{"Ada"}};

    explicit MeasuredDesk(const char* relation) {
        {
            app::Project project = test::make_measured_days(folder, folder / "site.gpkg");
            app::record_kind("relation").add(project, relation, {});
        }
        models.workspace.open(folder / "site.gpkg", store::OpenMode::ReadWrite);
        settle(models.workspace);
        settle(models.workspace); // the check after the surfaces were asked
    }

    void edit(const std::function<void(app::Project&)>& work) {
        models.workspace.edit(QStringLiteral("edit"), [work](app::Project& project, Progress&) { work(project); });
        settle(models.workspace);
        settle(models.workspace);
    }

    [[nodiscard]] long height_contradictions() const {
        const auto& problems = models.problems.check().problems;
        return std::count_if(problems.begin(), problems.end(),
                             [](const model::Diagnostic& d) { return d.code == "height-contradiction"; });
    }
};

} // namespace

TEST_CASE("The window says of a relation that the measured surfaces show the opposite") {
    MeasuredDesk desk("2 covers 1");
    REQUIRE(desk.height_contradictions() == 1);
    CHECK_FALSE(desk.models.problems.is_comparing_surfaces());
    CHECK(desk.models.problems.check().coverage.contradicted == 1);
    ProblemListModel& problems = desk.models.problems;
    for (int row = 0; row < problems.rowCount(); ++row) {
        problems.open(row);
        const QString code = problems.data(problems.index(row), ProblemListModel::CodeRole).toString();
        CHECK(problems.detail().has_faces == (code == QStringLiteral("height-contradiction")));
    }
}

TEST_CASE("Surfaces that agree with the record confirm it in the window") {
    const MeasuredDesk desk("1 covers 2");
    CHECK(desk.height_contradictions() == 0);
    CHECK(desk.models.problems.check().coverage.confirmed == 1);
}

TEST_CASE("A relation entered later is judged by the surfaces as soon as it stands") {
    MeasuredDesk desk("1 covers 2");
    desk.edit([](app::Project& project) {
        app::record_kind("relation").remove(project, "1 covers 2");
        app::record_kind("relation").add(project, "2 covers 1", {});
    });
    CHECK(desk.height_contradictions() == 1);
}

TEST_CASE("Outlines that change ask the surfaces again") {
    MeasuredDesk desk("2 covers 1");
    REQUIRE(desk.height_contradictions() == 1);
    desk.edit([](app::Project& project) {
        const std::vector<model::Region> regions = project.record().regions;
        project.change("take an outline away", [&] { project.file().remove(regions.front().id); });
    });
    CHECK(desk.height_contradictions() == 0);
}

TEST_CASE("A project without scans is not said to be waiting for its surfaces") {
    test::GuiProject site;
    Models models{app::Session{"Ada"}};
    models.workspace.open(site.file, store::OpenMode::ReadWrite);
    settle(models.workspace);
    CHECK_FALSE(models.problems.is_comparing_surfaces());
    models.workspace.close();
    CHECK_FALSE(models.problems.is_comparing_surfaces());
}
