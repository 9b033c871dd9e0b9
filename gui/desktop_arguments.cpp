// SPDX-License-Identifier: MIT
#include "gui/desktop_arguments.hpp"

#include <QCommandLineOption>
#include <QCommandLineParser>
#include <QSize>

#include <array>
#include <optional>
#include <utility>

#include "core/base/error.hpp"
#include "gui/widgets/language.hpp"

namespace planum::gui {

namespace {

QString q(const char* text) { return QString::fromUtf8(text); }

struct Options {
    QCommandLineOption help{{q("h"), q("help")}, q("Print this help and exit.")};
    QCommandLineOption version{q("version"), q("Print the version and exit.")};
    QCommandLineOption shot{q("screenshot"), q("Write a picture of the window with VIEW in front, and exit."),
                            q("VIEW")};
    QCommandLineOption flight{q("flight"),
                              q("Fly along the cameras of this file, write the frames to the folder of -o, and exit."),
                              q("CAMERAS.json")};
    QCommandLineOption output{
        {q("o"), q("output")}, q("File of the picture (PNG), or folder of the frames."), q("FILE")};
    QCommandLineOption unit{q("unit"), q("Select this unit first."), q("NUMBER")};
    QCommandLineOption problem{q("problem"), q("Open the first problem of this kind (problems only)."), q("CODE")};
    QCommandLineOption frames{q("frames"), q("Frames from each camera to the next."), q("N"), q("50")};
    QCommandLineOption surface{q("surface"), q("Surface whose scans the flight sees, or all; by itself the last one."),
                               q("NAME")};
    QCommandLineOption colour{q("colour"),
                              q("What colours the points of 3D: colour, intensity, height, day, unit or difference."),
                              q("BY"), q("colour")};
    QCommandLineOption size{q("size"), q("Size of the picture or the frames, WIDTHxHEIGHT in pixels."), q("SIZE"),
                            q("1600x1000")};
    QCommandLineOption theme{q("theme"), q("light, dark or sunlight."), q("THEME"), q("light")};
    QCommandLineOption language{q("language"), q("en, de, it or fr."), q("LANGUAGE")};
    QCommandLineOption read_only{q("read-only"), q("Change nothing.")};
};

Error usage(const std::string& message) { return {ErrorCode::Usage, message}; }

QSize size_from(const QString& text) {
    const QStringList numbers = text.split(QLatin1Char('x'));
    const QSize size = numbers.size() == 2 ? QSize(numbers[0].toInt(), numbers[1].toInt()) : QSize(0, 0);
    constexpr int kLeast = 200;
    constexpr int kMost = 20000;
    if (size.width() < kLeast || size.height() < kLeast || size.width() > kMost || size.height() > kMost)
        throw usage("size: between 200x200 and 20000x20000");
    return size;
}

PointColour colour_from(const QString& word) {
    constexpr std::array<std::pair<const char*, PointColour>, 6> kWords = {{{"colour", PointColour::Colour},
                                                                            {"intensity", PointColour::Intensity},
                                                                            {"height", PointColour::Height},
                                                                            {"day", PointColour::Day},
                                                                            {"unit", PointColour::Unit},
                                                                            {"difference", PointColour::Difference}}};
    for (const auto& [name, colour] : kWords) {
        if (word == QLatin1String(name)) return colour;
    }
    throw usage("colour: " + word.toStdString() + " is none of colour, intensity, height, day, unit, difference");
}

void read_look(const QCommandLineParser& parser, const Options& options, DesktopArguments& arguments) {
    arguments.language = parser.value(options.language);
    if (parser.isSet(options.language) && !languages().contains(arguments.language))
        throw usage("language: " + arguments.language.toStdString() + " is none of en, de, it, fr");
    const QString theme = parser.value(options.theme);
    arguments.theme = theme_from_word(theme);
    if (to_word(arguments.theme) != theme)
        throw usage("theme: " + theme.toStdString() + " is none of light, dark, sunlight");
}

void read_flight(const QCommandLineParser& parser, const Options& options, DesktopArguments& arguments) {
    FlightRequest& flight = arguments.flight;
    const bool flies = parser.isSet(options.flight);
    for (const QCommandLineOption* option : {&options.frames, &options.surface}) {
        if (!flies && parser.isSet(*option))
            throw usage("--" + option->names().constFirst().toStdString() + " belongs to --flight");
    }
    const bool shows_points = flies || arguments.screenshot.view == "3d";
    if (!shows_points && parser.isSet(options.colour)) throw usage("--colour belongs to --flight and --screenshot 3d");
    flight.colour = arguments.screenshot.colour = colour_from(parser.value(options.colour));
    if (!flies) return;
    flight.cameras = parser.value(options.flight).toStdString();
    flight.folder = parser.value(options.output).toStdString();
    flight.surface = parser.value(options.surface).toStdString();
    bool is_number = false;
    flight.frames = parser.value(options.frames).toInt(&is_number);
    constexpr int kMost = 2000;
    if (!is_number || flight.frames < 1 || flight.frames > kMost) throw usage("frames: between 1 and 2000");
    if (parser.isSet(options.shot)) throw usage("--screenshot or --flight, not both");
    if (flight.cameras.empty() || arguments.site.isEmpty() || flight.folder.empty())
        throw usage("--flight wants CAMERAS.json, -o FOLDER and SITE");
}

} // namespace

DesktopArguments read_desktop_arguments(const QStringList& given) {
    const Options options;
    QCommandLineParser parser;
    parser.setApplicationDescription(q("The stratigraphy of a dig, to see and to draw on."));
    parser.addPositionalArgument(q("SITE"), q("the project file (NAME.gpkg)"));
    parser.addOptions({options.help, options.version, options.shot, options.flight, options.output, options.unit,
                       options.problem, options.frames, options.surface, options.colour, options.size, options.theme,
                       options.language, options.read_only});
    if (!parser.parse(given)) throw usage(parser.errorText().toStdString());
    DesktopArguments arguments;
    arguments.help = parser.isSet(options.help);
    arguments.version = parser.isSet(options.version);
    // Qt knows the program's name only once there is an application, which needs a display.
    arguments.help_text = parser.helpText().replace(q("<executable_name>"), q("planum-desktop"));
    arguments.read_only = parser.isSet(options.read_only);
    read_look(parser, options, arguments);
    if (parser.positionalArguments().size() > 1) throw usage("one project at a time");
    if (!parser.positionalArguments().isEmpty()) arguments.site = parser.positionalArguments().constFirst();
    ScreenshotRequest& shot = arguments.screenshot;
    shot.view = parser.value(options.shot).toStdString();
    shot.output = parser.value(options.output).toStdString();
    shot.unit = parser.value(options.unit).toStdString();
    shot.problem = parser.value(options.problem).toStdString();
    const QSize size = size_from(parser.value(options.size));
    shot.width = arguments.flight.width = size.width();
    shot.height = arguments.flight.height = size.height();
    read_flight(parser, options, arguments);
    if (!shot.view.empty() && (arguments.site.isEmpty() || shot.output.empty()))
        throw usage("--screenshot wants -o FILE and SITE");
    return arguments;
}

} // namespace planum::gui
