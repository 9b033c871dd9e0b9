// SPDX-License-Identifier: MIT
#include "gui/viewmodels/patch_model.hpp"

#include "gui/viewmodels/models.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"
#include "tests/support/measured_days.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

namespace {

// Two days: in the west unit 1 was dug away and nobody has outlined what came out.
struct Offered {
    test::TemporaryFolder folder;
    Models models{app::Session{"Ada"}};
    QStringList failures;

    Offered() {
        test::ensure_core_application();
        QObject::connect(&models.workspace, &Workspace::failed, [this](const QString& s) { failures << s; });
        {
            app::Project project = test::make_measured_days(folder, folder / "site.gpkg");
            app::record_kind("region").remove(project, "2025-06-02/2#1");
        }
        models.workspace.open(folder / "site.gpkg", store::OpenMode::ReadWrite);
        settle(models.workspace);
    }
};

} // namespace

TEST_CASE("Ground that changed without an outline is offered, and taken under a number as one undo step") {
    Offered o;
    PatchModel& patches = o.models.patches;
    CHECK(patches.patches().empty()); // nobody asked
    patches.begin(QStringLiteral("plan"));
    CHECK(patches.is_looking());
    settle(o.models.workspace);
    REQUIRE(patches.patches().size() == 1);
    REQUIRE(patches.shapes().size() == 1);
    CHECK(region_under(patches.shapes(), {0.5, 0.5}) == &patches.shapes().front());
    CHECK_FALSE(patches.can_finish()); // none is chosen
    patches.choose(0);
    o.models.outline.set_unit({});
    CHECK_FALSE(patches.can_finish()); // nor is a unit
    o.models.outline.set_unit(QStringLiteral("2"));
    REQUIRE(patches.can_finish());
    const std::size_t before = o.models.workspace.snapshot()->record().regions.size();
    patches.finish();
    settle(o.models.workspace);
    settle(o.models.workspace);
    CHECK(o.failures.isEmpty());
    CHECK(o.models.workspace.snapshot()->record().regions.size() == before + 1);
    CHECK(patches.patches().empty()); // all is outlined now
    CHECK(patches.is_active(QStringLiteral("plan")));
    o.models.workspace.undo();
    settle(o.models.workspace);
    settle(o.models.workspace);
    CHECK(o.models.workspace.snapshot()->record().regions.size() == before);
    CHECK(patches.patches().size() == 1);
}

TEST_CASE("The first surface has none before it to be compared with: a sentence, no patch") {
    Offered o;
    o.models.time.go_to(0);
    o.models.patches.begin(QStringLiteral("plan"));
    settle(o.models.workspace);
    CHECK(o.models.patches.patches().empty());
    CHECK_FALSE(o.models.patches.sentence().isEmpty());
    CHECK(o.failures.isEmpty());
    o.models.patches.end();
    CHECK_FALSE(o.models.patches.is_active(QStringLiteral("plan")));
}
