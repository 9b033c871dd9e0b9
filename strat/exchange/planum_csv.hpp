// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "strat/exchange/delimited_table.hpp"

namespace planum::strat {

/// The tables of our own CSV, told apart by their columns.
enum class CsvTable {
    Units,
    Relations,
    Members, ///< group, unit: who belongs to which group
    Levels,
    Finds,
    Samples,
    Documents,
    Datings,
    Phases,
    Periods,
    Groups,
    Areas,
};

inline constexpr CsvTable kAllCsvTables[] = {
    CsvTable::Areas,  CsvTable::Periods, CsvTable::Phases,  CsvTable::Groups,    CsvTable::Units,   CsvTable::Members,
    CsvTable::Levels, CsvTable::Finds,   CsvTable::Samples, CsvTable::Documents, CsvTable::Datings, CsvTable::Relations,
};

/// The columns that a table may have, in the order in which they are written.
[[nodiscard]] std::span<const std::string_view> csv_columns(CsvTable table);

/// `units`, `relations`, …: what the files of a written record are called.
[[nodiscard]] std::string_view csv_name(CsvTable table) noexcept;

/// Which table has these columns; nullopt when none.
[[nodiscard]] std::optional<CsvTable> csv_table_of(const TableHeader& header);

/// Takes back the apostrophe that RowWriter puts before formulas.
[[nodiscard]] std::string without_formula_guard(std::string_view cell);

/// `YYYY-MM-DD` from that or from `D.M.YYYY` and `D/M/YYYY`; nullopt for anything else.
[[nodiscard]] std::optional<std::string> iso_date(std::string_view text);

} // namespace planum::strat
