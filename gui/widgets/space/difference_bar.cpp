// SPDX-License-Identifier: MIT
#include "gui/widgets/space/difference_bar.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "gui/viewmodels/words.hpp"
#include "gui/widgets/flow_layout.hpp"
#include "gui/widgets/theme.hpp"

namespace planum::gui {

namespace {

constexpr int kBand = 12; // [px] high

QString centimetres(double metres) {
    const double value = metres * 100.0;
    return number_word(value, value < 10.0 && std::abs(value - std::round(value)) >= 0.05 ? 1 : 0) +
           QStringLiteral(" cm");
}

} // namespace

void DifferenceScale::show_key(const DifferenceKey& key) {
    key_ = key;
    const QString grey = centimetres(key.detectable);
    setAccessibleName(tr("%1 %2, grey within %3, %1 %4").arg(centimetres(key.span), key.lower, grey, key.higher));
    setToolTip(tr("Grey: closer than what can be told from none (95 %), %1 in the middle of all cells").arg(grey));
    setMinimumWidth(sizeHint().width());
    update();
}

QSize DifferenceScale::sizeHint() const {
    // The middle one stands in the middle: either side needs room for the longer end.
    const auto wide = [&](const QString& words) { return fontMetrics().horizontalAdvance(words); };
    const int end = wide(centimetres(key_.span) + QLatin1Char(' ')) + std::max(wide(key_.lower), wide(key_.higher));
    const int middle = wide(QStringLiteral("± ") + centimetres(key_.detectable));
    return {std::max(320, 2 * end + middle + 32), kBand + 2 + fontMetrics().height()};
}

void DifferenceScale::paintEvent(QPaintEvent* /*event*/) {
    if (key_.span <= 0.0) return;
    QPainter painter(this);
    const int wide = width() - 1;
    for (int x = 0; x < wide; ++x) {
        const double change = (2.0 * x / wide - 1.0) * key_.span;
        painter.setPen(QColor::fromRgb(difference_colour(change, key_.detectable, key_.span)));
        painter.drawLine(x, 0, x, kBand);
    }
    painter.setPen(theme().edge);
    painter.drawRect(0, 0, wide, kBand);
    painter.setPen(theme().ink);
    const QRect words(0, kBand + 2, width(), fontMetrics().height());
    painter.drawText(words, Qt::AlignLeft, centimetres(key_.span) + QLatin1Char(' ') + key_.lower);
    painter.drawText(words, Qt::AlignHCenter, QStringLiteral("± ") + centimetres(key_.detectable));
    painter.drawText(words, Qt::AlignRight, centimetres(key_.span) + QLatin1Char(' ') + key_.higher);
}

DifferenceBar::DifferenceBar(DifferenceModel& difference)
    : difference_(difference), choice_(new QComboBox), scale_(new DifferenceScale), said_(new QLabel) {
    setObjectName(QStringLiteral("differenceBar"));
    choice_->setObjectName(QStringLiteral("differenceChoice"));
    choice_->setAccessibleName(tr("Compared with"));
    choice_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    said_->setObjectName(QStringLiteral("differenceSaid"));
    said_->setProperty("role", "faint");
    auto* compared = new QWidget;
    auto* pair = new QHBoxLayout(compared);
    pair->setContentsMargins(0, 0, 0, 0);
    pair->addWidget(new QLabel(tr("Compared with")));
    pair->addWidget(choice_);
    auto* row = new FlowLayout(12);
    setLayout(row);
    row->setContentsMargins(8, 2, 8, 6);
    for (QWidget* part : std::initializer_list<QWidget*>{compared, scale_, said_}) row->addWidget(part);
    connect(choice_, &QComboBox::activated, this, [this](int at) {
        difference_.compare_with(difference_.choices().at(static_cast<std::size_t>(at)).surface);
    });
    connect(&difference_, &DifferenceModel::changed, this, &DifferenceBar::refresh);
    refresh();
}

void DifferenceBar::refresh() {
    choice_->clear();
    const model::SurfaceId other = difference_.other();
    for (const DifferenceModel::Choice& choice : difference_.choices()) {
        choice_->addItem(choice.name);
        if (choice.surface == other) choice_->setCurrentIndex(choice_->count() - 1);
    }
    choice_->setEnabled(choice_->count() > 0);
    const bool compared = difference_.colours() != nullptr;
    scale_->setVisible(compared);
    if (compared) scale_->show_key(difference_.key());
    said_->setText(compared ? difference_.key().summary : difference_.said());
    said_->setToolTip(said_->text());
}

} // namespace planum::gui
