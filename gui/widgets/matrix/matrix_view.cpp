// SPDX-License-Identifier: MIT
#include "gui/widgets/matrix/matrix_view.hpp"

#include <QComboBox>
#include <QDateTime>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

#include "app/records/relation_entry.hpp"
#include "gui/viewmodels/models.hpp"
#include "gui/viewmodels/words.hpp"
#include "gui/widgets/flow_layout.hpp"
#include "gui/widgets/language.hpp"
#include "gui/widgets/matrix/matrix_canvas.hpp"
#include "gui/widgets/matrix/matrix_ink.hpp"
#include "gui/widgets/theme.hpp"
#include "strat/layout/drawing_colours.hpp"
#include "strat/layout/drawing_evidence.hpp"

namespace planum::gui {

MatrixView::MatrixView(Models& models)
    : models_(models), matrix_(models.workspace, models.problems, text_), canvas_(new MatrixCanvas(matrix_)),
      part_(new QComboBox), fold_(new QComboBox), titles_(new QToolButton), evidence_(new QToolButton),
      count_(new QLabel) {
    setObjectName(QStringLiteral("matrix"));
    matrix_.set_language(window_language().toStdString());
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(make_bar());
    column->addWidget(canvas_, 1);
    setFocusProxy(canvas_);
    connect(canvas_, &MatrixCanvas::relationWanted, this, &MatrixView::offer_relation);
    connect(&models_.workspace, &Workspace::selectionChanged, this, [this] {
        if (part_->currentData() == QLatin1String("around")) return ask_again();
        canvas_->show_selected();
    });
    connect(&models_.workspace, &Workspace::proofChanged, canvas_, &MatrixCanvas::show_proof);
    connect(&matrix_, &MatrixModel::drawn, this, [this] { count_->setText(words_of_drawing()); });
}

std::shared_ptr<const strat::MatrixDrawing> MatrixView::drawing_for_paper() const {
    const auto shown = matrix_.drawing();
    if (shown == nullptr || matrix_.verdicts().empty()) return shown;
    auto drawing = std::make_shared<strat::MatrixDrawing>(*shown);
    strat::EvidenceWords words;
    words.confirmed = tr("confirmed").toStdString();
    words.contradicted = tr("contradicted").toStdString();
    words.untestable = tr("not testable").toStdString();
    strat::show_evidence(*drawing, matrix_.verdicts(), words, text_);
    return drawing;
}

// Says what the lines mean as long as they show the evidence, else how many there are.
QString MatrixView::words_of_drawing() const {
    if (!matrix_.drawing()) return {};
    if (matrix_.verdicts().empty()) {
        return tr("%1 boxes, %2 lines").arg(matrix_.drawing()->boxes.size()).arg(matrix_.drawing()->lines.size());
    }
    using model::EvidenceVerdict;
    const auto part = [this](EvidenceVerdict verdict, const QString& sample, const QString& words) {
        const auto n = std::count(matrix_.verdicts().begin(), matrix_.verdicts().end(), verdict);
        const QColor colour = theme().drawn(strat::style_of(verdict).colour);
        return QStringLiteral("<span style='color:%1'>%2</span>&nbsp;%3&nbsp;%4")
            .arg(colour.name(), sample, QString::number(n), words);
    };
    return QStringList{part(EvidenceVerdict::Confirmed, QStringLiteral("━━"), tr("confirmed")),
                       part(EvidenceVerdict::Contradicted, QStringLiteral("╍╍"), tr("contradicted")),
                       part(EvidenceVerdict::Untestable, QStringLiteral("┈┈"), tr("not testable"))}
        .join(QStringLiteral(" &nbsp; "));
}

QWidget* MatrixView::make_bar() {
    part_->setObjectName(QStringLiteral("matrixPart"));
    part_->setAccessibleName(tr("Part of the matrix"));
    part_->addItem(tr("whole site"), QStringLiteral("all"));
    part_->addItem(tr("around the selected unit"), QStringLiteral("around"));
    part_->addItem(tr("only what problems are about"), QStringLiteral("problems"));
    part_->addItem(tr("what changed since yesterday"), QStringLiteral("since"));
    fold_->setObjectName(QStringLiteral("matrixFold"));
    fold_->setAccessibleName(tr("Folded"));
    fold_->addItem(tr("not folded"), QString());
    fold_->addItem(tr("phases folded"), QStringLiteral("phases"));
    fold_->addItem(tr("periods folded"), QStringLiteral("periods"));
    fold_->addItem(tr("groups folded"), QStringLiteral("groups"));
    titles_->setText(tr("Titles"));
    titles_->setCheckable(true);
    titles_->setToolTip(tr("Short definitions below the numbers"));
    evidence_->setObjectName(QStringLiteral("matrixEvidence"));
    evidence_->setText(tr("Evidence"));
    evidence_->setCheckable(true);
    evidence_->setToolTip(tr("Which lines surfaces, sections and levels confirm or contradict"));
    connect(evidence_, &QToolButton::toggled, &matrix_, &MatrixModel::set_shows_evidence);
    connect(part_, &QComboBox::activated, this, &MatrixView::ask_again);
    connect(fold_, &QComboBox::activated, this, &MatrixView::ask_again);
    connect(titles_, &QToolButton::toggled, this, &MatrixView::ask_again);
    const auto button = [&](const QString& text, const QString& tip, auto press) {
        auto* made = new QToolButton;
        made->setText(text);
        made->setToolTip(tip);
        made->setAccessibleName(tip);
        connect(made, &QToolButton::clicked, this, press);
        return made;
    };
    const auto middle = [this] { return QPointF(canvas_->width() / 2.0, canvas_->height() / 2.0); };
    count_->setProperty("role", "faint");
    auto* bar = new QWidget;
    auto* row = new FlowLayout(6);
    bar->setLayout(row);
    row->setContentsMargins(8, 6, 8, 6);
    for (QWidget* part : std::initializer_list<QWidget*>{part_, fold_, titles_, evidence_}) row->addWidget(part);
    row->addWidget(button(QStringLiteral("−"), tr("Smaller"), [=, this] { canvas_->zoom(0.8, middle()); }));
    row->addWidget(button(QStringLiteral("+"), tr("Larger"), [=, this] { canvas_->zoom(1.25, middle()); }));
    row->addWidget(button(tr("Fit"), tr("The whole drawing (F)"), [this] { canvas_->fit(); }));
    row->addWidget(count_);
    return bar;
}

void MatrixView::ask_again() {
    app::DrawRequest request;
    request.fold = fold_->currentData().toString().toStdString();
    request.titles = titles_->isChecked();
    const QString part = part_->currentData().toString();
    request.problems_only = part == QLatin1String("problems");
    if (part == QLatin1String("around") && models_.workspace.is_open() && !models_.workspace.selected().is_nil()) {
        request.around = models_.workspace.snapshot()->index().name(models_.workspace.selected());
    }
    if (part == QLatin1String("since")) {
        request.since = QDateTime::currentDateTimeUtc().addDays(-1).toString(Qt::ISODate).left(10).toStdString();
    }
    canvas_->fit();
    matrix_.set_request(request);
}

// The kinds are asked for where the line ended; those that would close a circle say so, none is refused.
void MatrixView::offer_relation(model::UnitId from, model::UnitId to, const QPoint& at) {
    if (!models_.workspace.read_only_because().isEmpty())
        return models_.workspace.say(models_.workspace.read_only_because());
    const auto snapshot = models_.workspace.snapshot();
    const model::UnitIndex a = snapshot->index().find(from);
    const model::UnitIndex b = snapshot->index().find(to);
    if (a == model::kNoUnit || b == model::kNoUnit) return;
    const QString first = qt(snapshot->index().name(a));
    const QString second = qt(snapshot->index().name(b));
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setObjectName(QStringLiteral("relationMenu"));
    using model::RelationKind;
    for (const RelationKind kind :
         {RelationKind::Covers, RelationKind::Cuts, RelationKind::Fills, RelationKind::Abuts, RelationKind::Later,
          RelationKind::SameAs, RelationKind::BondsWith, RelationKind::Contemporary, RelationKind::Borders}) {
        const auto cycle =
            app::would_close_cycle(*snapshot, app::said_relation(snapshot->record(), a, {kind, false}, b));
        QString text = QStringLiteral("%1 %2 %3").arg(first, relation_word({kind, false}), second);
        if (!cycle.empty()) text += tr("   – closes a circle");
        menu->addAction(text, this, [this, first, second, kind] {
            using Part = RelationEntryModel::Part;
            models_.entry.set(Part::Subject, first);
            models_.entry.set(Part::Kind, relation_word({kind, false}));
            models_.entry.set(Part::Object, second);
            models_.entry.commit();
        });
    }
    menu->popup(at);
}

void MatrixView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    matrix_.set_watched(true);
}

void MatrixView::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    matrix_.set_watched(false);
}

} // namespace planum::gui
