// SPDX-License-Identifier: MIT
#include "gui/widgets/units/unit_panel.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>

#include "gui/viewmodels/models.hpp"
#include "gui/viewmodels/words.hpp"
#include "gui/widgets/row_height.hpp"
#include "gui/widgets/signs.hpp"
#include "gui/widgets/theme.hpp"

namespace planum::gui {

namespace {

// Marks a unit that a problem names, by shape and colour, at the right edge of its number.
class NumberDelegate : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        const int severity = index.data(UnitListModel::SeverityRole).toInt();
        if (severity == 0) return;
        const double size = option.fontMetrics.height() * 0.62;
        const QRectF box(option.rect.right() - size - 6.0, option.rect.center().y() - size / 2.0, size, size);
        const bool selected = option.state.testFlag(QStyle::State_Selected);
        paint_severity(*painter, box, severity == 2 ? model::Severity::Error : model::Severity::Warning,
                       selected ? theme().on_accent : QColor());
    }
};

template<class Enum>
void choose(QComboBox* box, const std::optional<Enum>& value) {
    box->setCurrentIndex(value ? box->findData(static_cast<int>(*value)) : 0);
}

template<class Enum>
std::optional<Enum> chosen(const QComboBox* box) {
    if (box->currentIndex() <= 0) return std::nullopt;
    return static_cast<Enum>(box->currentData().toInt());
}

} // namespace

UnitPanel::UnitPanel(Models& models)
    : models_(models), search_(new QLineEdit), kind_(new QComboBox), status_(new QComboBox), area_(new QComboBox),
      problems_(new QCheckBox(tr("with problems"))), table_(new QTableView), count_(new QLabel) {
    setObjectName(QStringLiteral("units"));
    search_->setObjectName(QStringLiteral("unitSearch"));
    search_->setPlaceholderText(tr("Find a number or a word"));
    search_->setAccessibleName(tr("Find a unit"));
    search_->setClearButtonEnabled(true);
    kind_->setAccessibleName(tr("Kind"));
    status_->setAccessibleName(tr("Status"));
    area_->setAccessibleName(tr("Trench"));
    search_->installEventFilter(this);
    for (QComboBox* box : {kind_, status_, area_}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(4);
        connect(box, &QComboBox::activated, this, &UnitPanel::take_filter);
    }
    connect(search_, &QLineEdit::textChanged, this, &UnitPanel::take_filter);
    connect(problems_, &QCheckBox::toggled, this, &UnitPanel::take_filter);

    table_->setObjectName(QStringLiteral("unitTable"));
    table_->setAccessibleName(tr("Units"));
    table_->setModel(&models_.units);
    table_->setItemDelegateForColumn(UnitListModel::Number, new NumberDelegate(table_));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setAlternatingRowColors(false);
    table_->setShowGrid(false);
    table_->setWordWrap(false);
    table_->setTabKeyNavigation(false);
    table_->verticalHeader()->hide();
    keep_row_height(*table_, 2);
    table_->horizontalHeader()->setHighlightSections(false);
    table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table_->horizontalHeader()->setSectionResizeMode(UnitListModel::Title, QHeaderView::Stretch);
    table_->setColumnWidth(UnitListModel::Number, 78);
    table_->setColumnWidth(UnitListModel::Kind, 76);
    table_->setColumnWidth(UnitListModel::Status, 84);
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& now) {
        if (!following_ && now.isValid()) models_.workspace.select(models_.units.unit_at(now.row()));
    });

    count_->setProperty("role", "faint");
    auto* choices = new QHBoxLayout;
    choices->setSpacing(6);
    for (QComboBox* box : {kind_, status_, area_}) choices->addWidget(box, 1);
    auto* foot = new QHBoxLayout;
    foot->addWidget(count_, 1);
    foot->addWidget(problems_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 4);
    column->setSpacing(6);
    column->addWidget(search_);
    column->addLayout(choices);
    column->addLayout(foot);
    column->addWidget(table_, 1);
    setFocusProxy(search_);

    connect(&models_.workspace, &Workspace::selectionChanged, this, &UnitPanel::follow_selection);
    connect(&models_.workspace, &Workspace::snapshotChanged, this, &UnitPanel::fill_choices);
    connect(&models_.units, &UnitListModel::filtered, this, [this] {
        count();
        follow_selection();
    });
    fill_choices();
    count();
}

void UnitPanel::fill_choices() {
    const UnitListModel::Filter filter = models_.units.filter();
    kind_->clear();
    kind_->addItem(tr("any kind"));
    using model::UnitKind;
    for (const UnitKind kind : {UnitKind::Deposit, UnitKind::Cut, UnitKind::Feature, UnitKind::Structure,
                                UnitKind::Interface, UnitKind::Skeleton, UnitKind::Natural, UnitKind::Void}) {
        kind_->addItem(kind_word(kind, model::UnitForm::None), static_cast<int>(kind));
    }
    kind_->addItem(tr("kind not known"), static_cast<int>(UnitKind::Unknown));
    choose(kind_, filter.kind);
    status_->clear();
    status_->addItem(tr("any status"));
    using model::UnitStatus;
    for (const UnitStatus status : {UnitStatus::Open, UnitStatus::PartlyExcavated, UnitStatus::Excavated,
                                    UnitStatus::NotExcavated, UnitStatus::Void}) {
        status_->addItem(status_word(status), static_cast<int>(status));
    }
    choose(status_, filter.status);
    area_->clear();
    area_->addItem(tr("all trenches"));
    if (!models_.workspace.is_open()) return;
    const auto& areas = models_.workspace.snapshot()->record().areas;
    area_->setVisible(areas.size() > 1);
    for (std::size_t i = 0; i < areas.size(); ++i) {
        area_->addItem(qt(areas[i].name), static_cast<int>(i));
        if (areas[i].id == filter.area) area_->setCurrentIndex(static_cast<int>(i) + 1);
    }
}

void UnitPanel::take_filter() {
    UnitListModel::Filter filter;
    filter.text = search_->text();
    filter.kind = chosen<model::UnitKind>(kind_);
    filter.status = chosen<model::UnitStatus>(status_);
    filter.with_problems = problems_->isChecked();
    if (area_->currentIndex() > 0 && models_.workspace.is_open()) {
        filter.area =
            models_.workspace.snapshot()->record().areas[static_cast<std::size_t>(area_->currentIndex() - 1)].id;
    }
    models_.units.set_filter(filter);
}

void UnitPanel::count() {
    const int shown = models_.units.rowCount();
    const int total = models_.units.total();
    count_->setText(shown == total ? tr("%1 units").arg(total) : tr("%1 of %2 units").arg(shown).arg(total));
}

void UnitPanel::follow_selection() {
    const int row = models_.units.row_of(models_.workspace.selected());
    following_ = true;
    if (row < 0) {
        table_->setCurrentIndex({});
        table_->clearSelection();
    } else if (table_->currentIndex().row() != row || !table_->selectionModel()->hasSelection()) {
        table_->setCurrentIndex(models_.units.index(row, UnitListModel::Number));
        table_->scrollTo(table_->currentIndex(), QAbstractItemView::EnsureVisible);
    }
    following_ = false;
}

// From the search field the arrows walk the list and Enter takes the best match.
bool UnitPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched != search_ || event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
        const model::UnitId best = models_.units.best_match();
        if (!best.is_nil()) models_.workspace.select(best);
        search_->selectAll();
        return true;
    }
    if (key->key() == Qt::Key_Down || key->key() == Qt::Key_Up) {
        const int step = key->key() == Qt::Key_Down ? 1 : -1;
        const int row = table_->currentIndex().isValid() ? table_->currentIndex().row() + step : 0;
        if (row >= 0 && row < models_.units.rowCount()) {
            table_->setCurrentIndex(models_.units.index(row, UnitListModel::Number));
        }
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace planum::gui
