// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <string>

namespace planum::gui {

/// What a change of the project is called, in the language of the window. In the project changes have English names,
/// for everybody alike; names that are not known stay as they are.
[[nodiscard]] QString change_label(const std::string& english);

/// What changes and problems of a file name, `unit 1042`, in the language of the window; other words stay.
[[nodiscard]] QString thing_word(const std::string& english);

} // namespace planum::gui
