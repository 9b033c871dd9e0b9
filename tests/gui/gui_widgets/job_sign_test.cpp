// SPDX-License-Identifier: MIT
#include "gui/widgets/window/job_sign.hpp"

#include <QApplication>
#include <QLabel>
#include <QProgressBar>

#include "gui/viewmodels/job.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"

using namespace planum;
using namespace planum::gui;

namespace {

void ensure_application() {
    static int argc = 1;
    static char name[] = "test";
    static char* argv[] = {name, nullptr};
    if (QCoreApplication::instance() == nullptr) new QApplication(argc, argv);
}

JobRunner::Done until_stopped(Progress& progress) {
    while (true) progress.check();
}

} // namespace

TEST_CASE("Work that was asked for is said at once, what goes on by itself only when it takes long") {
    ensure_application();
    JobRunner jobs;
    JobSign sign(jobs);
    CHECK(sign.isHidden());
    jobs.start(QStringLiteral("quiet"), JobRunner::Queueing::InOrder, QStringLiteral("Looking around"),
               Job::Kind::Quiet, until_stopped, {});
    CHECK(sign.isHidden());
    for (int i = 0; i < 400 && sign.isHidden(); ++i) {
        QEventLoop loop;
        QTimer::singleShot(20, &loop, &QEventLoop::quit);
        loop.exec();
    }
    CHECK_FALSE(sign.isHidden());
    // How far it is nobody knows: no bar that runs to and fro.
    CHECK(sign.findChild<QProgressBar*>()->isHidden());
    jobs.start(QStringLiteral("asked"), JobRunner::Queueing::InOrder, QStringLiteral("Registering"), Job::Kind::Asked,
               until_stopped, {});
    CHECK(sign.findChild<QLabel*>()->text() == QStringLiteral("Registering"));
    CHECK_FALSE(sign.findChild<QProgressBar*>()->isHidden());
    jobs.cancel_all();
    REQUIRE(jobs.wait_until_idle(test::kPatience));
    CHECK(sign.isHidden());
}
