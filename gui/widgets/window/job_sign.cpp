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
    connect(&jobs_, &JobRunner::changed, this, &JobSign::refresh);
    refresh();
}

void JobSign::refresh() {
    const Job* shown = nullptr;
    for (const auto& job : jobs_.jobs()) {
        if (shown == nullptr || (shown->kind() == Job::Kind::Quiet && job->kind() == Job::Kind::Asked))
            shown = job.get();
    }
    setVisible(shown != nullptr);
    if (shown == nullptr) return;
    QString text = shown->title();
    if (!shown->step().isEmpty()) text += QStringLiteral(": ") + shown->step();
    if (shown->is_cancelling()) text = tr("stopping …");
    text_->setText(text);
    bar_->setRange(0, shown->fraction() < 0.0 ? 0 : 100);
    bar_->setValue(static_cast<int>(100.0 * shown->fraction()));
    cancel_->setVisible(shown->kind() == Job::Kind::Asked);
}

} // namespace planum::gui
