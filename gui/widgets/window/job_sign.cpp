// SPDX-License-Identifier: MIT
#include "gui/widgets/window/job_sign.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "gui/viewmodels/job.hpp"

namespace planum::gui {

JobSign::JobSign(JobRunner& jobs)
    : jobs_(jobs), text_(new QLabel), bar_(new QProgressBar), cancel_(new QPushButton(tr("Stop"))) {
    setObjectName(QStringLiteral("jobs"));
    bar_->setFixedWidth(140);
    bar_->setTextVisible(false);
    bar_->setMaximumHeight(12);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 8, 0);
    row->addWidget(text_);
    row->addWidget(bar_);
    row->addWidget(cancel_);
    connect(cancel_, &QPushButton::clicked, &jobs_, &JobRunner::cancel_all);
    patience_.setSingleShot(true);
    patience_.setInterval(1000);
    connect(&patience_, &QTimer::timeout, this, &JobSign::say);
    connect(&jobs_, &JobRunner::changed, this, &JobSign::refresh);
    refresh();
}

const Job* JobSign::worth_saying() const {
    const Job* best = nullptr;
    for (const auto& job : jobs_.jobs()) {
        if (best == nullptr || (best->kind() == Job::Kind::Quiet && job->kind() == Job::Kind::Asked)) best = job.get();
    }
    return best;
}

void JobSign::refresh() {
    const Job* job = worth_saying();
    if (job == nullptr) {
        patience_.stop();
        hide();
    } else if (job->kind() == Job::Kind::Asked || !isHidden()) {
        say();
    } else if (!patience_.isActive()) {
        patience_.start();
    }
}

void JobSign::say() {
    const Job* job = worth_saying();
    if (job == nullptr) return;
    QString text = job->title();
    if (!job->step().isEmpty()) text += QStringLiteral(": ") + job->step();
    if (job->is_cancelling()) text = tr("stopping …");
    text_->setText(text);
    // A bar that only runs to and fro is redrawn thirty times a second, and with 3D in the window the graphics driver
    // puts all of it together each time: without a graphics card that is half of the machine.
    const bool known = job->fraction() >= 0.0;
    bar_->setVisible(known || job->kind() == Job::Kind::Asked);
    bar_->setRange(0, known ? 100 : 0);
    bar_->setValue(static_cast<int>(100.0 * job->fraction()));
    cancel_->setVisible(job->kind() == Job::Kind::Asked);
    show();
}

} // namespace planum::gui
