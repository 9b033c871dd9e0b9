// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

#include "core/geometry/map_sheet.hpp"
#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

/// Sections to look at: those of the record, and cuts through the middle of the trench, so that there is one before
/// anybody has drawn any. Below the outlines stands what the scans show near the plane (5 cm), looked for beside the
/// window.
class SectionModel : public QObject {
    Q_OBJECT

  public:
    struct Choice {
        QString name;
        model::Section section; ///< with a nil id: a cut, which is not in the record
        double depth = 0.05;    ///< what scans show so far before and behind it [m]
    };

    explicit SectionModel(Workspace& workspace, QObject* parent = nullptr);

    void set_watched(bool watched);

    [[nodiscard]] const std::vector<Choice>& choices() const noexcept { return choices_; }

    /// -1: there are none.
    [[nodiscard]] int chosen() const noexcept { return chosen_; }

    void choose(int choice);
    /// Shows a cut that somebody laid elsewhere, as one more choice until the project is closed or another is laid.
    void show_cut(const model::Section& cut, double depth);

    [[nodiscard]] std::optional<model::Section> section() const;

    /// Where a section runs in plan.
    struct Line {
        QPointF from;
        QPointF to;
        QString name;
        bool chosen = false;

        friend bool operator==(const Line&, const Line&) = default;
    };

    /// The sections of the record, and the cut that is looked at.
    [[nodiscard]] std::vector<Line> lines_in_plan() const;

    /// What the scans show, x along the section and y height [m]; null: nothing, or not yet.
    [[nodiscard]] const std::shared_ptr<const geometry::MapSheet>& sheet() const noexcept { return sheet_; }

    [[nodiscard]] bool is_looking() const noexcept { return looking_; }

  signals:
    void changed();

  private:
    void refresh();
    void look();

    Workspace& workspace_;
    std::vector<Choice> choices_;
    int chosen_ = -1;
    std::optional<Choice> laid_; ///< by somebody elsewhere
    bool watched_ = false;
    bool looking_ = false;
    std::shared_ptr<const geometry::MapSheet> sheet_;
    std::optional<model::Section> seen_;     ///< what the sheet shows, or what is looked for
    double seen_depth_ = 0.0;                ///< [m]
    std::vector<model::ScanPose> seen_from_; ///< with the scans standing so
};

/// Cuts from west to east and from south to north through the middle of all outlines on surfaces; without outlines, of
/// all stations on the site grid; empty where there are neither.
[[nodiscard]] std::vector<model::Section> middle_cuts(const model::Record& record);

} // namespace planum::gui
