// SPDX-License-Identifier: MIT
#include "gui/widgets/space/flight_frames.hpp"

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>

#include <algorithm>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "gui/render/flight_file.hpp"
#include "gui/viewmodels/difference_model.hpp"
#include "gui/viewmodels/models.hpp"
#include "gui/viewmodels/space_model.hpp"
#include "gui/viewmodels/words.hpp"
#include "gui/widgets/space/opengl_here.hpp"
#include "gui/widgets/space/space_canvas.hpp"

namespace planum::gui {

namespace {

constexpr int kPatience = 120'000; // [ms] for the first picture; a frame takes as long as it takes
const std::string kAllSurfaces = "all";

void go_to_surface(TimeModel& time, const std::string& name) {
    if (name.empty() || name == kAllSurfaces) return;
    std::vector<std::string> names;
    for (const TimeModel::Stop& stop : time.stops()) {
        if (stop.name == qt(name)) return time.go_to(stop.surface);
        names.push_back(stop.name.toStdString());
    }
    throw Error(ErrorCode::NotFound, fmt::format("no surface {}; there are {}", name, text::join(names, ", ")));
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code trouble;
    std::filesystem::create_directories(folder, trouble);
    if (trouble) throw Error(ErrorCode::Io, folder.string() + ": " + trouble.message());
}

// Until the view stands still: what a window that opens does to it would end a flight.
void settle(SpaceCanvas& canvas, JobRunner& jobs, const QString& trouble) {
    QElapsedTimer timer;
    timer.start();
    const auto busy = [&] { return !jobs.is_idle() || canvas.property("busy").toBool(); };
    do {
        QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 50);
        if (!trouble.isEmpty()) throw Error(ErrorCode::Io, trouble.toStdString());
        if (timer.elapsed() > kPatience) throw Error(ErrorCode::Io, "no picture of the scans after two minutes");
    } while (busy());
}

} // namespace

int write_flight(Models& models, const FlightRequest& request, const std::function<void(int, int)>& said) {
    const std::vector<Camera> cameras = read_flight(request.cameras);
    if (cameras.empty()) throw Error(ErrorCode::BadInput, request.cameras.string() + ": no cameras to fly along");
    if (const QString trouble = display_trouble(); !trouble.isEmpty())
        throw Error(ErrorCode::Io, trouble.toStdString());
    make_folder(request.folder);
    go_to_surface(models.time, request.surface);

    SpaceModel space(models.workspace, models.time);
    space.contents().set_all_surfaces(request.surface == kAllSurfaces);
    SpaceCanvas canvas(models.workspace, space);
    QString trouble;
    const auto note = [&](const QString& sentence) { trouble = sentence; };
    QObject::connect(&canvas, &SpaceCanvas::troubled, &canvas, note);
    QObject::connect(&canvas, &SpaceCanvas::unusable, &canvas, note);
    canvas.set_colour(request.colour);
    DifferenceModel difference(models.workspace, models.time);
    QObject::connect(&difference, &DifferenceModel::changed, &canvas,
                     [&] { canvas.set_difference(difference.colours()); });
    difference.set_watched(request.colour == PointColour::Difference);
    canvas.setFixedSize((QSizeF(request.width, request.height) / canvas.devicePixelRatioF()).toSize());
    space.set_watched(true);
    canvas.show();
    settle(canvas, models.workspace.jobs(), trouble);
    if (!space.trouble().isEmpty()) throw Error(ErrorCode::Io, space.trouble().toStdString());
    if (request.colour == PointColour::Difference && difference.colours() == nullptr)
        throw Error(ErrorCode::BadInput, difference.said().toStdString());
    if (!canvas.has_scans()) {
        throw Error(ErrorCode::BadInput, request.surface == kAllSurfaces
                                             ? "no scan is on the site grid: planum register"
                                             : "no scan of this surface is on the site grid: planum register");
    }
    QEventLoop wait;
    int written = 0;
    int wanted = 0;
    FlightWriter& flight = canvas.flight();
    QObject::connect(&flight, &FlightWriter::flying, &wait, [&](int frame, int all) {
        wanted = all;
        said(frame, all);
    });
    QObject::connect(&flight, &FlightWriter::troubled, &wait, note);
    QObject::connect(&canvas, &SpaceCanvas::troubled, &wait, &QEventLoop::quit);
    QObject::connect(&flight, &FlightWriter::flown, &wait, [&](int frames) {
        written = frames;
        QMetaObject::invokeMethod(&wait, &QEventLoop::quit, Qt::QueuedConnection); // after what it was troubled by
    });
    flight.start(cameras, request.folder, request.frames);
    wait.exec();
    if (!trouble.isEmpty()) throw Error(ErrorCode::Io, trouble.toStdString());
    if (written < wanted)
        throw Error(ErrorCode::Io, fmt::format("the flight ended after {} of {} frames", written, wanted));
    return written;
}

} // namespace planum::gui
