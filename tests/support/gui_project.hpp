// SPDX-License-Identifier: MIT
#pragma once

#include <QCoreApplication>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "app/project/project.hpp"
#include "app/records/record_kind.hpp"
#include "gui/viewmodels/workspace.hpp"
#include "tests/support/temporary.hpp"

namespace planum::test {

inline constexpr int kPatience = 60'000; // [ms]

/// The application that threads of the desktop's models post to; without a display.
inline void ensure_core_application() {
    static int argc = 1;
    static char name[] = "test";
    static char* argv[] = {name, nullptr};
    static QCoreApplication* application = QCoreApplication::instance();
    if (application == nullptr) application = new QCoreApplication(argc, argv);
}

/// A project in a folder of its own: trench A with a cut 2 and its fill 1 above layer 3, and a find.
struct GuiProject {
    TemporaryFolder folder;
    std::filesystem::path file = folder / "site.gpkg";

    GuiProject() {
        ensure_core_application();
        model::ProjectSettings settings;
        settings.name = "Hill Farm";
        app::Project project = app::Project::create(file, settings, {"Ada"});
        app::record_kind("area").add(project, "A", {});
        app::record_kind("unit").add(project, "1", {{"kind", "fill"}, {"title", "ashy fill"}, {"area", "A"}});
        app::record_kind("unit").add(project, "2", {{"kind", "cut"}, {"status", "excavated"}, {"area", "A"}});
        app::record_kind("unit").add(project, "3", {{"kind", "layer"}, {"title", "clay floor"}});
        app::record_kind("relation").add(project, "1 fills 2", {});
        app::record_kind("relation").add(project, "2 cuts 3", {});
        app::record_kind("find").add(project, "7", {{"unit", "1"}, {"type", "sherd"}});
    }

    /// As another program sees it.
    [[nodiscard]] app::Project reopened() const { return app::Project::open(file, store::OpenMode::ReadOnly, {"Bob"}); }
};

inline void settle(gui::Workspace& workspace) {
    QCoreApplication::processEvents();
    if (!workspace.jobs().wait_until_idle(kPatience)) throw std::runtime_error("the jobs did not end");
    QCoreApplication::processEvents();
}

} // namespace planum::test
