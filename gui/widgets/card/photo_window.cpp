// SPDX-License-Identifier: MIT
#include "gui/widgets/card/photo_window.hpp"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPixmap>
#include <QPointer>
#include <QScreen>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

#include "gui/widgets/card/picture_file.hpp"

namespace planum::gui {

PhotoWindow::PhotoWindow(Workspace& workspace, std::vector<CardPicture> pictures, std::size_t at, QWidget* parent)
    : QDialog(parent), workspace_(workspace), project_(workspace.file()), pictures_(std::move(pictures)), at_(at),
      shown_(new QLabel), caption_(new QLabel), back_(new QToolButton), on_(new QToolButton) {
    setObjectName(QStringLiteral("photoWindow"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowFlag(Qt::WindowMaximizeButtonHint);
    shown_->setAlignment(Qt::AlignCenter);
    shown_->setWordWrap(true);
    shown_->setMinimumSize(200, 150);
    shown_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored); // the picture follows the window
    caption_->setObjectName(QStringLiteral("photoCaption"));
    caption_->setProperty("role", "faint");
    caption_->setTextFormat(Qt::PlainText);
    back_->setText(tr("Previous"));
    on_->setText(tr("Next"));
    connect(back_, &QToolButton::clicked, this, [this] { go(-1); });
    connect(on_, &QToolButton::clicked, this, [this] { go(1); });
    auto* row = new QHBoxLayout;
    row->setContentsMargins(12, 6, 12, 8);
    row->addWidget(caption_, 1);
    row->addWidget(back_);
    row->addWidget(on_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(shown_, 1);
    column->addLayout(row);
    connect(&workspace_, &Workspace::closed, this, &QDialog::close);
    resize(screen()->availableSize() * 0.8);
    read();
}

void PhotoWindow::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_PageUp: return go(-1);
    case Qt::Key_Right:
    case Qt::Key_PageDown: return go(1);
    default: QDialog::keyPressEvent(event);
    }
}

void PhotoWindow::resizeEvent(QResizeEvent* event) {
    QDialog::resizeEvent(event);
    fit();
}

void PhotoWindow::go(int steps) {
    const auto next = static_cast<std::ptrdiff_t>(at_) + steps;
    if (next < 0 || next >= std::ssize(pictures_)) return;
    at_ = static_cast<std::size_t>(next);
    read();
}

// Once for the whole screen: it is only made smaller when the window is.
void PhotoWindow::read() {
    const CardPicture& wanted = pictures_[at_];
    setWindowTitle(wanted.title);
    picture_ = {};
    shown_->setText(tr("reading the picture …"));
    caption_->setText(wanted.path);
    back_->setEnabled(at_ > 0);
    on_->setEnabled(at_ + 1 < pictures_.size());
    const QSize bounds = (QSizeF(screen()->size()) * devicePixelRatioF()).toSize();
    const auto take = [window = QPointer<PhotoWindow>(this), at = at_](const ReadPicture& read) {
        if (window == nullptr || window->at_ != at) return;
        window->picture_ = read.image;
        window->shown_->setText(read.sentence);
        QStringList words = {window->pictures_[at].path};
        if (read.whole.isValid()) words << tr("%1 × %2 pixels").arg(read.whole.width()).arg(read.whole.height());
        if (!window->pictures_[at].made.isEmpty()) words << window->pictures_[at].made;
        window->caption_->setText(words.join(QStringLiteral("   ")));
        window->fit();
    };
    workspace_.jobs().start(
        QStringLiteral("photo large"), JobRunner::Queueing::Newest, tr("Reading photos"), Job::Kind::Quiet,
        [take, bounds, project = project_, path = wanted.path](Progress& progress) -> JobRunner::Done {
            progress.check();
            const ReadPicture read = read_picture(project, path, bounds);
            return [take, read] { take(read); };
        },
        [take](const QString& sentence) {
            take({{}, {}, sentence});
        });
}

void PhotoWindow::fit() {
    if (picture_.isNull()) return;
    const QSize room = (QSizeF(shown_->size()) * devicePixelRatioF()).toSize();
    const QSize size = picture_.size().scaled(room, Qt::KeepAspectRatio).boundedTo(picture_.size());
    QPixmap pixmap = QPixmap::fromImage(picture_.scaled(size, Qt::KeepAspectRatio, Qt::SmoothTransformation));
    pixmap.setDevicePixelRatio(devicePixelRatioF());
    shown_->setPixmap(pixmap);
}

} // namespace planum::gui
