// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "strat/exchange/write_support.hpp"

namespace planum::strat {

using XlsxCell = std::variant<std::monostate, std::string, double>;

/// One sheet of a workbook before it is written; every row has as many cells as there are columns.
struct XlsxSheet {
    const char* name;
    std::vector<std::string> columns;
    std::vector<std::vector<XlsxCell>> rows;
};

/// The record as sheets, a kind each, without the empty ones; never none.
[[nodiscard]] std::vector<XlsxSheet> xlsx_tables(const RecordNames& names);

} // namespace planum::strat
