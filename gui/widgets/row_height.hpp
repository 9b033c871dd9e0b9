// SPDX-License-Identifier: MIT
#pragma once

class QTableView;

namespace planum::gui {

/// Makes the rows of a table as high as what is pressed in this theme, less so many pixels, and again with each theme.
void keep_row_height(QTableView& table, int less);

} // namespace planum::gui
