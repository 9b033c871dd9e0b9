// SPDX-License-Identifier: MIT
#pragma once

#include <QDateTime>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include <filesystem>
#include <functional>

#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

/// Of backups named after their time (`2025-06-01T0830`), those that newer ones make superfluous: kept are the newest
/// of each of the last 24 hours, 14 days and 8 weeks that have any. Names that are no times are nobody's business.
[[nodiscard]] QStringList superfluous_backups(const QStringList& names);

/// Keeps copies of the open project where the program keeps its own data, never beside the project, which may lie on a
/// stick: one when a project is opened that was changed since the last, then at most one an hour while it changes. Old
/// ones go. Copies are checked as all backups are; a copy that cannot be made is said once.
class BackupRotation : public QObject {
    Q_OBJECT

  public:
    using Clock = std::function<QDateTime()>;

    BackupRotation(Workspace& workspace, std::filesystem::path root, Clock clock = QDateTime::currentDateTime,
                   QObject* parent = nullptr);

    /// Where the copies of the open project lie; empty: none is open.
    [[nodiscard]] std::filesystem::path folder() const;

    /// Makes a copy if one is due.
    void look();

  private:
    [[nodiscard]] QStringList names() const;

    Workspace& workspace_;
    std::filesystem::path root_;
    Clock clock_;
    QTimer timer_;
    bool running_ = false;
    bool said_ = false;
};

} // namespace planum::gui
