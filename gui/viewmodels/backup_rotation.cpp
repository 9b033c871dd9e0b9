// SPDX-License-Identifier: MIT
#include "gui/viewmodels/backup_rotation.hpp"

#include <QDir>

#include <algorithm>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "core/base/sha256.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

namespace {

constexpr std::size_t kHours = 24;
constexpr std::size_t kDays = 14;
constexpr std::size_t kWeeks = 8;
constexpr int kLookEvery = 5 * 60 * 1000; // [ms]
constexpr qint64 kApart = 60 * 60;        // [s]
const QString kForm = QStringLiteral("yyyy-MM-ddTHHmm");
const QString kEnding = QStringLiteral(".gpkg");

// Whether a period has no backup yet and there is room for one more of such periods; takes it.
bool takes(std::set<QString>& periods, const QString& period, std::size_t most) {
    if (periods.contains(period) || periods.size() >= most) return false;
    periods.insert(period);
    return true;
}

} // namespace

QStringList superfluous_backups(const QStringList& names) {
    QStringList sorted;
    for (const QString& name : names) {
        if (QDateTime::fromString(name, kForm).isValid()) sorted << name;
    }
    std::sort(sorted.begin(), sorted.end(), std::greater<>()); // newest first
    std::set<QString> hours;
    std::set<QString> days;
    std::set<QString> weeks;
    QStringList superfluous;
    for (const QString& name : sorted) {
        int year = 0;
        const int week = QDateTime::fromString(name, kForm).date().weekNumber(&year);
        const bool of_hour = takes(hours, name.left(13), kHours);
        const bool of_day = takes(days, name.left(10), kDays);
        const bool of_week = takes(weeks, QStringLiteral("%1-%2").arg(year).arg(week), kWeeks);
        if (!of_hour && !of_day && !of_week) superfluous << name;
    }
    return superfluous;
}

BackupRotation::BackupRotation(Workspace& workspace, std::filesystem::path root, Clock clock, QObject* parent)
    : QObject(parent), workspace_(workspace), root_(std::move(root)), clock_(std::move(clock)) {
    connect(&timer_, &QTimer::timeout, this, &BackupRotation::look);
    connect(&workspace_, &Workspace::opened, this, &BackupRotation::look);
    connect(&workspace_, &Workspace::snapshotChanged, this, &BackupRotation::look);
    timer_.start(kLookEvery);
}

// Projects of one name in two folders keep apart by a hash of the path.
std::filesystem::path BackupRotation::folder() const {
    if (!workspace_.is_open()) return {};
    const std::string hash = sha256(workspace_.file().string()).substr(0, 8);
    return root_ / (workspace_.file().stem().string() + "-" + hash);
}

QStringList BackupRotation::names() const {
    QStringList names;
    for (QString file :
         QDir(qt(folder().string())).entryList({QStringLiteral("*") + kEnding}, QDir::Files, QDir::Name)) {
        file.chop(kEnding.size());
        names << file;
    }
    return names;
}

void BackupRotation::look() {
    if (!workspace_.is_open() || running_ || !workspace_.read_only_because().isEmpty()) return;
    const QStringList there = names();
    std::error_code unknown;
    if (!there.isEmpty()) {
        const QDateTime last = QDateTime::fromString(there.back(), kForm);
        if (last.isValid() && last.secsTo(clock_()) < kApart) return;
        const std::filesystem::path newest = folder() / (there.back() + kEnding).toStdString();
        const bool unchanged = std::filesystem::last_write_time(newest, unknown) >=
                               std::filesystem::last_write_time(workspace_.file(), unknown);
        if (!unknown && unchanged) return;
    }
    running_ = true;
    const std::filesystem::path target = folder() / (clock_().toString(kForm) + kEnding).toStdString();
    workspace_.read(
        QStringLiteral("rotation"), tr("Keeping a copy"),
        [this, target](app::Project& project, Progress& progress) -> JobRunner::Done {
            std::filesystem::create_directories(target.parent_path());
            project.file().backup(target, progress);
            return [this] {
                running_ = false;
                for (const QString& name : superfluous_backups(names())) {
                    std::error_code left;
                    std::filesystem::remove(folder() / (name + kEnding).toStdString(), left);
                }
            };
        },
        [this](const QString& sentence) {
            running_ = false;
            if (!said_) workspace_.say(tr("No copy of the project could be kept: %1").arg(sentence));
            said_ = true;
        });
}

} // namespace planum::gui
