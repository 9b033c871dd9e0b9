// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "app/project/project.hpp"
#include "app/project/snapshot.hpp"
#include "core/model/diagnostic.hpp"
#include "gui/viewmodels/job.hpp"

class QFileSystemWatcher;
class QLockFile;
class QTimer;

namespace planum::gui {

/// What a problem or a suggestion rests on: every view shows of it what it can.
struct Proof {
    std::vector<model::UnitId> units;
    std::vector<model::NamedRelation> relations;
};

/// The project that all views of one window look at: the file behind a thread of its own, the record as it stands
/// now, what is selected, and what of it proves the problem that is open.
///
/// Nothing here waits: edits are handed to the thread that holds the file, and when they are done a new snapshot
/// comes. Trouble comes as one sentence with failed().
class Workspace : public QObject {
    Q_OBJECT

  public:
    using SnapshotPtr = std::shared_ptr<const app::Snapshot>;
    using Edit = std::function<void(app::Project&, Progress&)>;
    /// Reads with a project of its own; what it returns runs in the window's thread.
    using Reading = std::function<JobRunner::Done(app::Project&, Progress&)>;

    explicit Workspace(app::Session session = {}, QObject* parent = nullptr);
    ~Workspace() override;

    /// Whatever was open is closed. Says opened() or failed(); noted() where another window has it open as well.
    void open(const std::filesystem::path& file, store::OpenMode mode);
    /// For a picture of the window: nothing can be written, and yet it looks as it does for whoever may.
    void open_for_picture(const std::filesystem::path& file);
    void create(const std::filesystem::path& file, const model::ProjectSettings& settings);
    void close();

    [[nodiscard]] bool is_open() const noexcept { return snapshot_ != nullptr; }

    /// Why nothing can be changed; empty where it can.
    [[nodiscard]] const QString& read_only_because() const noexcept { return read_only_because_; }

    [[nodiscard]] const std::filesystem::path& file() const noexcept { return file_; }

    /// Never null while is_open().
    [[nodiscard]] const SnapshotPtr& snapshot() const noexcept { return snapshot_; }

    [[nodiscard]] JobRunner& jobs() noexcept { return jobs_; }

    /// Runs in the thread that holds the file. `done` runs here afterwards, with the new snapshot in place; `failed`
    /// here too, besides what failed() says.
    void edit(const QString& title, Edit work, std::function<void()> done = {}, Job::Kind kind = Job::Kind::Quiet,
              JobRunner::Failed failed = {});

    /// Quiet edits wait or run: what somebody did is not in the file yet.
    [[nodiscard]] bool is_saving() const;
    /// Runs beside it, on a connection of its own. Of one lane only the newest reading counts.
    void read(const QString& lane, const QString& title, Reading work, JobRunner::Failed failed = {},
              Job::Kind kind = Job::Kind::Quiet);
    /// For what takes minutes and writes in one transaction at its end: runs beside the thread that holds the file, on
    /// a writing connection of its own, so that edits go on meanwhile; one such work after the other.
    void work(const QString& title, Edit work, std::function<void()> done = {});

    void undo();
    void redo();
    /// What undo or redo would do; empty: nothing to do.
    [[nodiscard]] QString undo_label() const;
    [[nodiscard]] QString redo_label() const;

    [[nodiscard]] model::UnitId selected() const noexcept { return selected_; }

    void select(model::UnitId unit);

    [[nodiscard]] const Proof& proof() const noexcept { return proof_; }

    void show_proof(Proof proof);

    /// Says a sentence in the window.
    void say(const QString& sentence) { emit failed(sentence); }

  signals:
    void opened();
    void closed();
    void snapshotChanged();
    void selectionChanged();
    void proofChanged();
    /// Something could not be done: one plain sentence.
    void failed(const QString& sentence);
    /// What failed() said with this sentence holds no longer: the record is written and read again.
    void overcome(const QString& sentence);
    /// What opening found, a file changed by another program, …
    void noted(const QString& sentence);

  private:
    struct Holder;
    void start_opening(const QString& title, std::function<app::Project()> make);
    void take(SnapshotPtr snapshot);
    void end_trouble(QString& trouble);
    void watch();
    void show_presence();
    void look_at_file();
    [[nodiscard]] bool may_write();
    enum class Reread { WhenOlder, Always };
    void read_again(Reread when, std::function<void()> done);

    app::Session session_;
    std::shared_ptr<Holder> holder_;
    std::filesystem::path file_;
    QString read_only_because_;
    QString unwritten_; ///< why the last edit is not in the file; said, and not over yet
    QString unread_;    ///< why the file cannot be read; said, and not over yet
    SnapshotPtr snapshot_;
    model::UnitId selected_;
    Proof proof_;
    std::vector<std::weak_ptr<bool>> saving_; ///< gone with the edit
    std::unique_ptr<QLockFile> presence_;     ///< tells other windows on this machine that the project is open
    QFileSystemWatcher* watcher_ = nullptr;
    QTimer* look_soon_ = nullptr;
    JobRunner jobs_; ///< last: its threads end before what they use goes
};

} // namespace planum::gui
