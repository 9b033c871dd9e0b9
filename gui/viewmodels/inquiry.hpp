// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

#include <filesystem>
#include <functional>
#include <string>

#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

/// What somebody asked the project now and then, in lines.
struct Answer {
    QString title;
    QStringList lines; ///< never empty: nothing to say is said
    std::string file;  ///< what may be saved of it; empty: nothing
    QString file_kind; ///< a filter for its name, `Outlines (*.geojson)`
};

/// Questions that are asked now and then, not kept up to date: is the file sound, in what do two readings or two
/// registrations differ, which ground is not outlined yet. Each reads beside the window and says answered().
class Inquiry : public QObject {
    Q_OBJECT

  public:
    explicit Inquiry(Workspace& workspace, QObject* parent = nullptr);

    /// The field record first, then all readings.
    [[nodiscard]] QStringList readings() const;
    /// Registration runs, the newest last.
    [[nodiscard]] QStringList runs() const;
    /// On which something was recorded or scanned, the newest first.
    [[nodiscard]] QStringList days() const;

    /// Regions as lists call them, `2025-06-01/1005#1`.
    [[nodiscard]] QStringList regions() const;

    /// File, scans and point stores, deeply.
    void verify();
    /// The same, and where the file is sound what is kept for nothing is removed.
    void clean();
    /// The points of a region as PLY, in site coordinates.
    void write_region_points(const QString& region, const std::filesystem::path& ply);
    void compare_readings(const QString& first, const QString& second);
    void compare_runs(const QString& first, const QString& second);
    /// `surface` as lists call it; empty: the last one of each area.
    void find_patches(const QString& surface);
    /// Puts a run in force, or takes it out; one undo step.
    void accept_run(const QString& run);
    void discard_run(const QString& run);

  signals:
    void answered(const planum::gui::Answer& answer);

  private:
    using Asked = std::function<Answer(app::Project&, Progress&)>;
    void ask(const QString& title, Asked question);

    Workspace& workspace_;
};

} // namespace planum::gui
