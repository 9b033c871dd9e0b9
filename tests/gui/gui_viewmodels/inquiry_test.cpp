// SPDX-License-Identifier: MIT
#include "gui/viewmodels/inquiry.hpp"

#include <algorithm>
#include <filesystem>

#include "app/records/record_kind.hpp"
#include "app/registration/registration_runs.hpp"
#include "gui/viewmodels/models.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"
#include "tests/support/measured_days.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

namespace {

// Unit 1 lay over 2, and the record says so; the reading `other` leaves that out and says the opposite.
struct Asking {
    struct Application {
        Application() { test::ensure_core_application(); }
    } application;

    test::TemporaryFolder folder;
    Models models{app::Session{"Ada"}};
    QStringList failures;
    Answer answer;

    Asking() {
        {
            app::Project project = test::make_measured_days(folder, folder / "site.gpkg");
            app::record_kind("relation").add(project, "1 covers 2", {});
            model::PhysicalRelation turned = project.record().relations.front();
            project.change("reading", [&] {
                model::Interpretation other;
                other.name = "other";
                other.dropped = {turned.id};
                turned.id = {project.uuids().next()};
                std::swap(turned.subject, turned.object);
                other.added = {turned};
                project.file().insert(other);
            });
        }
        QObject::connect(&models.workspace, &Workspace::failed, [this](const QString& s) { failures << s; });
        QObject::connect(&models.inquiry, &Inquiry::answered, [this](const Answer& a) { answer = a; });
        models.workspace.open(folder / "site.gpkg", store::OpenMode::ReadWrite);
        settle(models.workspace);
    }

    [[nodiscard]] bool says(const char* words) const {
        return std::any_of(answer.lines.begin(), answer.lines.end(),
                           [&](const QString& line) { return line.contains(QString::fromUtf8(words)); });
    }
};

} // namespace

TEST_CASE("Two readings are compared in the window by relations, orders and what the surfaces contradict") {
    Asking asking;
    CHECK(asking.models.inquiry.readings() == QStringList{QStringLiteral("record"), QStringLiteral("other")});
    asking.models.inquiry.compare_readings(QStringLiteral("record"), QStringLiteral("other"));
    settle(asking.models.workspace);
    CHECK(asking.failures.isEmpty());
    CHECK(asking.says("only in record: 1 covers 2"));
    CHECK(asking.says("only in other: 2 covers 1"));
    CHECK(asking.says("contradicted in other only"));
}

TEST_CASE("A project is verified in the window, and a scan whose original is gone is named") {
    Asking asking;
    asking.models.inquiry.verify();
    settle(asking.models.workspace);
    REQUIRE(asking.answer.lines.size() == 1);
    CHECK(asking.says("no problem found"));
    std::filesystem::remove(asking.folder / "2025-06-01/s.xyz");
    asking.models.inquiry.verify();
    settle(asking.models.workspace);
    CHECK(asking.says("2025-06-01/s"));
}

TEST_CASE("A registration that there is not is a sentence") {
    Asking asking;
    CHECK(asking.models.inquiry.runs() == QStringList{QStringLiteral("1")});
    asking.models.inquiry.compare_runs(QStringLiteral("1"), QStringLiteral("9"));
    settle(asking.models.workspace);
    CHECK(asking.failures.size() == 1);
    CHECK(asking.answer.lines.isEmpty());
}

TEST_CASE("Ground that changed and is not outlined is listed with the unit it may be, ready to be saved") {
    Asking asking;
    asking.models.workspace.edit(QStringLiteral("edit"), [](app::Project& project, Progress&) {
        const std::vector<model::Region> regions = project.record().regions;
        project.change("take the last day's outlines away", [&] {
            for (const model::Region& region : regions) {
                if (region.surface == project.record().surfaces.back().id && project.index().name(region.unit) == "2")
                    project.file().remove(region.id);
            }
        });
    });
    settle(asking.models.workspace);
    asking.models.inquiry.find_patches({});
    settle(asking.models.workspace);
    CHECK(asking.failures.isEmpty());
    CHECK(asking.says("2025-06-02"));
    CHECK(asking.answer.file.find("FeatureCollection") != std::string::npos);
}

TEST_CASE("The days that a report may be asked of are offered, the newest first") {
    const Asking asking;
    const QStringList days = asking.models.inquiry.days();
    CHECK(days.contains(QStringLiteral("2025-06-01")));
    CHECK(days.contains(QStringLiteral("2025-06-02")));
    CHECK(std::is_sorted(days.rbegin(), days.rend()));
}
