// SPDX-License-Identifier: MIT
#include "gui/viewmodels/job.hpp"

#include <QElapsedTimer>
#include <QEventLoop>
#include <QMetaObject>
#include <QTimer>

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "core/base/error.hpp"
#include "gui/viewmodels/service_sentences.hpp"

namespace planum::gui {

namespace {

constexpr int kLessUrgent = 5; // nice value

// On a tablet's two cores three jobs would leave the window a third of one; on Linux each thread has its own nice
// value. Where it cannot be set, nothing is lost but that.
void make_way_for_the_window() {
    static_cast<void>(setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), kLessUrgent));
}

} // namespace

Job::Job(QString title, Kind kind) : title_(std::move(title)), kind_(kind) {}

void Job::cancel() {
    stop_.request_stop();
    emit progressed();
}

// One thread and what waits for it. The thread ends with the runner.
struct JobRunner::Lane {
    struct Entry {
        std::shared_ptr<Job> job;
        Work work;
        Failed failed;
    };

    QString name;
    std::mutex mutex;
    std::condition_variable_any wake;
    std::deque<Entry> waiting;
    std::shared_ptr<Job> running; ///< window's thread only
    std::jthread thread;          ///< last: joined before what it uses goes
};

// Carries progress over to the window's thread, ten times a second at most.
class JobRunner::Report : public Progress {
  public:
    Report(JobRunner& runner, std::shared_ptr<Job> job)
        : Progress(job->stop_.get_token()), runner_(runner), job_(std::move(job)) {}

    void step(std::string_view name) override {
        step_ = service_sentence(std::string(name));
        send(-1.0);
    }

    void fraction(double done) override {
        const auto now = std::chrono::steady_clock::now();
        if (now - last_ < std::chrono::milliseconds(100)) return;
        last_ = now;
        send(done);
    }

  private:
    void send(double fraction) {
        QMetaObject::invokeMethod(
            &runner_,
            [runner = &runner_, job = job_, step = step_, fraction] {
                job->step_ = step;
                job->fraction_ = fraction;
                emit job->progressed();
                emit runner->changed();
            },
            Qt::QueuedConnection);
    }

    JobRunner& runner_;
    std::shared_ptr<Job> job_;
    QString step_;
    std::chrono::steady_clock::time_point last_;
};

JobRunner::JobRunner(QObject* parent) : QObject(parent) {}

JobRunner::~JobRunner() {
    closing_ = true;
    cancel_all();
    lanes_.clear(); // each thread is asked to stop and waited for
}

JobRunner::Lane& JobRunner::lane_named(const QString& name) {
    for (const auto& lane : lanes_) {
        if (lane->name == name) return *lane;
    }
    auto& lane = *lanes_.emplace_back(std::make_unique<Lane>());
    lane.name = name;
    lane.thread = std::jthread([this, &lane](const std::stop_token& ended) { work_off(lane, ended); });
    return lane;
}

void JobRunner::work_off(Lane& lane, const std::stop_token& ended) {
    make_way_for_the_window();
    for (;;) {
        Lane::Entry entry;
        {
            std::unique_lock lock(lane.mutex);
            if (!lane.wake.wait(lock, ended, [&] { return !lane.waiting.empty(); })) return;
            entry = std::move(lane.waiting.front());
            lane.waiting.pop_front();
        }
        Done done;
        QString error;
        try {
            Report report(*this, entry.job);
            report.check();
            done = entry.work(report);
        } catch (const Error& e) {
            if (e.code() != ErrorCode::Cancelled) error = service_sentence(std::string(e.what()));
        } catch (const std::exception& e) {
            error = service_sentence(std::string(e.what()));
        }
        // The job itself goes where it came from: it is an object of the window's thread.
        QMetaObject::invokeMethod(
            this,
            [this, job = std::move(entry.job), done = std::move(done), error, failed = std::move(entry.failed)] {
                finish(job, done, error, failed);
            },
            Qt::QueuedConnection);
    }
}

// What waits is forgotten, what runs is asked to stop and not listened to.
void JobRunner::drop(Lane& lane) {
    const std::scoped_lock lock(lane.mutex);
    for (const Lane::Entry& entry : lane.waiting) std::erase(jobs_, entry.job);
    lane.waiting.clear();
    for (const auto& other : jobs_) {
        if (other->objectName() != lane.name) continue;
        other->replaced_ = true;
        other->stop_.request_stop();
    }
}

void JobRunner::cancel(const QString& lane_name) {
    const bool any = std::any_of(jobs_.begin(), jobs_.end(),
                                 [&](const std::shared_ptr<Job>& job) { return job->objectName() == lane_name; });
    if (!any) return;
    drop(lane_named(lane_name));
    emit changed();
    if (jobs_.empty()) emit idle();
}

void JobRunner::start(const QString& lane_name, Queueing queueing, const QString& title, Job::Kind kind, Work work,
                      Failed failed) {
    Lane& lane = lane_named(lane_name);
    auto job = std::make_shared<Job>(title, kind);
    if (queueing == Queueing::Newest) drop(lane);
    {
        const std::scoped_lock lock(lane.mutex);
        job->setObjectName(lane_name);
        lane.waiting.push_back({job, std::move(work), std::move(failed)});
    }
    jobs_.push_back(job);
    lane.wake.notify_one();
    emit changed();
}

void JobRunner::finish(const std::shared_ptr<Job>& job, const Done& done, const QString& error, const Failed& failed) {
    if (closing_) return;
    std::erase(jobs_, job);
    if (!job->replaced_ && !error.isEmpty() && failed) failed(error);
    // Work that came to its end although somebody wished to stop it did what it did.
    if (!job->replaced_ && done) done();
    emit changed();
    if (jobs_.empty()) emit idle();
}

void JobRunner::cancel_all() {
    for (const auto& job : std::vector(jobs_)) job->cancel();
}

bool JobRunner::wait_until_idle(int milliseconds) {
    QElapsedTimer timer;
    timer.start();
    while (!is_idle()) {
        if (timer.elapsed() > milliseconds) return false;
        QEventLoop loop;
        QTimer::singleShot(20, &loop, &QEventLoop::quit);
        connect(this, &JobRunner::idle, &loop, &QEventLoop::quit);
        loop.exec();
    }
    return true;
}

} // namespace planum::gui
