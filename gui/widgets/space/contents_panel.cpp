// SPDX-License-Identifier: MIT
#include "gui/widgets/space/contents_panel.hpp"

#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include "gui/viewmodels/space_contents.hpp"

namespace planum::gui {

namespace {

constexpr int kCharacters = 26; // of a name that is read without scrolling

} // namespace

ContentsPanel::ContentsPanel(SpaceContents& contents) : contents_(contents), tree_(new QTreeView) {
    setObjectName(QStringLiteral("spaceContents"));
    tree_->setObjectName(QStringLiteral("spaceTree"));
    tree_->setAccessibleName(tr("What is shown in 3D"));
    tree_->setHeaderHidden(true);
    tree_->setUniformRowHeights(true);
    tree_->setModel(&contents_);
    auto* follow = new QToolButton;
    follow->setObjectName(QStringLiteral("spaceFollow"));
    follow->setText(tr("As the time line"));
    follow->setToolTip(tr("Show what the time line stands on, and forget what was checked and cleared here"));
    connect(follow, &QToolButton::clicked, &contents_, &SpaceContents::follow_time_line);
    const auto say = [this, follow] { follow->setEnabled(contents_.is_chosen()); };
    connect(&contents_, &SpaceContents::choiceChanged, this, say);
    say();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 0, 0, 6);
    column->addWidget(tree_, 1);
    column->addWidget(follow);
    setFixedWidth(fontMetrics().averageCharWidth() * kCharacters + tree_->indentation() * 3);
    setFocusProxy(tree_);
    const auto place = [](const QModelIndex& index) { return index.data(SpaceContents::PlaceIdRole).toString(); };
    connect(tree_, &QTreeView::expanded, this, [this, place](const QModelIndex& index) {
        if (!index.parent().isValid()) open_.insert(place(index));
    });
    connect(tree_, &QTreeView::collapsed, this, [this, place](const QModelIndex& index) {
        if (!index.parent().isValid()) open_.remove(place(index));
    });
    connect(&contents_, &SpaceContents::modelReset, this, &ContentsPanel::open_again);
    open_current();
}

void ContentsPanel::open_again() {
    const QSet<QString> open = open_;
    for (int row = 0; row < contents_.rowCount({}); ++row) {
        const QModelIndex index = contents_.index(row, 0, {});
        if (open.contains(index.data(SpaceContents::PlaceIdRole).toString())) tree_->expandRecursively(index);
    }
    if (open.isEmpty()) open_current();
}

// Who opens the list looks for what lies in front of him.
void ContentsPanel::open_current() {
    const QModelIndex index = contents_.current();
    if (!index.isValid()) return;
    tree_->expandRecursively(index);
    tree_->setCurrentIndex(index);
    tree_->scrollTo(index, QAbstractItemView::PositionAtTop);
}

} // namespace planum::gui
