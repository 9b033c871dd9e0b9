// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "app/scans/scan_stores.hpp"
#include "gui/viewmodels/space_contents.hpp"
#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

class TimeModel;

/// What the 3D view shows: the placed scans and the outlines that contents() asks for.
class SpaceModel : public QObject {
    Q_OBJECT

  public:
    struct Outline {
        model::UnitId unit;
        std::vector<std::array<double, 3>> ring; ///< closed, site coordinates [m]
    };

    SpaceModel(Workspace& workspace, TimeModel& time, QObject* parent = nullptr);

    void set_watched(bool watched);

    /// Which scans and outlines are shown, and the choice of them.
    [[nodiscard]] SpaceContents& contents() noexcept { return contents_; }

    [[nodiscard]] const std::vector<app::PlacedScan>& scans() const noexcept { return *scans_; }

    /// For threads: stays as it is.
    [[nodiscard]] std::shared_ptr<const std::vector<app::PlacedScan>> shared_scans() const noexcept { return scans_; }

    [[nodiscard]] std::vector<Outline> outlines() const;

    /// Which of the days of all scans of the site a day is, from 0: its colour stays when others are shown.
    [[nodiscard]] std::size_t place_of_day(const std::string& day) const;

    /// The surface that the time line stands on; nil: none.
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
    SpaceContents contents_;
    std::shared_ptr<const std::vector<app::PlacedScan>> scans_;
    bool watched_ = false;
    bool stale_ = true;
    bool loading_ = false;
    QString trouble_;
};

} // namespace planum::gui
