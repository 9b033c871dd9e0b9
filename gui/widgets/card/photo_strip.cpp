// SPDX-License-Identifier: MIT
#include "gui/widgets/card/photo_strip.hpp"

#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

#include "gui/widgets/card/photo_button.hpp"
#include "gui/widgets/card/photo_window.hpp"
#include "gui/widgets/card/picture_file.hpp"
#include "gui/widgets/flow_layout.hpp"

namespace planum::gui {

namespace {

const QString kLane = QStringLiteral("photos");
constexpr int kGap = 6; // [px]

} // namespace

PhotoStrip::PhotoStrip(Workspace& workspace)
    : workspace_(workspace), heading_(new QLabel(tr("Photos and drawings"))), strip_(new QWidget),
      flow_(new FlowLayout(kGap)), said_(new QLabel) {
    setObjectName(QStringLiteral("photoStrip"));
    heading_->setProperty("role", "heading");
    said_->setObjectName(QStringLiteral("photoTrouble"));
    said_->setProperty("role", "warning");
    said_->setWordWrap(true);
    said_->setTextFormat(Qt::PlainText);
    strip_->setLayout(flow_);
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    strip_->setSizePolicy(policy);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    for (QWidget* part : std::initializer_list<QWidget*>{heading_, strip_, said_}) column->addWidget(part);
    setVisible(false);
}

void PhotoStrip::show_pictures(const std::vector<CardPicture>& pictures) {
    if (pictures == pictures_ && workspace_.file() == project_) return;
    workspace_.jobs().cancel(kLane);
    ++shown_;
    pictures_ = pictures;
    project_ = workspace_.file();
    for (PhotoButton* button : std::exchange(buttons_, {})) {
        flow_->removeWidget(button);
        button->hide();
        button->deleteLater();
    }
    trouble_.assign(pictures_.size(), {});
    say_trouble();
    for (std::size_t at = 0; at < pictures_.size(); ++at) {
        auto* button = new PhotoButton(pictures_[at].title);
        button->setObjectName(QStringLiteral("photo%1").arg(at + 1));
        connect(button, &QAbstractButton::clicked, this,
                [this, at] { (new PhotoWindow(workspace_, pictures_, at, this))->show(); });
        flow_->addWidget(button);
        buttons_.push_back(button);
        read(at);
    }
    setVisible(!pictures_.empty());
}

void PhotoStrip::read(std::size_t at) {
    const QSize bounds = (QSizeF(PhotoButton::room()) * devicePixelRatioF()).toSize();
    workspace_.jobs().start(
        kLane, JobRunner::Queueing::InOrder, tr("Reading photos"), Job::Kind::Quiet,
        [this, at, shown = shown_, bounds, project = project_,
         path = pictures_[at].path](Progress& progress) -> JobRunner::Done {
            progress.check();
            const ReadPicture picture = read_picture(project, path, bounds);
            return [this, at, shown, picture] {
                if (shown == shown_) take(at, picture.image, picture.sentence);
            };
        },
        [this, at, shown = shown_](const QString& sentence) {
            if (shown == shown_) take(at, {}, sentence);
        });
}

void PhotoStrip::take(std::size_t at, const QImage& image, const QString& sentence) {
    trouble_[at] = sentence;
    buttons_[at]->set_picture(image);
    buttons_[at]->setVisible(!image.isNull());
    say_trouble();
}

void PhotoStrip::say_trouble() {
    QStringList lines;
    for (std::size_t at = 0; at < pictures_.size(); ++at) {
        if (!trouble_[at].isEmpty()) lines << pictures_[at].title + QStringLiteral(": ") + trouble_[at];
    }
    said_->setText(lines.join(QLatin1Char('\n')));
    said_->setVisible(!lines.isEmpty());
    strip_->setVisible(static_cast<std::size_t>(lines.size()) < pictures_.size());
}

} // namespace planum::gui
