// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace planum::gui {

/// What the list of a kind of record is called in the window, `Finds` for `find`; the word itself where it has none.
[[nodiscard]] QString record_list_title(const QString& kind);

/// What a field of a record is called in the window, `Found on` for `found-on`; the name itself where it has none.
[[nodiscard]] QString record_field_label(const QString& field);

} // namespace planum::gui
