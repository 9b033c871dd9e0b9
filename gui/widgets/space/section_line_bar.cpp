// SPDX-License-Identifier: MIT
#include "gui/widgets/space/section_line_bar.hpp"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "gui/viewmodels/section_line.hpp"

namespace planum::gui {

SectionLineBar::SectionLineBar(SectionLine& line)
    : line_(line), said_(new QLabel), thickness_(new QDoubleSpinBox), face_(new QToolButton), over_(new QToolButton) {
    setObjectName(QStringLiteral("sectionLineBar"));
    said_->setObjectName(QStringLiteral("sectionLineSaid"));
    thickness_->setObjectName(QStringLiteral("sectionLineThickness"));
    thickness_->setAccessibleName(tr("Thickness"));
    thickness_->setRange(SectionLine::kThinnest, SectionLine::kThickest);
    thickness_->setSingleStep(0.02);
    thickness_->setDecimals(2);
    thickness_->setSuffix(QStringLiteral(" m"));
    face_->setObjectName(QStringLiteral("faceSectionLine"));
    face_->setText(tr("Look straight at it"));
    over_->setObjectName(QStringLiteral("showSectionLine"));
    over_->setText(tr("Show as a section"));
    over_->setToolTip(tr("In the section view, rectified"));
    auto* again = new QToolButton;
    again->setText(tr("Another line"));
    auto* off = new QToolButton;
    off->setObjectName(QStringLiteral("clearSectionLine"));
    off->setText(tr("Everything"));
    off->setToolTip(tr("Cut nothing away (Esc)"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 2, 8, 6);
    row->setSpacing(8);
    row->addWidget(said_);
    row->addSpacing(8);
    row->addWidget(new QLabel(tr("Thickness")));
    for (QWidget* part : std::initializer_list<QWidget*>{thickness_, face_, over_, again, off}) row->addWidget(part);
    row->addStretch(1);
    connect(thickness_, &QDoubleSpinBox::valueChanged, &line_, &SectionLine::set_thickness);
    connect(face_, &QToolButton::clicked, this, &SectionLineBar::faceWanted);
    connect(over_, &QToolButton::clicked, &line_, &SectionLine::hand_over);
    connect(again, &QToolButton::clicked, &line_, &SectionLine::begin);
    connect(off, &QToolButton::clicked, &line_, &SectionLine::clear);
    connect(&line_, &SectionLine::changed, this, &SectionLineBar::refresh);
    refresh();
}

void SectionLineBar::refresh() {
    setVisible(line_.state() != SectionLine::State::Off);
    said_->setText(line_.said());
    const bool is_set = line_.state() == SectionLine::State::Set;
    face_->setEnabled(is_set);
    over_->setEnabled(is_set);
    const QSignalBlocker quiet(thickness_);
    thickness_->setValue(line_.thickness());
}

} // namespace planum::gui
