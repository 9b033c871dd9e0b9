// SPDX-License-Identifier: MIT
#include "gui/widgets/space/box_panel.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QSlider>
#include <QToolButton>

#include <algorithm>

namespace planum::gui {

namespace {

constexpr int kSteps = 1000;
constexpr int kLeast = 5; // steps that stay between the two ends

} // namespace

BoxPanel::BoxPanel() {
    setObjectName(QStringLiteral("spaceBox"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(8, 2, 8, 6);
    grid->setHorizontalSpacing(10);
    const std::array<QString, 3> names = {tr("West to east"), tr("South to north"), tr("Height")};
    for (std::size_t axis = 0; axis < names.size(); ++axis) {
        const auto row = static_cast<int>(axis);
        const auto slider = [&](int value, const QString& end, int column) {
            auto* made = new QSlider(Qt::Horizontal);
            made->setRange(0, kSteps);
            made->setValue(value);
            made->setAccessibleName(QStringLiteral("%1, %2").arg(names[axis], end));
            connect(made, &QSlider::valueChanged, this, &BoxPanel::say);
            grid->addWidget(made, row, column);
            return made;
        };
        grid->addWidget(new QLabel(names[axis]), row, 0);
        low_[axis] = slider(0, tr("from"), 1);
        high_[axis] = slider(kSteps, tr("to"), 2);
    }
    auto* all = new QToolButton;
    all->setText(tr("Everything"));
    all->setToolTip(tr("Cut nothing away"));
    connect(all, &QToolButton::clicked, this, &BoxPanel::reset);
    grid->addWidget(all, 0, 3, 3, 1);
}

void BoxPanel::reset() {
    for (std::size_t axis = 0; axis < low_.size(); ++axis) {
        const QSignalBlocker quiet_low(low_[axis]);
        const QSignalBlocker quiet_high(high_[axis]);
        low_[axis]->setValue(0);
        high_[axis]->setValue(kSteps);
    }
    say();
}

// An end that is pushed over the other one takes it along.
void BoxPanel::say() {
    std::array<double, 3> low{};
    std::array<double, 3> high{};
    for (std::size_t axis = 0; axis < low_.size(); ++axis) {
        if (low_[axis]->value() > high_[axis]->value() - kLeast) {
            QSlider* other = sender() == low_[axis] ? high_[axis] : low_[axis];
            const QSignalBlocker quiet(other);
            other->setValue(other == high_[axis] ? std::min(low_[axis]->value() + kLeast, kSteps)
                                                 : std::max(high_[axis]->value() - kLeast, 0));
        }
        low[axis] = static_cast<double>(low_[axis]->value()) / kSteps;
        high[axis] = static_cast<double>(high_[axis]->value()) / kSteps;
    }
    emit changed(low, high);
}

} // namespace planum::gui
