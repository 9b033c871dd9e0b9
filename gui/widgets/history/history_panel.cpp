// SPDX-License-Identifier: MIT
#include "gui/widgets/history/history_panel.hpp"

#include <QEvent>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include "gui/viewmodels/change_labels.hpp"
#include "gui/viewmodels/log_words.hpp"
#include "gui/viewmodels/models.hpp"
#include "gui/viewmodels/words.hpp"
#include "gui/widgets/row_height.hpp"
#include "gui/widgets/theme.hpp"

namespace planum::gui {

HistoryPanel::HistoryPanel(Models& models) : models_(models), table_(new QTableWidget(0, 3)) {
    setObjectName(QStringLiteral("history"));
    table_->setObjectName(QStringLiteral("historyTable"));
    table_->setAccessibleName(tr("History"));
    table_->setHorizontalHeaderLabels({tr("When"), tr("Who"), tr("What")});
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setShowGrid(false);
    table_->verticalHeader()->hide();
    keep_row_height(*table_, 4);
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table_->setColumnWidth(0, 150);
    table_->setColumnWidth(1, 120);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(table_);
    connect(&models_.workspace, &Workspace::snapshotChanged, this, &HistoryPanel::fill);
    connect(&models_.workspace, &Workspace::closed, this, &HistoryPanel::fill);
    fill();
}

void HistoryPanel::fill() {
    table_->setRowCount(0);
    if (!models_.workspace.is_open()) return;
    const auto& changes = models_.workspace.snapshot()->changes;
    table_->setRowCount(static_cast<int>(changes.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const store::ChangeEntry& change = changes[static_cast<std::size_t>(row)];
        const QString when = qt(change.made_at).left(16).replace(QLatin1Char('T'), QLatin1Char(' '));
        const QString label = change_label(change.label);
        const QString what = change.undone ? tr("%1 (taken back)").arg(label) : label;
        int at = 0;
        for (const QString& text : {when, author_word(change.author), what}) {
            auto* item = new QTableWidgetItem(text);
            item->setToolTip(text); // of what is too long for its column
            QFont font = item->font();
            font.setStrikeOut(change.undone && at == 2);
            item->setFont(font);
            table_->setItem(row, at++, item);
        }
    }
    colour();
}

// What was taken back is faint, and so are when and who.
void HistoryPanel::colour() {
    const QSignalBlocker quiet(table_->model()); // each item would have the table painted again
    for (int row = 0; row < table_->rowCount(); ++row) {
        const bool undone = table_->item(row, 2)->font().strikeOut();
        for (int column = 0; column < (undone ? 3 : 2); ++column)
            table_->item(row, column)->setForeground(theme().faint);
    }
    table_->viewport()->update();
}

void HistoryPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange) colour();
}

} // namespace planum::gui
