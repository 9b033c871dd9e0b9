// SPDX-License-Identifier: MIT
#pragma once

#include <QSet>
#include <QString>
#include <QWidget>

class QModelIndex;
class QTreeView;

namespace planum::gui {

class SpaceContents;

/// The tree of what 3D shows, beside the picture: arrows and the space bar do all of it.
class ContentsPanel : public QWidget {
    Q_OBJECT

  public:
    explicit ContentsPanel(SpaceContents& contents);

  private:
    void open_again();
    void open_current();

    SpaceContents& contents_;
    QTreeView* tree_;
    QSet<QString> open_; ///< places that are open in the tree, since a changed record makes it anew
};

} // namespace planum::gui
