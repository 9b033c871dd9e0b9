// SPDX-License-Identifier: MIT
#include "gui/widgets/text_label.hpp"

namespace planum::gui {

QLabel* text_label(const QString& text, const char* role) {
    auto* made = new QLabel(text);
    made->setProperty("role", role);
    made->setWordWrap(true);
    made->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return made;
}

} // namespace planum::gui
