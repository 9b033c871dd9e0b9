// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

#include "gui/render/camera.hpp"
#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

/// The cameras that were placed for a flight. They are kept in `NAME.flight.json` beside the project, not in it: a way
/// of looking is no record. Each change reads the file, changes it and writes it, so that two windows add to one
/// flight; where it cannot be written, the cameras stay in the window and a sentence says so.
class FlightCameras : public QObject {
    Q_OBJECT

  public:
    explicit FlightCameras(Workspace& workspace);

    [[nodiscard]] const std::vector<Camera>& placed() const noexcept { return placed_; }

    /// Keeps a camera as the next place of the flight.
    void place(const Camera& camera);
    void forget();
    /// Undoes the last of these changes, as long as nobody else changed the file since; any number of times.
    void take_back();

    /// What take_back() would undo; empty: nothing.
    [[nodiscard]] QString former_label() const;

  signals:
    void placedChanged();
    void troubled(const QString& sentence);

  private:
    using Cameras = std::vector<Camera>;
    /// The cameras as they shall be, from those in the file; nullopt: leave them as they are.
    using Change = std::function<std::optional<Cameras>(const Cameras& now)>;

    struct Step {
        QString label;
        Cameras before;
        Cameras after;
    };

    enum class Undoable { Yes, No };
    void load();
    void clear();
    void change(const QString& label, Undoable undoable, Change work);
    void take(const QString& label, Undoable undoable, const Cameras& before, const Cameras& after);

    Workspace& workspace_;
    Cameras placed_;
    std::vector<Step> steps_;
};

} // namespace planum::gui
