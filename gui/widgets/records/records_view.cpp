// SPDX-License-Identifier: MIT
#include "gui/widgets/records/records_view.hpp"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "gui/viewmodels/models.hpp"
#include "gui/viewmodels/record_words.hpp"

namespace planum::gui {

RecordsView::RecordsView(Models& models)
    : models_(models), records_(models.workspace), kind_(new QComboBox), search_(new QLineEdit), fresh_(new QLineEdit),
      names_(new QListWidget), add_(new QPushButton(tr("Add"))), delete_(new QPushButton(tr("Delete"))),
      scroll_(new QScrollArea) {
    setObjectName(QStringLiteral("records"));
    kind_->setObjectName(QStringLiteral("recordKind"));
    kind_->setAccessibleName(tr("List"));
    for (const QString& kind : RecordsModel::kinds()) kind_->addItem(record_list_title(kind), kind);
    kind_->setCurrentIndex(kind_->findData(records_.kind()));
    search_->setPlaceholderText(tr("Find"));
    search_->setAccessibleName(tr("Find in the list"));
    search_->setClearButtonEnabled(true);
    fresh_->setObjectName(QStringLiteral("newRecord"));
    fresh_->setAccessibleName(tr("Name of a new one"));
    names_->setObjectName(QStringLiteral("recordNames"));
    names_->setAccessibleName(tr("Names"));
    names_->setUniformItemSizes(true);
    scroll_->setWidgetResizable(true);
    const auto add_one = [this] {
        if (fresh_->text().trimmed().isEmpty()) return;
        records_.add(fresh_->text().trimmed());
        fresh_->clear();
    };
    connect(add_, &QPushButton::clicked, this, add_one);
    connect(fresh_, &QLineEdit::returnPressed, this, add_one);
    connect(delete_, &QPushButton::clicked, &records_, &RecordsModel::remove);
    connect(kind_, &QComboBox::activated, this, [this] { records_.set_kind(kind_->currentData().toString()); });
    connect(search_, &QLineEdit::textChanged, this, &RecordsView::show_names);
    connect(names_, &QListWidget::currentTextChanged, &records_, &RecordsModel::choose);
    auto* left = new QVBoxLayout;
    left->setContentsMargins(8, 8, 0, 8);
    auto* top = new QHBoxLayout;
    top->addWidget(kind_);
    top->addWidget(search_, 1);
    left->addLayout(top);
    left->addWidget(names_, 1);
    auto* foot = new QHBoxLayout;
    foot->addWidget(fresh_, 1);
    foot->addWidget(add_);
    left->addLayout(foot);
    auto* right = new QVBoxLayout;
    right->setContentsMargins(0, 0, 8, 8);
    right->addWidget(scroll_, 1);
    right->addWidget(delete_, 0, Qt::AlignRight); // below the one it deletes
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addLayout(left, 2);
    row->addLayout(right, 3);
    connect(&records_, &RecordsModel::listed, this, &RecordsView::show_names);
    connect(&records_, &RecordsModel::chosenChanged, this, &RecordsView::show_fields);
    show_names();
    show_fields();
}

void RecordsView::show_names() {
    const QString chosen = records_.chosen();
    const QSignalBlocker quiet(names_);
    names_->clear();
    for (const QString& name : records_.names()) {
        if (name.contains(search_->text().trimmed(), Qt::CaseInsensitive)) names_->addItem(name);
    }
    const auto found = names_->findItems(chosen, Qt::MatchExactly);
    if (!chosen.isEmpty() && !found.isEmpty()) names_->setCurrentItem(found.front());
    fresh_->setPlaceholderText(tr("new: %1").arg(records_.name_form()));
}

QWidget* RecordsView::editor_of(const RecordsModel::FieldLine& field) {
    const auto save = [this, name = field.name](const QString& value) { records_.set_field(name, value); };
    if (!field.choices.isEmpty()) {
        auto* box = new QComboBox;
        box->addItems(field.choices);
        box->setCurrentIndex(static_cast<int>(field.choices.indexOf(field.value)));
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        connect(box, &QComboBox::textActivated, this, save);
        return box;
    }
    auto* line = new QLineEdit(field.value);
    line->setCursorPosition(0);
    connect(line, &QLineEdit::editingFinished, this, [line, save] { save(line->text()); });
    return line;
}

void RecordsView::show_fields() {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setContentsMargins(14, 10, 14, 10);
    const bool writable = models_.workspace.read_only_because().isEmpty();
    fresh_->setEnabled(writable);
    add_->setEnabled(writable);
    delete_->setEnabled(writable && !records_.chosen().isEmpty());
    if (records_.chosen().isEmpty()) {
        auto* hint = new QLabel(tr("Choose one of the list, or add one."));
        hint->setProperty("role", "faint");
        hint->setWordWrap(true);
        form->addRow(hint);
    }
    for (const RecordsModel::FieldLine& field : records_.fields()) {
        auto* name = new QLabel(record_field_label(field.name));
        name->setProperty("role", "faint");
        name->setToolTip(field.help);
        QWidget* edit = editor_of(field);
        edit->setObjectName(QStringLiteral("record_") + field.name);
        edit->setAccessibleName(record_field_label(field.name));
        edit->setToolTip(field.help);
        edit->setEnabled(writable);
        form->addRow(name, edit);
    }
    // The old fields may be in the middle of saying that they were left.
    if (QWidget* old = scroll_->takeWidget()) old->deleteLater();
    scroll_->setWidget(page);
}

void RecordsView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    records_.set_watched(true);
}

void RecordsView::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    records_.set_watched(false);
}

} // namespace planum::gui
