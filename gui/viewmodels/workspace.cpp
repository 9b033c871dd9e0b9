// SPDX-License-Identifier: MIT
#include "gui/viewmodels/workspace.hpp"

#include <unistd.h>

#include <QCryptographicHash>
#include <QDir>
#include <QFileSystemWatcher>
#include <QLockFile>
#include <QTimer>

#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "gui/viewmodels/change_labels.hpp"
#include "gui/viewmodels/service_sentences.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

namespace {

const QString kRecordLane = QStringLiteral("record");
const QString kWorkLane = QStringLiteral("work");
constexpr int kLookAfter = 400;  // [ms] after the file system spoke
constexpr int kLookEvery = 2000; // [ms] QGIS writes beside the file, where a watcher is told of the first time only

// When the project was written last, in the file or in the log that QGIS writes beside it while it edits.
struct Stamp {
    std::filesystem::file_time_type file;
    std::filesystem::file_time_type log;
    std::uintmax_t log_size = 0;

    friend bool operator==(const Stamp&, const Stamp&) = default;
};

Stamp stamp_of(const std::filesystem::path& file) {
    Stamp stamp;
    std::error_code trouble;
    stamp.file = std::filesystem::last_write_time(file, trouble);
    const std::filesystem::path log = file.string() + "-wal";
    const std::uintmax_t size = std::filesystem::file_size(log, trouble);
    if (trouble || size == 0) return stamp; // none, or one that holds nothing
    stamp.log_size = size;
    stamp.log = std::filesystem::last_write_time(log, trouble);
    return stamp;
}

} // namespace

// Lives in the record lane only; the window's thread just holds on to it.
struct Workspace::Holder {
    std::optional<app::Project> project;
    store::OpenMode mode = store::OpenMode::ReadWrite;
    Stamp seen;

    void note_time() { seen = stamp_of(project->path()); }
};

Workspace::Workspace(app::Session session, QObject* parent)
    : QObject(parent), session_(std::move(session)), watcher_(new QFileSystemWatcher(this)),
      look_soon_(new QTimer(this)) {
    look_soon_->setSingleShot(true);
    look_soon_->setInterval(kLookAfter);
    connect(look_soon_, &QTimer::timeout, this, &Workspace::look_at_file);
    auto* look_again = new QTimer(this);
    connect(look_again, &QTimer::timeout, this, [this, last = Stamp{}]() mutable {
        if (!is_open()) return;
        if (presence_ != nullptr && !presence_->isLocked()) (void)presence_->tryLock(); // the other window may be gone
        const Stamp now = stamp_of(file_);
        if (now.log_size > 0 && now != last) look_soon_->start();
        last = now;
    });
    look_again->start(kLookEvery);
    connect(watcher_, &QFileSystemWatcher::fileChanged, look_soon_, qOverload<>(&QTimer::start));
    connect(watcher_, &QFileSystemWatcher::directoryChanged, look_soon_, qOverload<>(&QTimer::start));
}

Workspace::~Workspace() = default;

void Workspace::open(const std::filesystem::path& file, store::OpenMode mode) {
    close();
    file_ = std::filesystem::absolute(file);
    holder_ = std::make_shared<Holder>();
    holder_->mode = mode;
    if (mode == store::OpenMode::ReadOnly) read_only_because_ = tr("opened for reading only");
    start_opening(tr("Opening %1").arg(qt(file_.filename().string())),
                  [path = file_, mode, session = session_] { return app::Project::open(path, mode, session); });
}

void Workspace::open_for_picture(const std::filesystem::path& file) {
    open(file, store::OpenMode::ReadOnly);
    read_only_because_.clear();
}

void Workspace::create(const std::filesystem::path& file, const model::ProjectSettings& settings) {
    close();
    file_ = std::filesystem::absolute(file);
    holder_ = std::make_shared<Holder>();
    start_opening(tr("Making %1").arg(qt(file_.filename().string())), [path = file_, settings, session = session_] {
        return app::Project::create(path, settings, session);
    });
}

void Workspace::start_opening(const QString& title, std::function<app::Project()> make) {
    auto work = [this, holder = holder_, make = std::move(make)](Progress&) -> JobRunner::Done {
        holder->project.emplace(make());
        holder->note_time();
        auto snapshot = app::take_snapshot(*holder->project);
        const store::OpenReport report = holder->project->file().open_report();
        return [this, holder, report, snapshot = std::move(snapshot)]() mutable {
            if (holder != holder_) return; // another one was opened meanwhile
            if (report.import_only) {
                read_only_because_ =
                    tr("this file may only be read: %1")
                        .arg(service_sentence(fmt::format("{}", fmt::join(report.import_only_because, "; "))));
            }
            snapshot_ = std::move(snapshot);
            watch();
            emit opened();
            emit snapshotChanged();
            for (const std::string& note : report.notes) emit noted(service_sentence(note));
            show_presence();
        };
    };
    jobs_.start(kRecordLane, JobRunner::Queueing::InOrder, title, Job::Kind::Asked, std::move(work),
                [this, holder = holder_](const QString& sentence) {
                    if (holder != holder_) return;
                    close();
                    emit failed(sentence);
                });
}

void Workspace::close() {
    const bool was_open = is_open();
    jobs_.cancel_all();
    if (!watcher_->files().isEmpty()) watcher_->removePaths(watcher_->files());
    if (!watcher_->directories().isEmpty()) watcher_->removePaths(watcher_->directories());
    holder_.reset();
    file_.clear();
    read_only_because_.clear();
    unwritten_.clear();
    unread_.clear();
    presence_.reset();
    snapshot_.reset();
    selected_ = {};
    proof_ = {};
    if (was_open) emit closed();
}

void Workspace::end_trouble(QString& trouble) {
    if (trouble.isEmpty()) return;
    const QString over = std::exchange(trouble, {});
    emit overcome(over);
}

void Workspace::take(SnapshotPtr snapshot) {
    end_trouble(unread_);
    snapshot_ = std::move(snapshot);
    emit snapshotChanged();
    if (!selected_.is_nil() && snapshot_->index().find(selected_) == model::kNoUnit) select({});
}

bool Workspace::may_write() {
    if (!is_open()) return false;
    if (!read_only_because_.isEmpty()) emit failed(tr("Nothing was changed: %1.").arg(read_only_because_));
    return read_only_because_.isEmpty();
}

bool Workspace::is_saving() const {
    return std::any_of(saving_.begin(), saving_.end(), [](const auto& edit) { return !edit.expired(); });
}

void Workspace::edit(const QString& title, Edit work, std::function<void()> done, Job::Kind kind,
                     JobRunner::Failed failed_too) {
    if (!may_write()) return;
    std::erase_if(saving_, [](const auto& edit) { return edit.expired(); });
    auto saving = std::make_shared<bool>(true);
    if (kind == Job::Kind::Quiet) saving_.push_back(saving);
    auto in_thread = [this, saving, holder = holder_, path = file_, session = session_, work = std::move(work),
                      done = std::move(done)](Progress& progress) -> JobRunner::Done {
        // What another program wrote a moment ago is not seen yet: a record changed as it was read before would take
        // it back.
        if (!holder->project || stamp_of(path) != holder->seen)
            holder->project.emplace(app::Project::open(path, holder->mode, session));
        work(*holder->project, progress);
        holder->note_time();
        return [this, holder, done, snapshot = app::take_snapshot(*holder->project)]() mutable {
            if (holder != holder_) return;
            end_trouble(unwritten_);
            take(std::move(snapshot));
            if (done) done();
        };
    };
    jobs_.start(kRecordLane, JobRunner::Queueing::InOrder, title, kind, std::move(in_thread),
                [this, holder = holder_, failed_too = std::move(failed_too)](const QString& sentence) {
                    unwritten_ = sentence;
                    emit failed(sentence);
                    if (failed_too && holder == holder_) failed_too(sentence);
                });
}

void Workspace::work(const QString& title, Edit work, std::function<void()> done) {
    if (!may_write()) return;
    auto in_thread = [this, holder = holder_, path = file_, session = session_, work = std::move(work),
                      done = std::move(done)](Progress& progress) -> JobRunner::Done {
        {
            app::Project project = app::Project::open(path, store::OpenMode::ReadWrite, session);
            progress.check();
            work(project, progress);
        }
        return [this, holder, done] {
            if (holder == holder_) read_again(Reread::Always, done);
        };
    };
    jobs_.start(kWorkLane, JobRunner::Queueing::InOrder, title, Job::Kind::Asked, std::move(in_thread),
                [this](const QString& sentence) { emit failed(sentence); });
}

void Workspace::read(const QString& lane, const QString& title, Reading work, JobRunner::Failed failed_call,
                     Job::Kind kind) {
    if (!is_open()) return;
    auto in_thread = [path = file_, session = session_, work = std::move(work)](Progress& progress) -> JobRunner::Done {
        app::Project project = app::Project::open(path, store::OpenMode::ReadOnly, session);
        progress.check();
        return work(project, progress);
    };
    if (!failed_call) failed_call = [this](const QString& sentence) { emit failed(sentence); };
    jobs_.start(lane, JobRunner::Queueing::Newest, title, kind, std::move(in_thread), std::move(failed_call));
}

void Workspace::undo() {
    if (undo_label().isEmpty()) return;
    const QString label = undo_label();
    edit(
        tr("Undo: %1").arg(label), [](app::Project& project, Progress&) { project.undo(); },
        [this, label] { emit noted(tr("Undone: %1").arg(label)); });
}

void Workspace::redo() {
    if (redo_label().isEmpty()) return;
    const QString label = redo_label();
    edit(
        tr("Redo: %1").arg(label), [](app::Project& project, Progress&) { project.redo(); },
        [this, label] { emit noted(tr("Done again: %1").arg(label)); });
}

QString Workspace::undo_label() const {
    if (!is_open()) return {};
    for (const store::ChangeEntry& change : snapshot_->changes) {
        if (!change.undone && change.number > 0) return change_label(change.label);
    }
    return {};
}

QString Workspace::redo_label() const {
    if (!is_open()) return {};
    QString label;
    for (const store::ChangeEntry& change : snapshot_->changes) {
        if (change.undone && !change.dropped) label = change_label(change.label); // the oldest of them comes first
    }
    return label;
}

void Workspace::select(model::UnitId unit) {
    if (unit == selected_) return;
    selected_ = unit;
    emit selectionChanged();
}

void Workspace::show_proof(Proof proof) {
    proof_ = std::move(proof);
    emit proofChanged();
}

void Workspace::watch() {
    watcher_->addPath(qt(file_.string()));
    watcher_->addPath(qt(file_.parent_path().string()));
}

// Two windows may work on one project; whoever opens the second one should know. Nothing is locked by it: where the
// sign cannot be put up, nothing is said. Each user has signs of his own: one that another's crashed window left could
// not be taken down.
void Workspace::show_presence() {
    if (holder_->mode != store::OpenMode::ReadWrite || !read_only_because_.isEmpty()) return;
    std::error_code trouble;
    const std::filesystem::path path = std::filesystem::canonical(file_, trouble);
    if (trouble) return;
    const QByteArray name =
        QCryptographicHash::hash(QByteArray::fromStdString(path.string()), QCryptographicHash::Sha1);
    presence_ = std::make_unique<QLockFile>(QDir::temp().filePath(
        QStringLiteral("planum-open-%1-%2").arg(getuid()).arg(QString::fromLatin1(name.toHex().left(16)))));
    presence_->setStaleLockTime(0); // a day in one window is no old age; one that crashed is known by its process
    if (presence_->tryLock() || presence_->error() != QLockFile::LockFailedError) return;
    emit noted(tr("Another window has this project open, too. What either saves, the other shows at once."));
}

// Another program may have written the file, or taken it away.
void Workspace::look_at_file() {
    if (!is_open()) return;
    std::error_code trouble;
    if (!std::filesystem::exists(file_, trouble)) {
        unread_ = tr("%1 is gone. What you see was read before; put the file back, or save a copy elsewhere.")
                      .arg(qt(file_.string()));
        emit failed(unread_);
        return;
    }
    if (watcher_->files().isEmpty()) watcher_->addPath(qt(file_.string()));
    read_again(Reread::WhenOlder,
               [this] { emit noted(tr("Another program changed the project; it was read again.")); });
}

void Workspace::read_again(Reread when, std::function<void()> done) {
    auto work = [this, when, holder = holder_, path = file_, session = session_,
                 done = std::move(done)](Progress&) -> JobRunner::Done {
        if (when == Reread::WhenOlder && stamp_of(path) == holder->seen) {
            return [this, holder] {
                if (holder != holder_ || unread_.isEmpty()) return;
                end_trouble(unread_);   // it is there again, as it was
                emit snapshotChanged(); // for what could not be read meanwhile
            };
        }
        holder->project.emplace(app::Project::open(path, holder->mode, session));
        holder->note_time();
        return [this, holder, done, snapshot = app::take_snapshot(*holder->project)]() mutable {
            if (holder != holder_) return;
            take(std::move(snapshot));
            if (done) done();
        };
    };
    jobs_.start(kRecordLane, JobRunner::Queueing::InOrder, tr("Reading the project again"), Job::Kind::Quiet,
                std::move(work), [this](const QString& sentence) {
                    unread_ = sentence;
                    emit failed(sentence);
                });
}

} // namespace planum::gui
