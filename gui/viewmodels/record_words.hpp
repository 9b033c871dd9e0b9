// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace planum::gui {

/// What the list of a kind of record is called in the window, `Finds` for `find`; the word itself where it has none.
[[nodiscard]] QString record_list_title(const QString& kind);

/// One of that list, `find` for `find`.
[[nodiscard]] QString record_thing_word(const QString& kind);

/// What a field of a record is called in the window, `Found on` for `found-on`; the name itself where it has none.
[[nodiscard]] QString record_field_label(const QString& field);

/// What names a new one of a kind: `number`, `surface/unit`.
[[nodiscard]] QString record_name_form(const QString& kind);

/// A word of an enumeration as it is stored (`ante-quem` of the kind of a dating), as the window says it; the word
/// itself where it has none.
[[nodiscard]] QString record_value_word(const QString& kind, const QString& field, const QString& stored);

} // namespace planum::gui
