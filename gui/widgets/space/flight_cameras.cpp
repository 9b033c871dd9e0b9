// SPDX-License-Identifier: MIT
#include "gui/widgets/space/flight_cameras.hpp"

#include <filesystem>
#include <utility>

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "gui/render/flight_file.hpp"

namespace planum::gui {

namespace {

const QString kLane = QStringLiteral("flight cameras");

std::vector<Camera> kept(const std::filesystem::path& file) {
    return std::filesystem::exists(file) ? read_flight(file) : std::vector<Camera>();
}

// Nothing lies about where no camera is.
void keep(const std::filesystem::path& file, const std::vector<Camera>& cameras) {
    if (cameras.empty()) {
        std::error_code none;
        std::filesystem::remove(file, none);
        if (none) throw Error(ErrorCode::Io, file.string() + ": " + none.message());
        return;
    }
    write_file_atomically(file, flight_text(cameras));
}

// Numbers go through the file: what comes out is what is compared.
bool are_same(const std::vector<Camera>& a, const std::vector<Camera>& b) { return flight_text(a) == flight_text(b); }

} // namespace

FlightCameras::FlightCameras(Workspace& workspace) : workspace_(workspace) {
    connect(&workspace_, &Workspace::opened, this, &FlightCameras::load);
    connect(&workspace_, &Workspace::closed, this, &FlightCameras::clear);
    if (workspace_.is_open()) load();
}

void FlightCameras::clear() {
    placed_.clear();
    steps_.clear();
    emit placedChanged();
}

void FlightCameras::load() {
    clear();
    workspace_.jobs().start(
        kLane, JobRunner::Queueing::InOrder, tr("Reading the cameras of the flight"), Job::Kind::Quiet,
        [this, project = workspace_.file()](Progress&) -> JobRunner::Done {
            const Cameras cameras = kept(flight_file_of(project));
            return [this, project, cameras] {
                if (project != workspace_.file() || !placed_.empty()) return;
                placed_ = cameras;
                emit placedChanged();
            };
        },
        [this](const QString& sentence) { emit troubled(sentence); });
}

void FlightCameras::place(const Camera& camera) {
    change(tr("placing a camera"), Undoable::Yes, [camera](Cameras now) {
        now.push_back(camera);
        return std::optional(std::move(now));
    });
}

void FlightCameras::forget() {
    change(tr("forgetting the cameras"), Undoable::Yes, [](const Cameras&) { return std::optional(Cameras()); });
}

QString FlightCameras::former_label() const { return steps_.empty() ? QString() : steps_.back().label; }

void FlightCameras::take_back() {
    if (steps_.empty()) return;
    const Step step = std::move(steps_.back());
    steps_.pop_back();
    change(step.label, Undoable::No, [step](const Cameras& now) {
        return are_same(now, step.after) ? std::optional(step.before) : std::nullopt;
    });
}

void FlightCameras::change(const QString& label, Undoable undoable, Change work) {
    if (!workspace_.is_open()) return;
    const auto here = [this, label, undoable, work](const QString& why) {
        if (const auto after = work(placed_)) take(label, undoable, placed_, *after);
        emit troubled(tr("The cameras stay in this window only: %1").arg(why));
    };
    if (!workspace_.read_only_because().isEmpty()) return here(workspace_.read_only_because());
    workspace_.jobs().start(
        kLane, JobRunner::Queueing::InOrder, tr("Keeping the cameras of the flight"), Job::Kind::Quiet,
        [this, label, undoable, work, project = workspace_.file()](Progress&) -> JobRunner::Done {
            const std::filesystem::path file = flight_file_of(project);
            const Cameras before = kept(file);
            const std::optional<Cameras> after = work(before);
            if (after) keep(file, *after);
            return [this, label, undoable, project, before, after] {
                if (project != workspace_.file()) return;
                take(label, undoable, before, after.value_or(before));
                if (!after) emit troubled(tr("Another window changed the cameras meanwhile; nothing was taken back."));
            };
        },
        here);
}

void FlightCameras::take(const QString& label, Undoable undoable, const Cameras& before, const Cameras& after) {
    if (undoable == Undoable::Yes && !are_same(before, after)) steps_.push_back({label, before, after});
    placed_ = after;
    emit placedChanged();
}

} // namespace planum::gui
