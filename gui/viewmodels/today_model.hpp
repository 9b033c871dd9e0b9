// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

#include <vector>

#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

/// What to do next: units that are open, units that nothing lies on any more, sheets that lack something. Read in a
/// thread after every change, while somebody looks.
class TodayModel : public QObject {
    Q_OBJECT

  public:
    /// A line of one of the lists.
    struct Line {
        QString unit; ///< its name
        QString text; ///< name and definition, or what its sheet lacks
    };

    explicit TodayModel(Workspace& workspace, QObject* parent = nullptr);

    void set_watched(bool watched);

    [[nodiscard]] const std::vector<Line>& open() const noexcept { return open_; }

    [[nodiscard]] const std::vector<Line>& next() const noexcept { return next_; }

    [[nodiscard]] const std::vector<Line>& sheets() const noexcept { return sheets_; }

    /// Selects the unit everywhere; does nothing for a name that is none any more.
    void choose(const QString& unit);

  signals:
    void changed();

  private:
    void read();

    Workspace& workspace_;
    std::vector<Line> open_;
    std::vector<Line> next_;
    std::vector<Line> sheets_;
    bool watched_ = false;
    bool stale_ = true;
};

} // namespace planum::gui
