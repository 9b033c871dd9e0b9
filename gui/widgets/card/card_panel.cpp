// SPDX-License-Identifier: MIT
#include "gui/widgets/card/card_panel.hpp"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "gui/viewmodels/models.hpp"
#include "gui/widgets/card/photo_strip.hpp"
#include "gui/widgets/card/relation_entry_bar.hpp"
#include "gui/widgets/flow_layout.hpp"
#include "gui/widgets/theme.hpp"

namespace planum::gui {

namespace {

constexpr int kNarrowCharacters = 36; // a card that is narrower has its names above the fields

// A text of some lines that is saved when it is left.
class LongText : public QPlainTextEdit {
  public:
    LongText(const QString& text, std::function<void(const QString&)> save) : save_(std::move(save)) {
        setPlainText(text);
        setTabChangesFocus(true);
        const int lines =
            std::clamp(static_cast<int>(text.size()) / 38 + 1 + static_cast<int>(text.count(QLatin1Char('\n'))), 2, 8);
        setFixedHeight(fontMetrics().lineSpacing() * lines + 14);
    }

  protected:
    // Only what somebody typed: a text that is merely left must not take back what another program wrote meanwhile.
    void focusOutEvent(QFocusEvent* event) override {
        QPlainTextEdit::focusOutEvent(event);
        if (signalsBlocked() || !document()->isModified()) return;
        document()->setModified(false);
        save_(toPlainText());
    }

  private:
    std::function<void(const QString&)> save_;
};

/// What somebody is typing while the form is made anew under the cursor.
struct HalfTyped {
    QString object;
    QString text;
    int cursor = 0;
};

std::optional<HalfTyped> half_typed(QWidget* editor) {
    if (const auto* text = qobject_cast<QPlainTextEdit*>(editor); text != nullptr && text->document()->isModified())
        return HalfTyped{text->objectName(), text->toPlainText(), text->textCursor().position()};
    if (const auto* line = qobject_cast<QLineEdit*>(editor); line != nullptr && line->isModified())
        return HalfTyped{line->objectName(), line->text(), line->cursorPosition()};
    return std::nullopt;
}

void go_on_typing(QWidget* editor, const HalfTyped& typed) {
    if (auto* text = qobject_cast<QPlainTextEdit*>(editor)) {
        text->setPlainText(typed.text);
        text->document()->setModified(true);
        QTextCursor cursor = text->textCursor();
        cursor.setPosition(typed.cursor);
        text->setTextCursor(cursor);
    } else if (auto* line = qobject_cast<QLineEdit*>(editor)) {
        line->setText(typed.text);
        line->setModified(true);
        line->setCursorPosition(typed.cursor);
    }
}

void empty(QWidget* holder) {
    if (holder->layout() == nullptr) return;
    while (QLayoutItem* item = holder->layout()->takeAt(0)) {
        if (QWidget* widget = item->widget()) {
            widget->hide();
            widget->deleteLater();
        }
        delete item;
    }
}

QLabel* label(const QString& text, const char* role) {
    auto* made = new QLabel(text);
    made->setProperty("role", role);
    made->setWordWrap(true);
    return made;
}

} // namespace

CardPanel::CardPanel(Models& models)
    : models_(models), title_(new QLabel), subtitle_(new QLabel), new_number_(new QLineEdit),
      add_(new QPushButton(tr("Add unit"))), more_(new QPushButton(tr("Full record"))),
      delete_(new QPushButton(tr("Delete"))), entry_(new RelationEntryBar(models)), fields_(new QWidget),
      relations_(new QWidget), lines_(new QWidget), photos_(new PhotoStrip(models.workspace)), history_(new QLabel),
      body_(new QWidget), scroll_(new QScrollArea), nothing_(new QLabel) {
    setObjectName(QStringLiteral("card"));
    title_->setProperty("role", "title");
    title_->setObjectName(QStringLiteral("cardTitle"));
    subtitle_->setProperty("role", "faint");
    subtitle_->setWordWrap(true);
    nothing_->setProperty("role", "faint");
    nothing_->setWordWrap(true);
    nothing_->setText(tr("Select a unit in the list, the matrix or a problem, or add a new one."));
    history_->setProperty("role", "faint");
    history_->setWordWrap(true);
    history_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    new_number_->setObjectName(QStringLiteral("newUnit"));
    new_number_->setAccessibleName(tr("Number of a new unit"));
    more_->setCheckable(true);
    more_->setObjectName(QStringLiteral("fullRecord"));
    delete_->setObjectName(QStringLiteral("deleteUnit"));
    connect(more_, &QPushButton::toggled, this, &CardPanel::show_full);
    connect(delete_, &QPushButton::clicked, &models_.card, &UnitCardModel::delete_unit);

    add_->setObjectName(QStringLiteral("addUnit"));
    const auto add_unit = [this] {
        models_.card.add_unit(new_number_->text());
        new_number_->clear();
    };
    connect(add_, &QPushButton::clicked, this, add_unit);
    connect(new_number_, &QLineEdit::returnPressed, this, add_unit);

    auto* top = new QHBoxLayout;
    top->addWidget(new_number_, 1);
    top->addWidget(add_);
    auto* head = new QWidget;
    auto* row = new FlowLayout(6);
    head->setLayout(row);
    for (QWidget* part : std::initializer_list<QWidget*>{title_, more_, delete_}) row->addWidget(part);
    auto* column = new QVBoxLayout(body_);
    column->setContentsMargins(12, 8, 12, 12);
    column->setSpacing(6);
    column->addWidget(head);
    column->addWidget(subtitle_);
    column->addWidget(fields_);
    column->addWidget(relations_);
    column->addWidget(photos_);
    column->addWidget(lines_);
    column->addWidget(label(tr("Changes"), "heading"));
    column->addWidget(history_);
    column->addStretch(1);
    fields_->setLayout(new QFormLayout);
    static_cast<QFormLayout*>(fields_->layout())->setContentsMargins(0, 0, 0, 0);
    static_cast<QFormLayout*>(fields_->layout())->setRowWrapPolicy(QFormLayout::WrapLongRows);
    relations_->setLayout(new QVBoxLayout);
    relations_->layout()->setContentsMargins(0, 0, 0, 0);
    relations_->layout()->setSpacing(2);
    lines_->setLayout(new QVBoxLayout);
    lines_->layout()->setContentsMargins(0, 0, 0, 0);
    lines_->layout()->setSpacing(2);

    scroll_->setWidgetResizable(true);
    scroll_->setWidget(body_);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* frame = new QVBoxLayout(this);
    frame->setContentsMargins(0, 0, 0, 0);
    frame->setSpacing(0);
    auto* fixed = new QVBoxLayout;
    fixed->setContentsMargins(12, 8, 12, 8);
    fixed->addLayout(top);
    fixed->addWidget(label(tr("Relation: number, kind, number, Enter"), "heading"));
    fixed->addWidget(entry_);
    frame->addLayout(fixed);
    frame->addWidget(nothing_, 0, Qt::AlignTop);
    nothing_->setContentsMargins(12, 12, 12, 12);
    frame->addWidget(scroll_, 1);
    frame->addStretch(0);

    connect(&models_.card, &UnitCardModel::changed, this, &CardPanel::show_card);
    connect(&models_.card, &UnitCardModel::historyChanged, this, &CardPanel::show_history);
    show_card();
}

void CardPanel::show_full(bool full) {
    full_ = full;
    more_->setChecked(full);
    more_->setText(full ? tr("First fields") : tr("Full record"));
    shown_.clear();
    show_fields();
}

void CardPanel::show_card() {
    const bool any = !models_.card.unit().is_nil();
    nothing_->setVisible(!any);
    body_->setVisible(any);
    scroll_->setVisible(any); // or its empty ground would stand below the hint
    new_number_->setPlaceholderText(tr("new unit: %1").arg(models_.card.next_number()));
    setEnabled(models_.workspace.is_open());
    const bool writable = models_.workspace.read_only_because().isEmpty();
    for (QWidget* part : std::initializer_list<QWidget*>{new_number_, add_, delete_, entry_})
        part->setEnabled(writable);
    if (!any) return;
    title_->setText(tr("Unit %1").arg(models_.card.name()));
    subtitle_->setText(models_.workspace.read_only_because());
    subtitle_->setVisible(!subtitle_->text().isEmpty());
    entry_->begin_with(models_.card.name());
    show_fields();
    show_relations();
    show_lines();
    photos_->show_pictures(models_.card.pictures());
    history_->clear();
    models_.card.load_history();
}

QWidget* CardPanel::editor_of(const CardField& field) {
    const auto save = [this, name = field.name](const QString& value) { models_.card.set_field(name, value); };
    const QString object = QStringLiteral("field_") + QString::fromStdString(field.name);
    QWidget* made = nullptr;
    if (!field.choices.isEmpty()) {
        auto* box = new QComboBox;
        box->addItems(field.choices);
        box->setCurrentText(field.value);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        connect(box, &QComboBox::textActivated, this, save);
        made = box;
    } else if (field.is_long) {
        made = new LongText(field.value, save);
    } else {
        auto* line = new QLineEdit(field.value);
        line->setCursorPosition(0);
        connect(line, &QLineEdit::editingFinished, this, [line, save] { save(line->text()); });
        made = line;
    }
    made->setObjectName(object);
    made->setAccessibleName(field.label);
    made->setEnabled(models_.workspace.read_only_because().isEmpty());
    return made;
}

void CardPanel::show_fields() {
    if (models_.card.unit().is_nil()) return;
    std::string shown = models_.card.name().toStdString() + (full_ ? "+" : "-");
    for (const CardField& field : models_.card.fields())
        shown += field.value.toStdString() + (field.unsaved ? "!\n" : "\n");
    if (shown == shown_) return;
    const bool same_unit = std::exchange(shown_unit_, models_.card.unit()) == models_.card.unit();
    shown_ = std::move(shown);
    // A field that is being left says so once more while it goes; who has the cursor keeps it.
    // Of the whole window: that of the panel is who had it last, and would take it from where somebody types now.
    QWidget* focus = window()->focusWidget();
    const bool is_here = focus != nullptr && fields_->isAncestorOf(focus);
    const QString focused = is_here ? focus->objectName() : QString();
    const std::optional<HalfTyped> typed = same_unit && is_here ? half_typed(focus) : std::nullopt;
    auto* old = fields_;
    fields_ = new QWidget;
    auto* form = new QFormLayout(fields_);
    form->setContentsMargins(0, 0, 0, 0);
    form->setRowWrapPolicy(row_wrapping());
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setVerticalSpacing(6);
    QString block;
    for (const CardField& field : models_.card.fields()) {
        if (!field.block.isEmpty() && !full_) break;
        if (field.block != block) form->addRow(label(field.block, "heading"));
        block = field.block;
        auto* name =
            field.unsaved ? label(tr("%1: not saved yet").arg(field.label), "warning") : label(field.label, "faint");
        QWidget* editor = editor_of(field);
        name->setBuddy(editor);
        if (field.is_long) {
            form->addRow(name);
            form->addRow(editor);
        } else {
            form->addRow(name, editor);
        }
    }
    body_->layout()->replaceWidget(old, fields_);
    old->blockSignals(true);
    for (QWidget* child : old->findChildren<QWidget*>()) child->blockSignals(true);
    old->hide();
    old->deleteLater();
    if (focused.isEmpty()) return;
    auto* again = fields_->findChild<QWidget*>(focused);
    if (again == nullptr) return;
    if (typed && typed->object == focused) go_on_typing(again, *typed);
    again->setFocus();
}

// In a narrow card names stand above their fields, or nothing could be read in these.
QFormLayout::RowWrapPolicy CardPanel::row_wrapping() const {
    return width() < fontMetrics().averageCharWidth() * kNarrowCharacters ? QFormLayout::WrapAllRows
                                                                          : QFormLayout::WrapLongRows;
}

void CardPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (auto* form = qobject_cast<QFormLayout*>(fields_->layout())) form->setRowWrapPolicy(row_wrapping());
}

void CardPanel::show_relations() {
    empty(relations_);
    auto* column = static_cast<QVBoxLayout*>(relations_->layout());
    column->addWidget(label(tr("Relations"), "heading"));
    if (models_.card.relations().empty()) column->addWidget(label(tr("none recorded"), "faint"));
    for (const CardRelation& relation : models_.card.relations()) {
        auto* line = new QLabel(QStringLiteral("<a href='#' style='color:%1;text-decoration:none'>%2</a>%3")
                                    .arg(theme().accent.name(), relation.sentence.toHtmlEscaped(),
                                         relation.uncertain ? QStringLiteral(" (?)") : QString()));
        line->setWordWrap(true);
        line->setToolTip(relation.said_by);
        line->setAccessibleName(relation.sentence);
        connect(line, &QLabel::linkActivated, this,
                [this, other = relation.other] { models_.workspace.select(other); });
        column->addWidget(line);
    }
}

void CardPanel::show_lines() {
    empty(lines_);
    if (models_.card.lines().empty()) return;
    auto* column = static_cast<QVBoxLayout*>(lines_->layout());
    column->addWidget(label(tr("Levels, finds, papers"), "heading"));
    for (const CardLine& line : models_.card.lines()) {
        auto* said = new QLabel(line.kind + QStringLiteral("  ") + line.text);
        said->setWordWrap(true);
        said->setToolTip(line.path);
        column->addWidget(said);
    }
}

void CardPanel::show_history() { history_->setText(models_.card.history().join(QLatin1Char('\n'))); }

} // namespace planum::gui
