// SPDX-License-Identifier: MIT
#include "gui/widgets/flat/flat_page.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/widgets/flat/flat_canvas.hpp"
#include "gui/widgets/flat/outline_bar.hpp"
#include "gui/widgets/flow_layout.hpp"

namespace planum::gui {

namespace {

constexpr int kPlaceCharacters = 26;
constexpr int kBesideToolsCharacters = 17; // `x 104.25  y 203.60`, where tools take the rest of the line

} // namespace

FlatPage::FlatPage() : place_(new QLabel) {}

void FlatPage::lay_out(const QString& name, FlatCanvas* canvas, OutlineBar* bar, const QList<QWidget*>& choices) {
    setObjectName(name);
    place_->setObjectName(name + QStringLiteral("Place"));
    place_->setProperty("role", "faint");
    place_->setMinimumWidth(fontMetrics().averageCharWidth() *
                            (choices.isEmpty() ? kBesideToolsCharacters : kPlaceCharacters));
    place_->setAlignment((choices.isEmpty() ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    auto* fit = new QToolButton;
    fit->setText(tr("Fit"));
    fit->setToolTip(tr("Shows the whole (F)"));
    connect(fit, &QToolButton::clicked, canvas, &FlatCanvas::fit);
    connect(canvas, &FlatCanvas::hovered, this, [this](QPointF place) { place_->setText(words_for(place)); });
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    if (!choices.isEmpty()) {
        auto* head = new QWidget;
        auto* top = new FlowLayout(6);
        head->setLayout(top);
        top->setContentsMargins(8, 6, 8, 0);
        for (QWidget* choice : choices) top->addWidget(choice);
        top->addWidget(fit);
        top->addWidget(place_);
        column->addWidget(head);
        column->addWidget(bar);
    } else {
        auto* top = new QHBoxLayout;
        top->setContentsMargins(0, 0, 8, 0);
        top->setSpacing(8);
        top->addWidget(bar, 1);
        // One below the other: side by side they would leave the tools no room on a tablet.
        auto* corner = new QVBoxLayout;
        corner->setContentsMargins(0, 6, 0, 2);
        corner->setSpacing(2);
        corner->addWidget(fit, 0, Qt::AlignRight);
        corner->addWidget(place_);
        top->addLayout(corner);
        column->addLayout(top);
    }
    column->addWidget(canvas, 1);
    setFocusProxy(canvas);
}

} // namespace planum::gui
