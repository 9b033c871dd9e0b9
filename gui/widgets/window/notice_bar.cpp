// SPDX-License-Identifier: MIT
#include "gui/widgets/window/notice_bar.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace planum::gui {

NoticeBar::NoticeBar() : text_(new QLabel) {
    setObjectName(QStringLiteral("notice"));
    setProperty("role", "notice");
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* close = new QToolButton;
    close->setText(tr("Close"));
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 4, 6, 4);
    row->addWidget(text_, 1);
    row->addWidget(close);
    hide();
}

void NoticeBar::say(const QString& sentence) {
    said_ = sentence;
    QString text = sentence.trimmed();
    // Errors of the libraries begin small and have no full stop; here they are sentences.
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    if (!text.isEmpty() && text.back().isLetterOrNumber()) text += QLatin1Char('.');
    text_->setText(text);
    setAccessibleName(text);
    show();
}

void NoticeBar::take_back(const QString& sentence) {
    if (sentence == said_) hide();
}

QString NoticeBar::sentence() const { return text_->text(); }

} // namespace planum::gui
