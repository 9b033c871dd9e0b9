// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <string>

namespace planum::gui {

/// What a change of the project is called, in the language of the window. In the project changes have English names,
/// for everybody alike; names that are not known stay as they are.
[[nodiscard]] QString change_label(const std::string& english);

} // namespace planum::gui
