// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/base/progress.hpp"

namespace planum::gui {

/// One piece of work away from the window's thread, as the list of jobs shows it. Lives in the window's thread.
class Job : public QObject {
    Q_OBJECT

  public:
    /// Quiet jobs are those nobody asked for by name (drawing, checking): shown as a small sign only.
    enum class Kind { Quiet, Asked };

    Job(QString title, Kind kind);

    [[nodiscard]] const QString& title() const noexcept { return title_; }

    [[nodiscard]] const QString& step() const noexcept { return step_; }

    /// Share done of the step, 0…1; negative: unknown.
    [[nodiscard]] double fraction() const noexcept { return fraction_; }

    [[nodiscard]] Kind kind() const noexcept { return kind_; }

    [[nodiscard]] bool is_cancelling() const noexcept { return stop_.stop_requested(); }

    void cancel();

  signals:
    void progressed();

  private:
    friend class JobRunner;
    QString title_;
    QString step_;
    double fraction_ = -1.0;
    Kind kind_;
    bool replaced_ = false; ///< by a newer one of its lane: what it says counts no more
    std::stop_source stop_;
};

/// Runs work in threads and hands the outcome back in the window's thread.
///
/// Work of one lane runs one after the other in the order it came, lanes run beside each other: what writes the
/// project shares one lane, each kind of reading has its own. With `Newest` a job replaces those of its lane that
/// wait or run: their outcome would be out of date.
class JobRunner : public QObject {
    Q_OBJECT

  public:
    enum class Queueing { InOrder, Newest };

    /// What runs in the thread returns what shall run in the window's thread afterwards.
    using Done = std::function<void()>;
    using Work = std::function<Done(Progress&)>;
    /// Gets a sentence; not called for cancelled work.
    using Failed = std::function<void(const QString&)>;

    explicit JobRunner(QObject* parent = nullptr);
    /// Cancels everything and waits for it; outcomes are thrown away.
    ~JobRunner() override;

    void start(const QString& lane, Queueing queueing, const QString& title, Job::Kind kind, Work work, Failed failed);

    [[nodiscard]] const std::vector<std::shared_ptr<Job>>& jobs() const noexcept { return jobs_; }

    [[nodiscard]] bool is_idle() const noexcept { return jobs_.empty(); }

    /// Gives up what waits or runs in a lane, because nobody wants its outcome any more.
    void cancel(const QString& lane);
    void cancel_all();
    /// Runs the event loop until nothing is left to do; for tests and screenshots. False when it took longer.
    bool wait_until_idle(int milliseconds);

  signals:
    /// A job began, went on or ended.
    void changed();
    void idle();

  private:
    struct Lane;
    class Report;
    void run_next(Lane& lane);
    void work_off(Lane& lane, const std::stop_token& ended);
    void finish(const std::shared_ptr<Job>& job, const Done& done, const QString& error, const Failed& failed);
    Lane& lane_named(const QString& name);
    void drop(Lane& lane);

    std::vector<std::shared_ptr<Job>> jobs_; ///< waiting and running, in the order they came
    std::vector<std::unique_ptr<Lane>> lanes_;
    bool closing_ = false;
};

} // namespace planum::gui
