// SPDX-License-Identifier: MIT
#include "gui/widgets/scans/scans_view.hpp"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <vector>

#include "app/scans/list_scans.hpp"
#include "gui/viewmodels/models.hpp"
#include "gui/viewmodels/service_sentences.hpp"
#include "gui/viewmodels/words.hpp"
#include "gui/widgets/row_height.hpp"
#include "gui/widgets/theme.hpp"

namespace planum::gui {

namespace {

QStringList cells(const app::ListedScan& scan) {
    const QLocale locale;
    const bool placed = scan.status == "registered";
    return {qt(scan.scan),
            locale.toString(static_cast<qlonglong>(scan.points)),
            qt(scan.surface),
            placed ? ScansView::tr("on the site grid") : ScansView::tr("not placed yet"),
            placed ? number_word(1000.0 * scan.rms, 1) : QString(),
            placed ? number_word(1000.0 * scan.sigma_position, 1) : QString(),
            scan.original_there ? service_sentence(scan.verdict)
                                : ScansView::tr("the original file is not where it was")};
}

} // namespace

ScansView::ScansView(Models& models)
    : models_(models), table_(new QTableWidget(0, 7)), register_(new QPushButton(tr("Register"))), said_(new QLabel) {
    setObjectName(QStringLiteral("scans"));
    table_->setObjectName(QStringLiteral("scanTable"));
    table_->setAccessibleName(tr("Scans"));
    table_->setHorizontalHeaderLabels(
        {tr("Scan"), tr("Points"), tr("Surface"), tr("Place"), tr("rms [mm]"), tr("within [mm]"), tr("Verdict")});
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setShowGrid(false);
    table_->verticalHeader()->hide();
    keep_row_height(*table_, 4);
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    const int digit = fontMetrics().horizontalAdvance(QLatin1Char('0'));
    table_->setColumnWidth(0, 22 * digit);
    table_->setColumnWidth(3, 17 * digit);
    table_->setWordWrap(false);
    register_->setObjectName(QStringLiteral("registerScans"));
    register_->setToolTip(tr("Puts the scans on the site grid that are not there yet"));
    said_->setProperty("role", "faint");
    said_->setWordWrap(true);
    auto* add = new QPushButton(tr("Add scans …"));
    auto* markers = new QPushButton(tr("Markers …"));
    add->setObjectName(QStringLiteral("addScans"));
    markers->setObjectName(QStringLiteral("importMarkers"));
    connect(add, &QPushButton::clicked, this, [this] {
        const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder of a day's scans"));
        if (!folder.isEmpty()) models_.day.add_scans({folder.toStdString()}, {});
    });
    connect(markers, &QPushButton::clicked, this, [this] {
        const QString file = QFileDialog::getOpenFileName(this, tr("Markers"), {}, tr("Tables (*.csv)"));
        if (!file.isEmpty()) models_.day.import_markers(file.toStdString());
    });
    connect(register_, &QPushButton::clicked, this, [this] { models_.day.register_scans({}); });
    connect(&models_.day, &DayJobs::registered, this,
            [this](const QStringList& lines) { said_->setText(lines.join(QLatin1Char('\n'))); });
    auto* head = new QHBoxLayout;
    head->setContentsMargins(8, 6, 8, 6);
    head->addWidget(said_, 1);
    for (QPushButton* button : {add, markers, register_}) head->addWidget(button, 0, Qt::AlignTop);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(head);
    column->addWidget(table_, 1);
    const auto enable = [this, add, markers] {
        const bool writable = models_.workspace.is_open() && models_.workspace.read_only_because().isEmpty();
        for (QPushButton* button : {add, markers, register_}) button->setEnabled(writable);
    };
    connect(&models_.workspace, &Workspace::opened, this, enable);
    connect(&models_.workspace, &Workspace::closed, this, enable);
    enable();
    connect(&models_.workspace, &Workspace::snapshotChanged, this, &ScansView::list_again);
    connect(&models_.workspace, &Workspace::closed, this, [this] {
        table_->setRowCount(0);
        said_->clear();
    });
}

void ScansView::list_again() {
    if (!isVisible() || !models_.workspace.is_open()) return;
    models_.workspace.read(QStringLiteral("scan list"), tr("Listing scans"),
                           [this](app::Project& project, Progress&) -> JobRunner::Done {
                               std::vector<QStringList> rows;
                               for (const app::ListedScan& scan : app::list_scans(project)) rows.push_back(cells(scan));
                               return [this, rows] {
                                   table_->setRowCount(static_cast<int>(rows.size()));
                                   for (int row = 0; row < table_->rowCount(); ++row) {
                                       const QStringList& texts = rows[static_cast<std::size_t>(row)];
                                       for (int c = 0; c < texts.size(); ++c)
                                           table_->setItem(row, c, new QTableWidgetItem(texts[c]));
                                   }
                               };
                           });
}

void ScansView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    list_again();
}

} // namespace planum::gui
