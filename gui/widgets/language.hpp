// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>

namespace planum::gui {

/// Codes of the languages of the window: `en` and `de` complete, `it` and `fr` prepared (what is not translated yet
/// is English).
[[nodiscard]] QStringList languages();

/// A language's own name for itself: `Deutsch`.
[[nodiscard]] QString language_name(const QString& code);

/// What was chosen in the window; where nothing was, the system's if it is one of languages(), else `en`.
[[nodiscard]] QString chosen_language();
/// Keeps it for the next start.
void choose_language(const QString& code);

/// What the window is in: given to this start, or chosen_language().
[[nodiscard]] QString window_language();

/// Puts the whole program into that language; empty: chosen_language(). Before the first window is made.
void apply_language(const QString& code);

} // namespace planum::gui
