// SPDX-License-Identifier: MIT
#include "gui/desktop.hpp"

#include <QApplication>
#include <QCommandLineOption>
#include <QCommandLineParser>
#include <QObject>
#include <QStandardPaths>
#include <QStringList>

#include <cstdio>
#include <iostream>
#include <string>
#include <string_view>

#include "core/base/error.hpp"
#include "gui/viewmodels/backup_rotation.hpp"
#include "gui/widgets/language.hpp"
#include "gui/widgets/theme.hpp"
#include "gui/widgets/window/main_window.hpp"
#include "gui/widgets/window/screenshot.hpp"

namespace planum::gui {

namespace {

struct Arguments {
    QString site;
    ScreenshotRequest screenshot;
    ThemeKind theme = ThemeKind::Light;
    QString language; ///< `de`; empty: as chosen in the window, else the system's
    bool read_only = false;
    bool help = false;
    bool version = false;
    QString help_text;
};

// Throws Usage.
Arguments read_arguments(const QStringList& given) {
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("The stratigraphy of a dig, to see and to draw on."));
    parser.addPositionalArgument(QStringLiteral("SITE"), QStringLiteral("the project file (NAME.gpkg)"));
    const QCommandLineOption help({QStringLiteral("h"), QStringLiteral("help")},
                                  QStringLiteral("Print this help and exit."));
    const QCommandLineOption version(QStringLiteral("version"), QStringLiteral("Print the version and exit."));
    const QCommandLineOption shot(QStringLiteral("screenshot"),
                                  QStringLiteral("Write a picture of the window with VIEW in front, and exit."),
                                  QStringLiteral("VIEW"));
    const QCommandLineOption output({QStringLiteral("o"), QStringLiteral("output")},
                                    QStringLiteral("File of the picture (PNG)."), QStringLiteral("FILE"));
    const QCommandLineOption unit(QStringLiteral("unit"), QStringLiteral("Select this unit first."),
                                  QStringLiteral("NUMBER"));
    const QCommandLineOption problem(QStringLiteral("problem"),
                                     QStringLiteral("Open the first problem of this kind (problems only)."),
                                     QStringLiteral("CODE"));
    const QCommandLineOption size(QStringLiteral("size"),
                                  QStringLiteral("Size of the picture, WIDTHxHEIGHT in pixels."),
                                  QStringLiteral("SIZE"), QStringLiteral("1600x1000"));
    const QCommandLineOption theme_option(QStringLiteral("theme"), QStringLiteral("light, dark or sunlight."),
                                          QStringLiteral("THEME"), QStringLiteral("light"));
    const QCommandLineOption language(QStringLiteral("language"), QStringLiteral("en, de, it or fr."),
                                      QStringLiteral("LANGUAGE"));
    const QCommandLineOption read_only(QStringLiteral("read-only"), QStringLiteral("Change nothing."));
    parser.addOptions({help, version, shot, output, unit, problem, size, theme_option, language, read_only});
    if (!parser.parse(given)) throw Error(ErrorCode::Usage, parser.errorText().toStdString());
    Arguments arguments;
    arguments.help = parser.isSet(help);
    arguments.version = parser.isSet(version);
    arguments.help_text = parser.helpText();
    arguments.read_only = parser.isSet(read_only);
    arguments.language = parser.value(language);
    if (parser.isSet(language) && !languages().contains(arguments.language)) {
        throw Error(ErrorCode::Usage, "language: " + arguments.language.toStdString() + " is none of en, de, it, fr");
    }
    arguments.theme = theme_from_word(parser.value(theme_option));
    if (to_word(arguments.theme) != parser.value(theme_option)) {
        throw Error(ErrorCode::Usage,
                    "theme: " + parser.value(theme_option).toStdString() + " is none of light, dark, sunlight");
    }
    if (!parser.positionalArguments().isEmpty()) arguments.site = parser.positionalArguments().first();
    if (parser.positionalArguments().size() > 1) throw Error(ErrorCode::Usage, "one project at a time");
    arguments.screenshot.view = parser.value(shot).toStdString();
    arguments.screenshot.output = parser.value(output).toStdString();
    arguments.screenshot.unit = parser.value(unit).toStdString();
    arguments.screenshot.problem = parser.value(problem).toStdString();
    const QStringList numbers = parser.value(size).split(QLatin1Char('x'));
    if (numbers.size() == 2) {
        arguments.screenshot.width = numbers[0].toInt();
        arguments.screenshot.height = numbers[1].toInt();
    }
    if (arguments.screenshot.width < 200 || arguments.screenshot.height < 200 || arguments.screenshot.width > 20000 ||
        arguments.screenshot.height > 20000) {
        throw Error(ErrorCode::Usage, "size: between 200x200 and 20000x20000");
    }
    if (!arguments.screenshot.view.empty() && (arguments.site.isEmpty() || arguments.screenshot.output.empty())) {
        throw Error(ErrorCode::Usage, "--screenshot wants -o FILE and SITE");
    }
    return arguments;
}

int take_screenshot(const Arguments& arguments) {
    MainWindow window;
    bool failed = false;
    QObject::connect(&window.models().workspace, &Workspace::failed, [&](const QString& sentence) {
        std::cerr << "planum-desktop: " << sentence.toStdString() << '\n';
        failed = true;
    });
    window.open(arguments.site.toStdString(), store::OpenMode::ReadOnly);
    write_screenshot(window, arguments.screenshot);
    return failed ? exit_status(ErrorCode::BadInput) : 0;
}

} // namespace

int run_desktop(int argc, char** argv) {
    QStringList given;
    bool picture = false;
    for (int i = 0; i < argc; ++i) {
        given << QString::fromLocal8Bit(argv[i]);
        picture = picture || std::string_view(argv[i]).substr(0, 12) == "--screenshot";
    }
    try {
        const Arguments arguments = read_arguments(given);
        if (arguments.help) return std::cout << arguments.help_text.toStdString(), 0;
        if (arguments.version) return std::cout << "planum-desktop " PLANUM_VERSION "\n", 0;
        // A picture needs no display, and must not fail for a wrong one; 3D alone cannot do without.
        const bool wants_display = arguments.screenshot.view == "3d" && qEnvironmentVariableIsSet("DISPLAY");
        if (picture && !wants_display && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
            qputenv("QT_QPA_PLATFORM", "offscreen");
        // What Qt finds missing where there is no display is nobody's concern.
        if (picture) qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
        QApplication application(argc, argv);
        QApplication::setApplicationName(QStringLiteral("Planum"));
        QApplication::setOrganizationName(QStringLiteral("Planum"));
        apply_theme(arguments.theme);
        apply_language(arguments.language);
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
        window.show();
        return QApplication::exec();
    } catch (const Error& error) {
        std::cerr << "planum-desktop: " << error.what() << '\n';
        return exit_status(error.code());
    }
}

} // namespace planum::gui
