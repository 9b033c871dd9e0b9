// SPDX-License-Identifier: MIT
#include "gui/widgets/flat/outline_bar.hpp"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

#include <utility>

#include "gui/viewmodels/models.hpp"
#include "gui/viewmodels/words.hpp"
#include "gui/widgets/flow_layout.hpp"
#include "gui/widgets/theme.hpp"

namespace planum::gui {

OutlineBar::OutlineBar(Models& models, const QString& view)
    : models_(models), view_(view), draw_(new QToolButton), unit_(new QLineEdit), category_(new QComboBox),
      shows_(new QComboBox), back_(new QToolButton), finish_(new QToolButton), cancel_(new QToolButton),
      sentence_(new QLabel) {
    using model::RegionCategory;
    using model::RegionShows;
    draw_->setText(tr("Draw an outline"));
    draw_->setCheckable(true);
    draw_->setObjectName(view + QStringLiteral("Draw"));
    unit_->setObjectName(view + QStringLiteral("OutlineUnit"));
    unit_->setPlaceholderText(tr("unit"));
    unit_->setAccessibleName(tr("Unit of the outline"));
    unit_->setFixedWidth(90);
    category_->setAccessibleName(tr("What the outline encloses"));
    for (const auto category :
         {RegionCategory::Unit, RegionCategory::Spoil, RegionCategory::Slump, RegionCategory::Backfill,
          RegionCategory::Water, RegionCategory::Equipment, RegionCategory::Baulk, RegionCategory::Unexcavated}) {
        category_->addItem(category_word(category), static_cast<int>(category));
    }
    shows_->setAccessibleName(tr("What the outline shows of it"));
    shows_->addItem(tr("shows: by kind"), -1);
    for (const auto shows : {RegionShows::Top, RegionShows::Level, RegionShows::Cut, RegionShows::Overdug,
                             RegionShows::Machine, RegionShows::Face, RegionShows::Nothing}) {
        shows_->addItem(shows_word(shows), static_cast<int>(shows));
    }
    back_->setText(tr("Corner back"));
    back_->setToolTip(tr("Takes the last corner back (Backspace, Ctrl+Z); brings a cancelled outline back"));
    finish_->setText(tr("Finish"));
    finish_->setObjectName(view + QStringLiteral("Finish"));
    finish_->setToolTip(tr("Closes the outline (Enter, or a click on the first corner)"));
    cancel_->setText(tr("Cancel"));
    cancel_->setToolTip(tr("Esc; can be taken back"));
    sentence_->setProperty("role", "faint");
    // A narrow window gets a second line of tools instead of growing wider than the screen; whatever the sentence
    // says, it takes the same room, so that the picture does not move between two corners.
    sentence_->setFixedSize(300, theme().touch + 6);
    sentence_->setWordWrap(true);
    auto* row = new FlowLayout(6);
    setLayout(row);
    row->setContentsMargins(8, 6, 8, 6);
    row->addWidget(draw_);
    for (QWidget* part : std::initializer_list<QWidget*>{unit_, category_, shows_, back_, finish_, cancel_}) {
        part->setMinimumHeight(theme().touch);
        row->addWidget(part);
    }
    row->addWidget(sentence_);
    OutlineTool& tool = models_.outline;
    connect(draw_, &QToolButton::clicked, this, &OutlineBar::toggle);
    connect(unit_, &QLineEdit::textEdited, &tool, &OutlineTool::set_unit);
    connect(category_, &QComboBox::activated, this, [this] {
        models_.outline.set_category(static_cast<model::RegionCategory>(category_->currentData().toInt()));
    });
    connect(shows_, &QComboBox::activated, this, [this] {
        const int value = shows_->currentData().toInt();
        models_.outline.set_shows(value < 0 ? std::nullopt : std::optional(static_cast<model::RegionShows>(value)));
    });
    connect(back_, &QToolButton::clicked, &tool, &OutlineTool::take_back);
    connect(finish_, &QToolButton::clicked, &tool, &OutlineTool::finish);
    connect(cancel_, &QToolButton::clicked, &tool, &OutlineTool::cancel);
    connect(&tool, &OutlineTool::changed, this, &OutlineBar::refresh);
    connect(&models_.workspace, &Workspace::snapshotChanged, this, &OutlineBar::refresh);
    refresh();
}

void OutlineBar::set_ground(OutlineTool::ToOutlines to_outlines, const QString& why) {
    to_outlines_ = std::move(to_outlines);
    why_not_ = why;
    // What was begun on another ground belongs there.
    if (models_.outline.is_active(view_)) models_.outline.end();
    refresh();
}

void OutlineBar::toggle(bool draw) {
    if (draw && to_outlines_) {
        models_.outline.begin(view_, to_outlines_);
    } else {
        models_.outline.end();
    }
}

void OutlineBar::refresh() {
    const OutlineTool& tool = models_.outline;
    const bool active = tool.is_active(view_);
    const bool writable = models_.workspace.is_open() && models_.workspace.read_only_because().isEmpty();
    draw_->setChecked(active);
    draw_->setEnabled(writable && static_cast<bool>(to_outlines_));
    if (unit_->text() != tool.unit()) unit_->setText(tool.unit());
    unit_->setEnabled(tool.category() == model::RegionCategory::Unit);
    category_->setCurrentIndex(category_->findData(static_cast<int>(tool.category())));
    shows_->setCurrentIndex(shows_->findData(tool.shows() ? static_cast<int>(*tool.shows()) : -1));
    for (QWidget* part : std::initializer_list<QWidget*>{unit_, category_, shows_, back_, finish_, cancel_}) {
        part->setVisible(active);
    }
    finish_->setEnabled(tool.can_finish());
    sentence_->setText(active ? tool.unit_sentence() : why_not_);
    sentence_->setVisible(active || !why_not_.isEmpty());
}

} // namespace planum::gui
