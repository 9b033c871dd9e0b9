// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <string>
#include <string_view>

namespace planum::gui {

// What the log of the project and an import name as the file stores it, in the language of the window.

/// What was done to a record: `recorded` for `insert`; the word itself where it is none of the log's.
[[nodiscard]] QString log_action_word(std::string_view action);

/// Who did it; other programs have no name in the log.
[[nodiscard]] QString author_word(const std::string& author);

/// A column of the file as the card or the lists call it: `Dug away on` for `excavated_on`.
[[nodiscard]] QString stored_field_label(const std::string& column);

/// What a column holds: kinds, forms and states by their words, all else as it is.
[[nodiscard]] QString stored_value_word(const std::string& column, const std::string& value);

} // namespace planum::gui
