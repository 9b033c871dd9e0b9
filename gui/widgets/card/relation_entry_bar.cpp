// SPDX-License-Identifier: MIT
#include "gui/widgets/card/relation_entry_bar.hpp"

#include <QAbstractItemView>
#include <QApplication>
#include <QCompleter>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStringListModel>
#include <QStyle>
#include <QVBoxLayout>

#include "gui/viewmodels/models.hpp"

namespace planum::gui {

using Part = RelationEntryModel::Part;

RelationEntryBar::RelationEntryBar(Models& models)
    : models_(models), sentence_(new QLabel), show_(new QPushButton(tr("Show the circle"))) {
    setObjectName(QStringLiteral("relationEntry"));
    const std::array<QString, 3> hints = {tr("unit"), tr("covers, cut by, …"), tr("unit")};
    const std::array<QString, 3> names = {tr("Relation: first unit"), tr("Relation: kind"),
                                          tr("Relation: second unit")};
    const std::array<const char*, 3> objects = {"relationSubject", "relationKind", "relationObject"};
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        auto* field = new QLineEdit;
        field->setObjectName(QString::fromLatin1(objects[at]));
        field->setPlaceholderText(hints[at]);
        field->setAccessibleName(names[at]);
        field->installEventFilter(this);
        words_[at] = new QStringListModel(field);
        auto* completer = new QCompleter(words_[at], field);
        completer->setCompletionMode(QCompleter::UnfilteredPopupCompletion); // the model has chosen already
        completer->setCaseSensitivity(Qt::CaseInsensitive);
        field->setCompleter(completer);
        completer->popup()->installEventFilter(this); // before the completer's own: real keys go to the open list
        connect(field, &QLineEdit::textEdited, this, [this, i](const QString& text) { typed(i, text); });
        connect(completer, qOverload<const QString&>(&QCompleter::activated), this,
                [this, i](const QString& text) { models_.entry.set(static_cast<Part>(i), text); });
        fields_[at] = field;
        row->addWidget(field, i == 1 ? 3 : 2);
    }
    sentence_->setObjectName(QStringLiteral("relationSentence"));
    sentence_->setWordWrap(true);
    show_->setObjectName(QStringLiteral("relationShowCycle"));
    show_->hide();
    connect(show_, &QPushButton::clicked, &models_.entry, &RelationEntryModel::show_cycle);
    auto* foot = new QHBoxLayout;
    foot->addWidget(sentence_, 1);
    foot->addWidget(show_, 0, Qt::AlignTop);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addLayout(row);
    column->addLayout(foot);
    setFocusProxy(fields_[0]);
    connect(&models_.entry, &RelationEntryModel::judged, this, &RelationEntryBar::show_judgement);
    // Only where somebody is still at it: the keys are not taken from another field.
    connect(&models_.entry, &RelationEntryModel::cameBack, this, [this] {
        if (QApplication::focusWidget() == fields_[1]) fields_[2]->setFocus();
    });
    show_judgement();
}

void RelationEntryBar::begin_with(const QString& unit) {
    models_.entry.set(Part::Subject, unit);
    fields_[0]->setText(unit);
}

void RelationEntryBar::typed(int field, const QString& text) {
    models_.entry.set(static_cast<Part>(field), text);
    words_[static_cast<std::size_t>(field)]->setStringList(models_.entry.completions(static_cast<Part>(field)));
}

void RelationEntryBar::show_judgement() {
    const auto& judgement = models_.entry.judgement();
    for (int i = 0; i < 3; ++i) {
        QLineEdit* field = fields_[static_cast<std::size_t>(i)];
        const QString& text = models_.entry.text(static_cast<Part>(i));
        if (field->text() != text) field->setText(text);
    }
    sentence_->setText(judgement.sentence);
    const char* role = judgement.warns ? "warning" : "faint";
    if (sentence_->property("role") != QVariant(role)) {
        sentence_->setProperty("role", role);
        sentence_->style()->unpolish(sentence_);
        sentence_->style()->polish(sentence_);
    }
    show_->setVisible(!judgement.cycle.empty());
}

void RelationEntryBar::go_on(int field) {
    if (field == 1) {
        const auto kinds = models_.entry.completions(Part::Kind);
        const auto kind = RelationEntryModel::kind_of(fields_[1]->text());
        // What was only begun is written out, so that one sees what was understood.
        if (kind && !kinds.isEmpty() && !fields_[1]->text().trimmed().isEmpty()) typed(1, kinds.front());
    }
    if (field < 2) {
        fields_[static_cast<std::size_t>(field) + 1]->setFocus();
        fields_[static_cast<std::size_t>(field) + 1]->selectAll();
        return;
    }
    if (!models_.entry.commit()) {
        const auto miss = models_.entry.judgement().miss;
        if (miss) fields_[static_cast<std::size_t>(*miss)]->setFocus();
        return;
    }
    fields_[1]->setFocus(); // the same unit goes on; Shift+Tab for another
}

bool RelationEntryBar::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() != Qt::Key_Return && key->key() != Qt::Key_Enter) return QWidget::eventFilter(watched, event);
    for (int i = 0; i < 3; ++i) {
        QLineEdit* field = fields_[static_cast<std::size_t>(i)];
        QAbstractItemView* list = field->completer()->popup();
        if (watched != field && watched != list) continue;
        // What the arrows went to in the list is meant; else what was typed.
        const QModelIndex chosen = list->isVisible() ? list->currentIndex() : QModelIndex();
        list->hide();
        if (chosen.isValid()) {
            field->setText(chosen.data().toString());
            typed(i, field->text());
        }
        go_on(i);
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace planum::gui
