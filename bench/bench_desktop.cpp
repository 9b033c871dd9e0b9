// SPDX-License-Identifier: MIT
// The window: how soon a large project can be worked on, how long the window is deaf meanwhile, frames of 3D while the
// camera moves and points once it stands still. Wants a display: xvfb-run -s "-screen 0 1680x1100x24".
// Then zooming and moving in matrix and panorama, and another theme.
// Usage: bench_desktop [MILLION_POINTS [FOLDER [UNITS]]]: points of the scans (8), units (5000); the project is made in
// FOLDER, or taken from there where an earlier run left it, because 100 million points take minutes to add.
#include <QApplication>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QTableView>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "app/demo/record_generator.hpp"
#include "app/scans/add_scans.hpp"
#include "bench/bench_support.hpp"
#include "gui/widgets/space/space_canvas.hpp"
#include "gui/widgets/theme.hpp"
#include "gui/widgets/window/main_window.hpp"

using namespace planum;
using namespace planum::gui;
namespace fs = std::filesystem;

namespace {

constexpr int kSurfaces = 100;
constexpr int kScans = 4;
constexpr int kPatience = 600'000; // [ms]

template<class Values>
void insert_all(app::Project& project, const Values& values) {
    for (const auto& value : values) project.file().insert(value);
}

// Units with sheets, levels, finds and phases; 100 surfaces with the outlines of ten units each.
void write_record(app::Project& project, int units) {
    app::RecordOptions options;
    options.units = static_cast<std::size_t>(units);
    const model::Record record = app::generate_record(options).record;
    project.change("Import", [&] {
        insert_all(project, record.sources);
        insert_all(project, record.areas);
        insert_all(project, record.periods);
        insert_all(project, record.phases);
        insert_all(project, record.groups);
        insert_all(project, record.units);
        insert_all(project, record.relations);
        insert_all(project, record.statements);
        insert_all(project, record.levels);
        insert_all(project, record.finds);
        insert_all(project, record.datings);
        for (int s = 0; s < kSurfaces; ++s) {
            model::Surface surface;
            surface.area = record.areas.front().id;
            surface.first_day = fmt::format("2025-{:02}-{:02}", 1 + s / 25, 1 + s % 25);
            surface.order = s;
            surface.id = project.file().insert(surface);
            for (int r = 0; r < 10; ++r) {
                model::Region region;
                region.surface = surface.id;
                region.unit = record.units[static_cast<std::size_t>(s * 10 + r)].id;
                const double x = r % 5 * 2.0;
                const double y = r / 5 * 2.0;
                region.outline = {
                    {{{x, y, 50.0}, {x + 1.8, y, 50.0}, {x + 1.8, y + 1.8, 50.0}, {x, y + 1.8, 50.0}}, {}}};
                project.file().insert(region);
            }
        }
    });
}

// A rolling field of 20 by 20 m, as PLY.
void write_scan(const fs::path& file, std::int64_t points, int number) {
    std::ofstream out(file, std::ios::binary);
    out << "ply\nformat binary_little_endian 1.0\nelement vertex " << points
        << "\nproperty float x\nproperty float y\nproperty float z\nproperty float intensity\nend_header\n";
    const auto side = static_cast<std::int64_t>(std::sqrt(static_cast<double>(points)));
    std::vector<float> row;
    std::int64_t written = 0;
    for (std::int64_t r = 0; written < points; ++r) {
        row.clear();
        for (std::int64_t c = 0; c < side && written < points; ++c, ++written) {
            const float x = 20.0F * static_cast<float>(c) / static_cast<float>(side) - 10.0F;
            const float y = 20.0F * static_cast<float>(r) / static_cast<float>(side) - 10.0F;
            const float z = 0.4F * std::sin(x + static_cast<float>(number)) * std::cos(0.7F * y);
            row.insert(row.end(), {x, y, z, 0.5F + 0.4F * std::sin(9.0F * x * y)});
        }
        out.write(reinterpret_cast<const char*>(row.data()), static_cast<std::streamsize>(row.size() * sizeof(float)));
    }
}

void write_scans(app::Project& project, const fs::path& folder, std::int64_t points) {
    fs::create_directories(folder);
    std::vector<fs::path> files;
    for (int i = 0; i < kScans; ++i) {
        files.push_back(folder / fmt::format("station{}.ply", i + 1));
        write_scan(files.back(), points / kScans, i);
    }
    app::AddScansOptions options;
    options.day = "2025-06-01";
    app::add_scans(project, files, options, Progress::none());
    const std::vector<model::Scan> scans = project.record().scans;
    project.change("Place", [&] {
        model::RegistrationRun run;
        run.name = "bench";
        run.state = "accepted";
        run.made_at = project.clock().now();
        const model::RegistrationRunId id = project.file().insert(run);
        for (std::size_t i = 0; i < scans.size(); ++i) {
            model::ScanPose pose;
            pose.scan = scans[i].id;
            pose.run = id;
            pose.site_from_scan = {1, 0, 0, 10.0 + 0.5 * static_cast<double>(i), 0, 1, 0, 10, 0, 0, 1, 50, 0, 0, 0, 1};
            project.file().insert(pose);
        }
    });
}

// Longest time between two turns of the event loop: for so long nothing that was pressed was answered.
class Pulse {
  public:
    Pulse() {
        since_.start();
        beat_.start(0);
        QObject::connect(&beat_, &QTimer::timeout, [this] { longest_ = std::max(longest_, since_.restart()); });
    }

    [[nodiscard]] qint64 longest() const noexcept { return longest_; } ///< [ms]

  private:
    QTimer beat_;
    QElapsedTimer since_;
    qint64 longest_ = 0;
};

// Says with PLANUM_BENCH_SLOW=MILLISECONDS which single events took longer: who got them, of what type.
class TracingApplication : public QApplication {
  public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override {
        if (limit_ <= 0) return QApplication::notify(receiver, event);
        const QByteArray who = receiver->metaObject()->className() + QByteArray(" ") + receiver->objectName().toUtf8();
        const QEvent::Type type = event->type(); // both may be gone afterwards
        QElapsedTimer timer;
        timer.start();
        const bool taken = QApplication::notify(receiver, event);
        if (timer.elapsed() > limit_)
            fmt::print("  {} ms: event {} for {}\n", timer.elapsed(), static_cast<int>(type), who.toStdString());
        return taken;
    }

  private:
    int limit_ = qEnvironmentVariableIntValue("PLANUM_BENCH_SLOW");
};

// Notes when something was painted: grab() would paint the whole window once more and count as a pause of its own.
class Painted : public QObject {
  public:
    explicit Painted(QWidget& watched) { watched.installEventFilter(this); }

    bool seen = false;

  protected:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::Paint) seen = true;
        return false;
    }
};

double seconds_until(const std::function<bool()>& reached) {
    QElapsedTimer timer;
    timer.start();
    while (!reached() && timer.elapsed() < kPatience) QApplication::processEvents(QEventLoop::AllEvents, 5);
    return static_cast<double>(timer.nsecsElapsed()) / 1e9;
}

void measure_opening(MainWindow& window, const fs::path& site) {
    auto* list = window.findChild<QTableView*>(QStringLiteral("unitTable"));
    Pulse pulse;
    QElapsedTimer timer;
    timer.start();
    window.open(site, store::OpenMode::ReadWrite);
    Workspace& workspace = window.models().workspace;
    seconds_until([&] {
        return workspace.is_open() &&
               list->model()->rowCount() == static_cast<int>(workspace.snapshot()->record().units.size());
    });
    Painted painted(*list->viewport());
    list->viewport()->update();
    seconds_until([&] { return painted.seen; });
    fmt::print("units listed and painted: {:.2f} s\n", static_cast<double>(timer.elapsed()) / 1e3);
    seconds_until([&] { return window.models().problems.is_checked(); });
    fmt::print("checked: {:.2f} s\n", static_cast<double>(timer.elapsed()) / 1e3);
    seconds_until([&] { return window.models().workspace.jobs().is_idle(); });
    fmt::print("matrix drawn, all at rest: {:.2f} s\n", static_cast<double>(timer.elapsed()) / 1e3);
    fmt::print("longest time without an answer: {} ms\n", pulse.longest());
}

void measure_space(MainWindow& window) {
    Pulse showing;
    window.show_view("3d");
    QApplication::processEvents();
    auto* canvas = window.findChild<SpaceCanvas*>();
    if (canvas == nullptr) return fmt::print("no OpenGL here: 3D not measured\n"), void();
    window.resize(window.size() + QSize(1600, 1000) - canvas->size()); // 1600 x 1000 for the drawing itself
    seconds_until([&] { return canvas->drawn_points() >= 250'000; });
    fmt::print("3d: shown for the first time, longest time without an answer: {} ms\n", showing.longest());
    seconds_until([&] { return canvas->drawn_points() > 300'000; }); // the still picture is out of the way
    std::vector<double> frames;
    std::size_t least = SIZE_MAX;
    Painted painted(*canvas);
    bool came = false;
    QObject::connect(canvas, &SpaceCanvas::framed, canvas, [&] {
        came = true;
        painted.seen = false; // by the picture that is there now
    });
    Pulse moving;
    QElapsedTimer timer;
    timer.start();
    for (int i = 0; i < 30; ++i) { // a step with each picture that is seen
        came = false;
        QKeyEvent key(QEvent::KeyPress, Qt::Key_Left, {});
        QApplication::sendEvent(canvas, &key);
        seconds_until([&] { return came && painted.seen; });
        frames.push_back(canvas->frame_milliseconds());
        least = std::min(least, canvas->drawn_points());
    }
    const double rate = 30.0 / (static_cast<double>(timer.nsecsElapsed()) / 1e9);
    std::sort(frames.begin(), frames.end());
    fmt::print("moving, {} x {}: {} points a frame, {:.1f} frames/s, slowest frame {:.0f} ms; longest time without an "
               "answer: {} ms\n",
               canvas->width(), canvas->height(), least, rate, frames.back(), moving.longest());
    Pulse pulse;
    const double still = seconds_until([&] { return canvas->drawn_points() > 300'000; });
    fmt::print("standing still: {} points after {:.2f} s; longest time without an answer: {} ms\n",
               canvas->drawn_points(), still, pulse.longest());
}

// Zooms in step by step and moves at each, then out again, as the keys do; each frame painted at once.
void measure_moving_about(MainWindow& window, const char* view, const char* canvas_name) {
    Pulse pulse;
    QElapsedTimer timer;
    timer.start();
    window.show_view(view);
    QApplication::processEvents();
    seconds_until([&] { return window.models().workspace.jobs().is_idle(); });
    auto* canvas = window.findChild<QWidget*>(QString::fromLatin1(canvas_name));
    if (canvas == nullptr) return fmt::print("no {}\n", canvas_name), void();
    fmt::print("{}: there after {:.2f} s, longest time without an answer: {} ms\n", view,
               static_cast<double>(timer.elapsed()) / 1e3, pulse.longest());
    std::vector<double> frames;
    const auto press = [&](int key) {
        QElapsedTimer frame;
        frame.start();
        QKeyEvent event(QEvent::KeyPress, key, {});
        QApplication::sendEvent(canvas, &event);
        canvas->repaint();
        frames.push_back(static_cast<double>(frame.nsecsElapsed()) / 1e6);
    };
    for (const int zoom : {Qt::Key_Plus, Qt::Key_Minus}) {
        for (int i = 0; i < 20; ++i) {
            press(zoom);
            if (canvas_name == std::string_view("panoramaCanvas")) press(i % 2 == 0 ? Qt::Key_Right : Qt::Key_Down);
        }
    }
    std::sort(frames.begin(), frames.end());
    fmt::print("  {} x {}: {} frames, median {:.0f} ms, slowest {:.0f} ms\n", canvas->width(), canvas->height(),
               frames.size(), frames[frames.size() / 2], frames.back());
}

// With all views made and seen, as late in the day.
void measure_themes(MainWindow& window) {
    for (const char* view : {"section", "plan", "records", "scans", "today", "history", "suggestions", "problems"}) {
        window.show_view(view);
        seconds_until([&] { return window.models().workspace.jobs().is_idle(); });
    }
    for (const ThemeKind kind : {ThemeKind::Dark, ThemeKind::Sunlight, ThemeKind::Light}) {
        Pulse pulse;
        QElapsedTimer timer;
        timer.start();
        QTimer::singleShot(0, qApp, [kind] { apply_theme(kind, StyledParts::Pace::InTurns); });
        seconds_until([&] { return timer.elapsed() > 500; });
        fmt::print("theme {}: longest time without an answer: {} ms\n", to_word(kind).toStdString(), pulse.longest());
    }
}

} // namespace

int main(int argc, char** argv) {
    const std::int64_t points = 1'000'000LL * (argc > 1 ? std::atoi(argv[1]) : 8);
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
    const int units = argc > 3 ? std::atoi(argv[3]) : 5000;
    const TracingApplication application(argc, argv);
    apply_theme(ThemeKind::Light);
    const bench::Scratch scratch;
    const fs::path folder = argc > 2 ? fs::path(argv[2]) : scratch / "";
    fs::create_directories(folder);
    const fs::path site = folder / "site.gpkg";
    if (fs::exists(site)) {
        fmt::print("{}\n{} as an earlier run left it\n", bench::machine(), site.string());
    } else {
        app::Project project = app::Project::create(site, {}, {"bench"});
        write_record(project, units);
        QElapsedTimer timer;
        timer.start();
        write_scans(project, folder / "2025-06-01", points);
        fmt::print("{}\n{} units, {} surfaces, {} scans with {} million points (added in {:.0f} s)\n", bench::machine(),
                   units, kSurfaces + 1, kScans, points / 1'000'000, static_cast<double>(timer.elapsed()) / 1e3);
    }
    MainWindow window(app::Session{"bench"});
    window.resize(1600, 1000);
    window.show();
    QApplication::processEvents();
    measure_opening(window, site);
    measure_space(window);
    measure_moving_about(window, "matrix", "matrixCanvas");
    measure_moving_about(window, "panorama", "panoramaCanvas");
    measure_themes(window);
    return 0;
}
