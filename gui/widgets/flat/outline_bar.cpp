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

namespace {

constexpr int kSentenceCharacters = 44; // in two lines

} // namespace

OutlineBar::OutlineBar(Models& models, const QString& view, Offers offers)
    : models_(models), view_(view), draw_(new QToolButton), change_(new QToolButton), offer_(new QToolButton),
      remove_(new QToolButton), unit_(new QLineEdit), category_(new QComboBox), shows_(new QComboBox),
      back_(new QToolButton), finish_(new QToolButton), cancel_(new QToolButton), sentence_(new QLabel) {
    using model::RegionCategory;
    using model::RegionShows;
    draw_->setText(tr("Draw an outline"));
    draw_->setCheckable(true);
    draw_->setObjectName(view + QStringLiteral("Draw"));
    change_->setText(tr("Change an outline"));
    change_->setToolTip(tr("Moves, sets and takes away corners of an outline that is there"));
    change_->setCheckable(true);
    change_->setObjectName(view + QStringLiteral("Change"));
    offer_->setText(tr("Name what changed"));
    offer_->setToolTip(tr("Offers ground that changed since the surface before and has no outline yet"));
    offer_->setCheckable(true);
    offer_->setObjectName(view + QStringLiteral("Offer"));
    offer_->setVisible(offers == Offers::Patches);
    remove_->setText(tr("Corner away"));
    remove_->setToolTip(tr("Takes the chosen corner away (Delete, or the right button on it)"));
    remove_->setObjectName(view + QStringLiteral("RemoveCorner"));
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
    back_->setObjectName(view + QStringLiteral("Back"));
    finish_->setText(tr("Finish"));
    finish_->setObjectName(view + QStringLiteral("Finish"));
    cancel_->setText(tr("Cancel"));
    cancel_->setToolTip(tr("Esc; can be taken back"));
    sentence_->setProperty("role", "faint");
    // A narrow window gets a second line of tools instead of growing wider than the screen; whatever the sentence
    // says, it takes the same room, so that the picture does not move between two corners.
    sentence_->setFixedSize(fontMetrics().averageCharWidth() * kSentenceCharacters, theme().touch + 8);
    sentence_->setWordWrap(true);
    auto* row = new FlowLayout(6);
    setLayout(row);
    row->setContentsMargins(8, 6, 8, 6);
    row->addWidget(draw_);
    row->addWidget(change_);
    if (offers == Offers::Patches) {
        row->addWidget(offer_);
    } else {
        offer_->setParent(this);
    }
    for (QWidget* part : std::initializer_list<QWidget*>{unit_, category_, shows_, remove_, back_, finish_, cancel_}) {
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
    OutlineEdit& edit = models_.edit;
    connect(change_, &QToolButton::clicked, this, &OutlineBar::toggle_change);
    connect(remove_, &QToolButton::clicked, this, [&edit] {
        if (edit.can_remove()) edit.remove(*edit.held());
    });
    connect(offer_, &QToolButton::clicked, this, &OutlineBar::toggle_offer);
    connect(back_, &QToolButton::clicked, this, &OutlineBar::step_back);
    connect(finish_, &QToolButton::clicked, this, &OutlineBar::finish);
    connect(cancel_, &QToolButton::clicked, this, &OutlineBar::cancel);
    connect(unit_, &QLineEdit::returnPressed, this, [this] {
        if (is_offering()) models_.patches.finish();
    });
    connect(&models_.patches, &PatchModel::changed, this, &OutlineBar::refresh);
    connect(&tool, &OutlineTool::changed, this, &OutlineBar::refresh);
    connect(&edit, &OutlineEdit::changed, this, &OutlineBar::refresh);
    connect(&models_.workspace, &Workspace::snapshotChanged, this, &OutlineBar::refresh);
    refresh();
}

bool OutlineBar::is_drawing() const { return models_.outline.is_active(view_); }

bool OutlineBar::is_changing() const { return models_.edit.is_active(view_); }

bool OutlineBar::is_offering() const { return models_.patches.is_active(view_); }

void OutlineBar::set_ground(OutlineTool::ToOutlines to_outlines, const QString& why, EditGround edit) {
    to_outlines_ = std::move(to_outlines);
    edit_ground_ = std::move(edit);
    why_not_ = why;
    // What was begun on another ground belongs there.
    if (is_drawing()) models_.outline.end();
    if (is_changing()) models_.edit.end();
    refresh();
}

void OutlineBar::toggle(bool draw) {
    models_.edit.end();
    models_.patches.end();
    if (draw && to_outlines_) {
        models_.outline.begin(view_, to_outlines_);
    } else {
        models_.outline.end();
    }
}

void OutlineBar::toggle_change(bool change) {
    models_.outline.end();
    models_.patches.end();
    if (change && edit_ground_.to_view) {
        models_.edit.begin(view_, edit_ground_);
    } else {
        models_.edit.end();
    }
}

void OutlineBar::toggle_offer(bool offer) {
    models_.outline.end();
    models_.edit.end();
    if (offer) {
        models_.patches.begin(view_);
    } else {
        models_.patches.end();
    }
}

void OutlineBar::step_back() { is_changing() ? models_.edit.take_back() : models_.outline.take_back(); }

void OutlineBar::finish() {
    if (is_offering()) return models_.patches.finish();
    is_changing() ? models_.edit.finish() : models_.outline.finish();
}

void OutlineBar::cancel() {
    if (is_offering()) return models_.patches.end();
    is_changing() ? models_.edit.cancel() : models_.outline.cancel();
}

void OutlineBar::refresh() {
    const OutlineTool& tool = models_.outline;
    const OutlineEdit& edit = models_.edit;
    const PatchModel& patches = models_.patches;
    const bool drawing = is_drawing();
    const bool changing = is_changing();
    const bool offering = is_offering();
    const bool naming = offering && patches.chosen() >= 0;
    const bool writable = models_.workspace.is_open() && models_.workspace.read_only_because().isEmpty();
    draw_->setChecked(drawing);
    draw_->setEnabled(writable && static_cast<bool>(to_outlines_));
    change_->setChecked(changing);
    change_->setEnabled(writable && static_cast<bool>(edit_ground_.to_view));
    offer_->setChecked(offering);
    offer_->setEnabled(writable && static_cast<bool>(to_outlines_));
    if (unit_->text() != tool.unit()) unit_->setText(tool.unit());
    unit_->setEnabled(tool.category() == model::RegionCategory::Unit);
    category_->setCurrentIndex(category_->findData(static_cast<int>(tool.category())));
    shows_->setCurrentIndex(shows_->findData(tool.shows() ? static_cast<int>(*tool.shows()) : -1));
    for (QWidget* part : std::initializer_list<QWidget*>{unit_, category_, shows_}) part->setVisible(drawing || naming);
    back_->setVisible(drawing || changing);
    back_->setEnabled(!changing || edit.is_changed());
    finish_->setVisible(drawing || changing || naming);
    finish_->setEnabled(naming ? patches.can_finish() : changing ? edit.is_changed() : tool.can_finish());
    cancel_->setVisible(drawing || changing || offering);
    remove_->setVisible(changing);
    remove_->setEnabled(edit.can_remove());
    say_what_buttons_do();
    const QString said = offering   ? patches.sentence()
                         : changing ? edit.sentence()
                         : drawing  ? tool.unit_sentence()
                                    : why_not_;
    sentence_->setText(said);
    sentence_->setToolTip(said);
    sentence_->setVisible(drawing || changing || offering || !why_not_.isEmpty());
}

void OutlineBar::say_what_buttons_do() {
    const bool changing = is_changing();
    const bool offering = is_offering();
    back_->setText(changing ? tr("Step back") : tr("Corner back"));
    back_->setToolTip(changing ? tr("Takes the last change of this outline back (Ctrl+Z)")
                               : tr("Takes the last corner back (Backspace, Ctrl+Z); brings a cancelled outline back"));
    finish_->setText(offering ? tr("Take it") : tr("Finish"));
    finish_->setToolTip(offering   ? tr("Makes an outline of the patch, of the unit beside it (Enter)")
                        : changing ? tr("Keeps the outline as it is now (Enter)")
                                   : tr("Closes the outline (Enter, or a click on the first corner)"));
}

} // namespace planum::gui
