// SPDX-License-Identifier: MIT
#include "gui/widgets/row_height.hpp"

#include <QEvent>
#include <QHeaderView>
#include <QTableView>

#include "gui/widgets/theme.hpp"

namespace planum::gui {

namespace {

class RowHeight : public QObject {
  public:
    RowHeight(QTableView& table, int less) : QObject(&table), table_(table), less_(less) {
        table_.installEventFilter(this);
        set();
    }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched == &table_ && event->type() == QEvent::StyleChange) set();
        return false;
    }

  private:
    void set() {
        const int height = theme().touch - less_;
        if (height != table_.verticalHeader()->defaultSectionSize())
            table_.verticalHeader()->setDefaultSectionSize(height);
    }

    QTableView& table_;
    int less_;
};

} // namespace

void keep_row_height(QTableView& table, int less) { new RowHeight(table, less); }

} // namespace planum::gui
