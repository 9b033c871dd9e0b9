// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "gui/viewmodels/workspace.hpp"

namespace planum::app {
struct RegistrationReport;
}

namespace planum::gui {

/// What an import would do, in words, before anything is written.
struct ImportPreview {
    QStringList fresh;          ///< new and filled
    QStringList changed;        ///< conflicts: what stands, what the file says
    QStringList not_understood; ///< warnings and notes of the readers
    bool changes = false;
};

/// What a file that was dropped on the window, or chosen, is for.
enum class FileUse { Project, Scans, Outlines, Lists };

/// By name and kind alone: folders and scan endings are scans, `.gpkg` a project, `.geojson` outlines, all else lists.
[[nodiscard]] FileUse use_of(const std::filesystem::path& file);

/// The long jobs of a day: import, scans, registration, outlines, survey, backup. Each is one undo step and can be
/// stopped.
class DayJobs : public QObject {
    Q_OBJECT

  public:
    using Files = std::vector<std::filesystem::path>;

    explicit DayJobs(Workspace& workspace, QObject* parent = nullptr);

    /// Reads the files and says previewed(); writes nothing.
    void preview_import(const Files& files, bool update);
    void import(const Files& files, bool update);
    void add_scans(const Files& inputs, const std::string& day);
    void import_outlines(const Files& files);
    /// Levels and finds from total stations and drawings.
    void import_survey(const Files& files);
    void import_markers(const std::filesystem::path& file);
    /// Puts the scans on the site grid that are not there yet; with a day, all of that day anew.
    void register_scans(const std::string& day);
    void backup(const std::filesystem::path& target);

  signals:
    void previewed(const planum::gui::ImportPreview& preview);
    /// The files could not be read, and why; comes besides what the workspace says.
    void notPreviewed(const QString& sentence);
    /// How many scans were placed, then a line for each that was not, or with doubt.
    void registered(const QStringList& lines);
    /// One sentence about what was done.
    void done(const QString& sentence);

  private:
    /// What was done, in one sentence.
    using Said = std::function<QString(app::Project&, Progress&)>;

    /// One long job of the day, beside the window; what it says comes with done().
    void run(const QString& title, Said work);
    void keep_registration(const std::shared_ptr<app::RegistrationReport>& report);

    Workspace& workspace_;
};

} // namespace planum::gui
