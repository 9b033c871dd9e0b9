// SPDX-License-Identifier: MIT
#include "gui/desktop.hpp"

#include <unistd.h>

#include <QApplication>
#include <QObject>
#include <QScreen>
#include <QStandardPaths>
#include <QStringList>

#include <cstdio>
#include <iostream>
#include <string>
#include <string_view>

#include "core/base/error.hpp"
#include "gui/desktop_arguments.hpp"
#include "gui/viewmodels/backup_rotation.hpp"
#include "gui/viewmodels/models.hpp"
#include "gui/widgets/language.hpp"
#include "gui/widgets/theme.hpp"
#include "gui/widgets/window/main_window.hpp"
#include "gui/widgets/window/screenshot.hpp"

namespace planum::gui {

namespace {

int take_screenshot(const DesktopArguments& arguments) {
    MainWindow window;
    bool failed = false;
    QObject::connect(&window.models().workspace, &Workspace::failed, [&](const QString& sentence) {
        std::cerr << "planum-desktop: " << sentence.toStdString() << '\n';
        failed = true;
    });
    window.models().workspace.open_for_picture(arguments.site.toStdString());
    write_screenshot(window, arguments.screenshot);
    return failed ? exit_status(ErrorCode::BadInput) : 0;
}

// Settles on the project; false where it said why it cannot be opened.
bool open_and_wait(Workspace& workspace, const QString& site) {
    QObject::connect(&workspace, &Workspace::failed, [](const QString& sentence) {
        std::cerr << "planum-desktop: " << sentence.toStdString() << '\n';
    });
    workspace.open(site.toStdString(), store::OpenMode::ReadOnly);
    constexpr int kPatience = 120'000; // [ms]
    if (!workspace.jobs().wait_until_idle(kPatience))
        throw Error(ErrorCode::Io, "the project was not open after two minutes");
    return workspace.is_open();
}

int take_flight(const DesktopArguments& arguments) {
    Models models;
    if (!open_and_wait(models.workspace, arguments.site)) return exit_status(ErrorCode::BadInput);
    const bool on_terminal = isatty(STDERR_FILENO) != 0;
    write_flight(models, arguments.flight, [&](int written, int all) {
        if (on_terminal)
            std::cerr << "\rframe " << written << " of " << all << (written == all ? "\n" : "") << std::flush;
    });
    return 0;
}

} // namespace

int run_desktop(int argc, char** argv) {
    QStringList given;
    bool picture = false;
    for (int i = 0; i < argc; ++i) {
        given << QString::fromLocal8Bit(argv[i]);
        const std::string_view word = argv[i];
        picture = picture || word.substr(0, 12) == "--screenshot" || word.substr(0, 8) == "--flight";
    }
    try {
        const DesktopArguments arguments = read_desktop_arguments(given);
        if (arguments.help) return std::cout << arguments.help_text.toStdString(), 0;
        if (arguments.version) return std::cout << "planum-desktop " PLANUM_VERSION "\n", 0;
        // A picture needs no display, and must not fail for a wrong one; 3D alone cannot do without.
        const bool flies = !arguments.flight.cameras.empty();
        const bool wants_display = (flies || arguments.screenshot.view == "3d") && qEnvironmentVariableIsSet("DISPLAY");
        if (picture && !wants_display && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
            qputenv("QT_QPA_PLATFORM", "offscreen");
        // What Qt finds missing where there is no display is nobody's concern.
        if (picture) qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
        QApplication application(argc, argv);
        QApplication::setApplicationName(QStringLiteral("Planum"));
        QApplication::setOrganizationName(QStringLiteral("Planum"));
        apply_theme(arguments.theme);
        apply_language(arguments.language);
        if (flies) return take_flight(arguments);
        if (picture) return take_screenshot(arguments);
        MainWindow window;
        if (!arguments.site.isEmpty()) {
            window.open(arguments.site.toStdString(),
                        arguments.read_only ? store::OpenMode::ReadOnly : store::OpenMode::ReadWrite);
        }
        const BackupRotation copies(
            window.models().workspace,
            std::filesystem::path(
                QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation).toStdString()) /
                "copies");
        // On a tablet it fills the screen; on a large screen it leaves room for other programs.
        const QSize room = window.screen()->availableSize();
        room.width() < window.width() || room.height() < window.height() ? window.showMaximized() : window.show();
        return QApplication::exec();
    } catch (const Error& error) {
        std::cerr << "planum-desktop: " << error.what() << '\n';
        return exit_status(error.code());
    }
}

} // namespace planum::gui
