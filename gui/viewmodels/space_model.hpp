// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>

#include <array>
#include <memory>
#include <vector>

#include "app/scans/scan_stores.hpp"
#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

class TimeModel;

/// What the 3D view shows: the placed scans of the surface that the time line shows (or of all), and the outlines.
class SpaceModel : public QObject {
    Q_OBJECT

  public:
    struct Outline {
        model::UnitId unit;
        std::vector<std::array<double, 3>> ring; ///< closed, site coordinates [m]
    };

    SpaceModel(Workspace& workspace, TimeModel& time, QObject* parent = nullptr);

    void set_watched(bool watched);
    /// Scans of all surfaces at once instead of those of one.
    void set_all_surfaces(bool all);

    [[nodiscard]] const std::vector<app::PlacedScan>& scans() const noexcept { return *scans_; }

    /// For threads: stays as it is.
    [[nodiscard]] std::shared_ptr<const std::vector<app::PlacedScan>> shared_scans() const noexcept { return scans_; }

    [[nodiscard]] std::vector<Outline> outlines() const;

    /// Whose outlines are shown; nil: none.
    [[nodiscard]] model::SurfaceId surface() const;

    /// The unit whose outline on the current surface holds a place of the site, smallest first; nil: none.
    [[nodiscard]] model::UnitId unit_at(double x, double y) const;

    [[nodiscard]] const QString& trouble() const noexcept { return trouble_; }

    [[nodiscard]] bool is_loading() const noexcept { return loading_; }

  signals:
    /// Other scans.
    void loaded();
    /// Other outlines, or other ones selected.
    void outlinesChanged();

  private:
    void load();

    Workspace& workspace_;
    TimeModel& time_;
    std::shared_ptr<const std::vector<app::PlacedScan>> scans_;
    bool all_ = false;
    bool watched_ = false;
    bool stale_ = true;
    bool loading_ = false;
    QString trouble_;
};

} // namespace planum::gui
