// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>

#include <vector>

#include "app/regions/ready_patches.hpp"
#include "gui/viewmodels/outline_tool.hpp"
#include "gui/viewmodels/region_shapes.hpp"
#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

class TimeModel;

/// Ground of the surface that the time line shows that changed and is not outlined yet: looked for beside the window
/// while somebody wants it, offered patch by patch, and taken under a name. What an outline is (unit, category, what it
/// shows) is chosen in the outline tool, for drawn and offered ones alike.
class PatchModel : public QObject {
    Q_OBJECT

  public:
    PatchModel(Workspace& workspace, TimeModel& time, OutlineTool& labels, QObject* parent = nullptr);

    /// A view offers them; another view that did stops.
    void begin(const QString& view);
    void end();

    [[nodiscard]] bool is_active(const QString& view) const { return view_ == view && !view_.isEmpty(); }

    [[nodiscard]] bool is_looking() const noexcept { return looking_; }

    [[nodiscard]] const std::vector<app::ReadyPatch>& patches() const noexcept { return patches_; }

    /// The same in plan, in their order: site coordinates (x, y) [m].
    [[nodiscard]] const std::vector<RegionShape>& shapes() const noexcept { return shapes_; }

    /// Position in patches(); -1: none.
    [[nodiscard]] int chosen() const noexcept { return chosen_; }

    /// The outline tool gets the number that is proposed for it.
    void choose(int patch);

    [[nodiscard]] bool can_finish() const;

    /// The chosen patch becomes an outline of what the outline tool says, as one undo step.
    void finish();

    /// What there is, or of the chosen one how large it is, how far the ground went and why this number.
    [[nodiscard]] QString sentence() const;

  signals:
    void changed();

  private:
    void look();
    void forget();

    Workspace& workspace_;
    TimeModel& time_;
    OutlineTool& labels_;
    QString view_;
    bool looking_ = false;
    std::vector<app::ReadyPatch> patches_;
    std::vector<RegionShape> shapes_;
    QStringList notes_;
    QString trouble_;
    int chosen_ = -1;
};

} // namespace planum::gui
