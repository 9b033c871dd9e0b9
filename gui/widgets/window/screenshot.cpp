// SPDX-License-Identifier: MIT
#include "gui/widgets/window/screenshot.hpp"

#include <QApplication>
#include <QBuffer>
#include <QElapsedTimer>
#include <QLabel>
#include <QListView>
#include <QPixmap>

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "gui/widgets/space/space_view.hpp"
#include "gui/widgets/view.hpp"
#include "gui/widgets/window/main_window.hpp"

namespace planum::gui {

namespace {

constexpr int kPatience = 120'000; // [ms]

// What a view still makes in the window's own thread, a step at a time.
bool is_busy(const MainWindow& window) {
    const auto widgets = window.findChildren<QWidget*>();
    return std::any_of(widgets.begin(), widgets.end(),
                       [](const QWidget* one) { return one->isVisible() && one->property("busy").toBool(); });
}

void settle(MainWindow& window) {
    QElapsedTimer timer;
    timer.start();
    for (int round = 0; round < 4; ++round) {
        while (is_busy(window) && timer.elapsed() < kPatience)
            QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 50);
        QApplication::processEvents();
        if (!window.models().workspace.jobs().wait_until_idle(kPatience)) {
            throw Error(ErrorCode::Io, "the window was still busy after two minutes");
        }
    }
    QApplication::processEvents();
}

void open_problem(ProblemListModel& problems, const std::string& code) {
    for (int row = 0; row < problems.rowCount(); ++row) {
        const QString now = problems.data(problems.index(row), ProblemListModel::CodeRole).toString();
        if (code.empty() || now.toStdString() == code) return problems.open(row);
    }
    if (!code.empty()) throw Error(ErrorCode::NotFound, "no problem " + code + " in the list");
}

} // namespace

void write_screenshot(MainWindow& window, const ScreenshotRequest& request) {
    if (window.view(request.view) == nullptr) {
        std::vector<std::string> names;
        for (const ViewEntry& entry : all_views()) names.emplace_back(entry.name);
        throw Error(ErrorCode::Usage,
                    fmt::format("there is no view {}; there are {}", request.view, text::join(names, ", ")));
    }
    window.resize(request.width, request.height);
    window.show();
    settle(window);
    Workspace& workspace = window.models().workspace;
    if (!workspace.is_open()) return; // it said why
    window.show_view(request.view);
    if (!request.unit.empty()) {
        const auto found = workspace.snapshot()->index().named(request.unit);
        if (found.empty()) throw Error(ErrorCode::NotFound, "no unit " + request.unit);
        workspace.select(workspace.snapshot()->record().units[found.front()].id);
    }
    settle(window);
    if (auto* space = dynamic_cast<SpaceView*>(window.view(request.view))) space->show_colour(request.colour);
    if (request.view == "problems") open_problem(window.models().problems, request.problem);
    if (request.view == "suggestions") {
        window.show_view("plan");
        settle(window);
        if (auto* list = window.findChild<QListView*>(QStringLiteral("suggestionList"))) {
            list->setCurrentIndex(list->model()->index(0, 0));
        }
    }
    settle(window);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    window.grab().save(&buffer, "PNG");
    write_file_atomically(request.output, std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
    // The picture shows what the window shows; who asked for the site in 3D did not get it all the same.
    if (const auto* trouble = window.findChild<QLabel*>(QStringLiteral("spaceTrouble"));
        request.view == "3d" && trouble)
        throw Error(ErrorCode::Io, trouble->text().toStdString());
}

} // namespace planum::gui
