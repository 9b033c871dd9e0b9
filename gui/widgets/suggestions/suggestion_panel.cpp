// SPDX-License-Identifier: MIT
#include "gui/widgets/suggestions/suggestion_panel.hpp"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QListView>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QVBoxLayout>

#include "gui/viewmodels/models.hpp"
#include "gui/viewmodels/sentences.hpp"
#include "gui/viewmodels/words.hpp"
#include "gui/widgets/flow_layout.hpp"
#include "gui/widgets/text_label.hpp"
#include "gui/widgets/theme.hpp"
#include "gui/widgets/two_line_delegate.hpp"

namespace planum::gui {

namespace {

// A filled lozenge proposes, a ring with a question mark asks.
class SuggestionDelegate : public TwoLineDelegate {
  public:
    using TwoLineDelegate::TwoLineDelegate;

  protected:
    void paint_sign(QPainter& painter, const QRectF& box, const QModelIndex& index, bool selected) const override {
        const QColor ink = selected ? theme().on_accent : theme().accent;
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(ink, 1.4));
        if (index.data(SuggestionListModel::QuestionRole).toBool()) {
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(box);
            QFont small = painter.font();
            small.setPixelSize(static_cast<int>(box.height() * 0.75));
            small.setBold(true);
            painter.setFont(small);
            painter.drawText(box, Qt::AlignCenter, QStringLiteral("?"));
            return;
        }
        const QPointF c = box.center();
        const double r = box.width() / 2.0;
        painter.setBrush(ink);
        painter.drawPolygon(QPolygonF({c - QPointF(0, r), c + QPointF(r, 0), c + QPointF(0, r), c - QPointF(r, 0)}));
    }

    [[nodiscard]] QString title(const QModelIndex& index) const override {
        return index.data(SuggestionListModel::TitleRole).toString();
    }

    [[nodiscard]] QString sentence(const QModelIndex& index) const override {
        return index.data(SuggestionListModel::ReasonRole).toString();
    }
};

} // namespace

SuggestionPanel::SuggestionPanel(Models& models)
    : models_(models), suggestions_(models.workspace), ask_(ask_reason_in_dialog), summary_(new QLabel),
      compile_(new QPushButton(tr("All as a reading …"))), list_(new QListView), scroll_(new QScrollArea) {
    setObjectName(QStringLiteral("suggestions"));
    list_->setObjectName(QStringLiteral("suggestionList"));
    list_->setAccessibleName(tr("Suggestions"));
    list_->setModel(&suggestions_);
    list_->setItemDelegate(new SuggestionDelegate(list_));
    list_->setUniformItemSizes(true);
    list_->setMinimumHeight(3 * fontMetrics().lineSpacing()); // one; a low screen leaves the views more
    connect(list_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& now) {
        if (!now.isValid()) return;
        suggestions_.open(now.row());
        const model::Suggestion* s = suggestions_.suggestion();
        if (s != nullptr && !s->surfaces.empty()) models_.time.go_to(s->surfaces.front());
    });
    auto* decided = new QCheckBox(tr("decided ones too"));
    connect(decided, &QCheckBox::toggled, &suggestions_, &SuggestionListModel::set_with_decided);
    compile_->setObjectName(QStringLiteral("compileReading"));
    compile_->setToolTip(tr("All proposed relations as a reading of their own beside the record"));
    connect(compile_, &QPushButton::clicked, this, &SuggestionPanel::compile);
    auto* head = new QVBoxLayout;
    head->setContentsMargins(10, 6, 10, 6);
    summary_->setWordWrap(true);
    head->addWidget(summary_);
    auto* choices = new QHBoxLayout;
    choices->addWidget(decided);
    choices->addStretch(1);
    choices->addWidget(compile_);
    head->addLayout(choices);
    auto* left = new QWidget;
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(head);
    column->addWidget(list_, 1);
    scroll_->setWidgetResizable(true);
    auto* halves = new QSplitter;
    halves->addWidget(left);
    halves->addWidget(scroll_);
    halves->setSizes({480, 580});
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(halves);
    connect(&suggestions_, &SuggestionListModel::listed, this, &SuggestionPanel::show_summary);
    connect(&suggestions_, &SuggestionListModel::openedChanged, this, &SuggestionPanel::show_detail);
    connect(&suggestions_, &SuggestionListModel::done, &models_.day, &DayJobs::done);
    show_summary();
    show_detail();
}

void SuggestionPanel::show_summary() {
    const bool open = models_.workspace.is_open();
    summary_->setText(open && !suggestions_.is_listed() ? tr("asking the surfaces …") : suggestions_.summary());
    compile_->setEnabled(open && models_.workspace.read_only_because().isEmpty() && suggestions_.rowCount() > 0);
}

QWidget* SuggestionPanel::make_answers() {
    auto* box = new QWidget;
    auto* row = new FlowLayout(6);
    box->setLayout(row);
    const model::Suggestion& s = *suggestions_.suggestion();
    const bool writable = models_.workspace.read_only_because().isEmpty() && s.state == model::SuggestionState::Open;
    const auto answer = [&](const char* name, const QString& text, auto work) {
        auto* button = new QPushButton(text);
        button->setObjectName(QString::fromLatin1(name));
        button->setEnabled(writable);
        connect(button, &QPushButton::clicked, this, work);
        row->addWidget(button);
    };
    if (s.type == model::SuggestionType::Question) {
        answer("stateRelation", tr("State the relation"), [this] { state_relation(); });
    } else {
        answer("acceptSuggestion", tr("Accept"), [this] { suggestions_.accept(); });
    }
    answer("rejectSuggestion", tr("Reject …"), [this] {
        const ReasonAnswer why = ask_(this, tr("Reject"), {});
        if (!why.because.isEmpty()) suggestions_.reject(why.because);
    });
    answer("cannotTell", tr("Cannot tell"), [this] { suggestions_.cannot_tell(); });
    return box;
}

void SuggestionPanel::show_detail() {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(14, 10, 14, 10);
    column->setSpacing(6);
    const model::Suggestion* s = suggestions_.suggestion();
    if (s == nullptr) {
        column->addWidget(text_label(tr("Choose a suggestion: its units show in every view."), "faint"));
        if (!suggestions_.unused().isEmpty())
            column->addWidget(text_label(tr("Said nothing, or less than all"), "heading"));
        // One label: many of them would take longer to lay out than a key may wait.
        column->addWidget(text_label(suggestions_.unused().join(QLatin1Char('\n')), "faint"));
    } else {
        column->addWidget(text_label(suggestions_.title(), "title"));
        column->addWidget(text_label(in_window_language(s->reason)));
        column->addWidget(text_label(suggestions_.numbers().join(QStringLiteral("    ")), "faint"));
        if (s->state != model::SuggestionState::Open)
            column->addWidget(text_label(suggestion_state_word(s->state), "heading"));
        column->addWidget(make_answers());
    }
    column->addStretch(1);
    scroll_->setWidget(page);
}

// A question is answered by what somebody saw: the entry line has the two units, the kind is for the person.
void SuggestionPanel::state_relation() {
    const auto [unit, other] = suggestions_.unit_names();
    models_.entry.set(RelationEntryModel::Part::Subject, unit);
    models_.entry.set(RelationEntryModel::Part::Object, other);
    auto* kind = window()->findChild<QWidget*>(QStringLiteral("relationKind"));
    if (kind != nullptr) kind->setFocus();
}

void SuggestionPanel::compile() {
    const QString name =
        QInputDialog::getText(this, tr("Compile a reading"), tr("Name of the reading, beside the record")).trimmed();
    if (!name.isEmpty()) suggestions_.compile(name);
}

void SuggestionPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    suggestions_.set_watched(true);
}

void SuggestionPanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    suggestions_.set_watched(false);
}

} // namespace planum::gui
