// SPDX-License-Identifier: MIT
#include "gui/widgets/problems/problem_panel.hpp"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QVBoxLayout>

#include <memory>

#include "gui/viewmodels/models.hpp"
#include "gui/viewmodels/words.hpp"
#include "gui/widgets/flow_layout.hpp"
#include "gui/widgets/problems/proof_picture.hpp"
#include "gui/widgets/signs.hpp"
#include "gui/widgets/text_label.hpp"
#include "gui/widgets/theme.hpp"
#include "gui/widgets/two_line_delegate.hpp"

namespace planum::gui {

namespace {

class ProblemDelegate : public TwoLineDelegate {
  public:
    using TwoLineDelegate::TwoLineDelegate;

  protected:
    void paint_sign(QPainter& painter, const QRectF& box, const QModelIndex& index, bool selected) const override {
        const auto severity = static_cast<model::Severity>(index.data(ProblemListModel::SeverityRole).toInt());
        paint_severity(painter, box, severity, selected ? theme().on_accent : QColor());
    }

    [[nodiscard]] QString title(const QModelIndex& index) const override {
        const QString title = index.data(ProblemListModel::TitleRole).toString();
        return index.data(ProblemListModel::NewRole).toBool() ? title + ProblemListModel::tr("  · new") : title;
    }

    [[nodiscard]] QString sentence(const QModelIndex& index) const override {
        return index.data(ProblemListModel::MessageRole).toString();
    }
};

} // namespace

ProblemPanel::ProblemPanel(Models& models)
    : models_(models), ask_(ask_reason_in_dialog), summary_(new QLabel), list_(new QListView),
      scroll_(new QScrollArea) {
    setObjectName(QStringLiteral("problems"));
    summary_->setObjectName(QStringLiteral("problemSummary"));
    list_->setObjectName(QStringLiteral("problemList"));
    list_->setAccessibleName(tr("Problems"));
    list_->setModel(&models_.problems);
    list_->setItemDelegate(new ProblemDelegate(list_));
    list_->setUniformItemSizes(true);
    list_->setMinimumHeight(3 * fontMetrics().lineSpacing()); // one; a low screen leaves the views more
    list_->setMouseTracking(true);
    connect(list_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& now) {
        if (now.isValid()) models_.problems.open(now.row());
    });
    auto* remarks = new QCheckBox(tr("remarks too"));
    remarks->setObjectName(QStringLiteral("problemRemarks"));
    connect(remarks, &QCheckBox::toggled, &models_.problems, &ProblemListModel::set_with_remarks);
    auto* sign_off = new QPushButton(tr("Sign the day off"));
    sign_off->setObjectName(QStringLiteral("signOff"));
    sign_off->setToolTip(tr("What stands now is not new tomorrow; it is signed with your name."));
    connect(sign_off, &QPushButton::clicked, &models_.problems, &ProblemListModel::sign_off);
    const auto enable = [this, sign_off] {
        sign_off->setEnabled(models_.workspace.is_open() && models_.workspace.read_only_because().isEmpty());
    };
    connect(&models_.workspace, &Workspace::opened, this, enable);
    connect(&models_.workspace, &Workspace::closed, this, enable);
    enable();
    auto* head = new QVBoxLayout;
    head->setContentsMargins(10, 6, 10, 6);
    summary_->setWordWrap(true); // however long it gets, the window does not grow
    head->addWidget(summary_);
    auto* choices = new QHBoxLayout;
    choices->addWidget(remarks);
    choices->addStretch(1);
    choices->addWidget(sign_off);
    head->addLayout(choices);
    auto* left = new QWidget;
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(head);
    column->addWidget(list_, 1);
    auto* detail = new QWidget;
    detail_ = new QVBoxLayout(detail);
    detail_->setContentsMargins(14, 10, 14, 10);
    detail_->setSpacing(10);
    detail_->addWidget(new QWidget);
    detail_->addWidget(new ProofPicture(models_));
    detail_->addStretch(1);
    scroll_->setWidget(detail);
    scroll_->setWidgetResizable(true);
    scroll_->setObjectName(QStringLiteral("problemDetail"));
    auto* halves = new QSplitter;
    halves->addWidget(left);
    halves->addWidget(scroll_);
    halves->setStretchFactor(0, 2);
    halves->setStretchFactor(1, 3);
    halves->setSizes({420, 640});
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(halves);
    connect(&models_.problems, &ProblemListModel::checked, this, &ProblemPanel::show_summary);
    connect(&models_.problems, &ProblemListModel::openedChanged, this, &ProblemPanel::show_detail);
    show_summary();
    show_detail();
}

void ProblemPanel::show_summary() {
    if (!models_.workspace.is_open() || !models_.problems.is_checked()) {
        summary_->setText(models_.workspace.is_open() ? tr("checking …") : QString());
        return;
    }
    const auto& check = models_.problems.check();
    QString text = models_.problems.summary();
    if (!check.signed_off_at.empty()) {
        text += tr("; signed off %1 by %2").arg(qt(check.signed_off_at).left(10), qt(check.signed_off_by));
    }
    const QStringList later = models_.problems.changes_since_sign_off();
    if (!later.isEmpty()) text += tr("; %n change(s) since", nullptr, static_cast<int>(later.size()));
    if (models_.problems.is_comparing_surfaces()) text += tr("; the surfaces are still being compared");
    summary_->setText(text);
    summary_->setToolTip(later.join(QLatin1Char('\n')));
}

void ProblemPanel::add_suspect(QVBoxLayout* column, std::size_t at, const SuspectLine& suspect) {
    auto* sentence = text_label(suspect.percent > 0 ? tr("%1   (%2 %)").arg(suspect.sentence).arg(suspect.percent)
                                                    : suspect.sentence);
    QFont bold = sentence->font();
    bold.setWeight(QFont::DemiBold);
    sentence->setFont(bold);
    column->addWidget(sentence);
    for (const QString& why : suspect.reasons) column->addWidget(text_label(QStringLiteral("– ") + why, "faint"));
    auto* buttons = new FlowLayout(6);
    const bool writable = models_.workspace.read_only_because().isEmpty();
    for (const ProblemAction action : suspect.actions) {
        auto* button = new QPushButton(action_word(action));
        button->setEnabled(writable);
        button->setObjectName(QStringLiteral("suspect%1action%2").arg(at).arg(static_cast<int>(action)));
        connect(button, &QPushButton::clicked, this, [this, at, action] { act(at, action); });
        buttons->addWidget(button);
    }
    column->addLayout(buttons);
}

void ProblemPanel::show_detail() {
    const ProblemDetail detail = models_.problems.detail();
    if (models_.problems.opened() >= 0 && list_->currentIndex().row() != models_.problems.opened()) {
        list_->setCurrentIndex(models_.problems.index(models_.problems.opened()));
    }
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    show_page(page);
    if (detail.id.isEmpty()) {
        column->addWidget(
            text_label(tr("Choose a problem: its proof shows in the matrix and in every other view."), "faint"));
        const QStringList later = models_.problems.changes_since_sign_off();
        if (!later.isEmpty()) column->addWidget(text_label(tr("Changed after the day was signed off"), "heading"));
        for (const QString& line : later) column->addWidget(text_label(line, "faint"));
        for (const QString& line : models_.problems.coverage()) column->addWidget(text_label(line, "faint"));
        return;
    }
    column->addWidget(text_label(detail.title, "title"));
    column->addWidget(text_label(detail.message));
    auto* known = new QPushButton(tr("Known because …"));
    known->setObjectName(QStringLiteral("acceptProblem"));
    known->setEnabled(models_.workspace.read_only_because().isEmpty());
    connect(known, &QPushButton::clicked, this, &ProblemPanel::accept);
    column->addWidget(known, 0, Qt::AlignLeft); // below: beside a long title it would widen the page
    if (!detail.suspects.empty()) column->addWidget(text_label(tr("What to doubt"), "heading"));
    for (std::size_t i = 0; i < detail.suspects.size(); ++i) add_suspect(column, i, detail.suspects[i]);
    if (!detail.proof.isEmpty()) {
        column->addWidget(text_label(tr("Rests on"), "heading"));
        column->addWidget(text_label(detail.proof.join(QStringLiteral(",  ")), "faint"));
    }
    if (!detail.evidence.isEmpty()) {
        column->addWidget(text_label(tr("Numbers"), "heading"));
        column->addWidget(text_label(detail.evidence.join(QStringLiteral("    ")), "faint"));
    }
}

// In place of the words of the problem before; the picture below them stays.
void ProblemPanel::show_page(QWidget* page) {
    const std::unique_ptr<QLayoutItem> before(detail_->replaceWidget(detail_->itemAt(0)->widget(), page));
    before->widget()->deleteLater();
    before->widget()->hide();
    scroll_->verticalScrollBar()->setValue(0);
}

void ProblemPanel::act(std::size_t suspect, ProblemAction action) {
    const bool wants_number = action == ProblemAction::SplitUnit;
    const ReasonAnswer answer =
        ask_(this, action_word(action), wants_number ? tr("Number of the new unit") : QString());
    if (answer.because.isEmpty() || (wants_number && answer.number.isEmpty())) return;
    models_.problems.act(suspect, action, answer.because, answer.number);
}

void ProblemPanel::accept() {
    const ReasonAnswer answer = ask_(this, tr("Keep it silent"), {});
    if (!answer.because.isEmpty()) models_.problems.accept(answer.because);
}

} // namespace planum::gui
