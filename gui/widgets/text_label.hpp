// SPDX-License-Identifier: MIT
#pragma once

#include <QLabel>
#include <QString>

namespace planum::gui {

/// A sentence that wraps and can be copied. `role` is that of the style sheet: title, heading, faint; empty: plain.
[[nodiscard]] QLabel* text_label(const QString& text, const char* role = "");

} // namespace planum::gui
