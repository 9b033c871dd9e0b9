// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>

#include <vector>

class QWidget;

namespace planum::gui {

/// One thing to choose.
struct Choice {
    QString label;
    QStringList items;
    QString first;         ///< chosen to begin with; empty: the first of `items`
    bool editable = false; ///< others may be typed
};

/// Asks for each of the choices at once; empty when the dialog was left. `what` is its title and what its button says.
[[nodiscard]] QStringList ask_choices(QWidget* parent, const QString& what, const std::vector<Choice>& choices);

} // namespace planum::gui
