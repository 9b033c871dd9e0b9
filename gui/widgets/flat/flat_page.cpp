// SPDX-License-Identifier: MIT
#include "gui/widgets/flat/flat_page.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/widgets/flat/flat_canvas.hpp"
#include "gui/widgets/flat/outline_bar.hpp"

namespace planum::gui {

FlatPage::FlatPage() : place_(new QLabel) {}

void FlatPage::lay_out(const QString& name, FlatCanvas* canvas, OutlineBar* bar, const QList<QWidget*>& choices) {
    setObjectName(name);
    place_->setObjectName(name + QStringLiteral("Place"));
    place_->setProperty("role", "faint");
    place_->setMinimumWidth(230);
    place_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* fit = new QToolButton;
    fit->setText(tr("Fit"));
    fit->setToolTip(tr("Shows the whole (F)"));
    connect(fit, &QToolButton::clicked, canvas, &FlatCanvas::fit);
    connect(canvas, &FlatCanvas::hovered, this, [this](QPointF place) { place_->setText(words_for(place)); });
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* top = new QHBoxLayout;
    const bool two_lines = choices.size() > 1;
    top->setContentsMargins(choices.isEmpty() ? 0 : 8, two_lines ? 6 : 0, 8, 0);
    top->setSpacing(8);
    for (QWidget* choice : choices) top->addWidget(choice);
    if (two_lines) {
        top->addStretch(1);
    } else {
        top->addWidget(bar, 1);
    }
    top->addWidget(place_);
    top->addWidget(fit);
    column->addLayout(top);
    if (two_lines) column->addWidget(bar);
    column->addWidget(canvas, 1);
    setFocusProxy(canvas);
}

} // namespace planum::gui
