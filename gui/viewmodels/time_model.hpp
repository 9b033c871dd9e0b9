// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <optional>
#include <vector>

#include "core/model/place.hpp"
#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

/// The surfaces of the project as a line in time, and which of them plan, panorama and 3D show.
class TimeModel : public QObject {
    Q_OBJECT

  public:
    struct Stop {
        model::SurfaceId surface;
        QString name;   ///< as lists call it
        QString day;    ///< `2025-06-01`, or from – to
        QString detail; ///< scans, regions, method, in words
        int scans = 0;
        int regions = 0;
    };

    explicit TimeModel(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] const std::vector<Stop>& stops() const noexcept { return stops_; }

    /// Position in stops(); -1: there are none.
    [[nodiscard]] int current() const noexcept { return current_; }

    /// Nil: there are none.
    [[nodiscard]] model::SurfaceId surface() const noexcept;

    void go_to(int stop);
    void go_to(model::SurfaceId surface);

  signals:
    /// The stops are others.
    void changed();
    void moved();

  private:
    void refresh();

    Workspace& workspace_;
    std::vector<Stop> stops_;
    int current_ = -1;
};

} // namespace planum::gui
