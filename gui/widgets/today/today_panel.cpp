// SPDX-License-Identifier: MIT
#include "gui/widgets/today/today_panel.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QVBoxLayout>

#include "gui/viewmodels/models.hpp"

namespace planum::gui {

namespace {

constexpr int kFewestCharacters = 16; // that a list shows in a narrow window

} // namespace

TodayPanel::TodayPanel(Models& models) : today_(models.workspace) {
    setObjectName(QStringLiteral("today"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 6, 8, 8);
    row->setSpacing(10);
    const std::array<const char*, 3> names = {"todayOpen", "todayNext", "todaySheets"};
    for (std::size_t i = 0; i < lists_.size(); ++i) {
        heads_[i] = new QLabel;
        heads_[i]->setProperty("role", "heading");
        heads_[i]->setWordWrap(true);
        lists_[i] = new QListWidget;
        lists_[i]->setObjectName(QString::fromLatin1(names[i]));
        lists_[i]->setUniformItemSizes(true);
        lists_[i]->setMinimumWidth(lists_[i]->fontMetrics().averageCharWidth() * kFewestCharacters);
        connect(lists_[i], &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
            if (item != nullptr) today_.choose(item->data(Qt::UserRole).toString());
        });
        auto* column = new QVBoxLayout;
        column->setSpacing(4);
        column->addWidget(heads_[i]);
        column->addWidget(lists_[i], 1);
        row->addLayout(column, 1);
    }
    connect(&today_, &TodayModel::changed, this, &TodayPanel::fill);
    fill();
}

void TodayPanel::fill() {
    const std::array<const std::vector<TodayModel::Line>*, 3> all = {&today_.open(), &today_.next(), &today_.sheets()};
    const std::array<QString, 3> titles = {tr("Open"), tr("May be dug next"), tr("Sheets that lack something")};
    for (std::size_t i = 0; i < lists_.size(); ++i) {
        const QSignalBlocker quiet(lists_[i]);
        lists_[i]->clear();
        lists_[i]->setAccessibleName(titles[i]);
        heads_[i]->setText(QStringLiteral("%1 (%2)").arg(titles[i]).arg(all[i]->size()));
        for (const TodayModel::Line& line : *all[i]) {
            auto* item = new QListWidgetItem(line.text, lists_[i]);
            item->setData(Qt::UserRole, line.unit);
            item->setToolTip(line.text);
        }
    }
}

void TodayPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    today_.set_watched(true);
}

void TodayPanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    today_.set_watched(false);
}

} // namespace planum::gui
