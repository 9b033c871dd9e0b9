// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strat/exchange/imported_record.hpp"

namespace planum::strat {

/// One row of a table with the line it began on (quoted cells may span lines).
struct TableRow {
    std::int64_t line = 0; ///< from 1
    std::vector<std::string> cells;
};

/// A delimited text table: comma, semicolon, tab or bar, found by itself; quotes doubled inside quotes;
/// UTF-8 with or without BOM, UTF-16 with BOM, else Windows-1252.
struct DelimitedTable {
    char delimiter = ',';
    std::string encoding; ///< utf-8, utf-16, windows-1252
    std::vector<TableRow> rows;
    std::vector<ReadNote> notes; ///< replaced characters, a quote that never closes, …
};

struct TableOptions {
    char delimiter = '\0';     ///< 0: find it
    std::string_view encoding; ///< empty: find it
};

/// Parses leniently: never throws for content, reports what it had to mend. Cells are trimmed of blanks
/// outside quotes only.
[[nodiscard]] DelimitedTable parse_table(std::string_view bytes, std::string_view file_name,
                                         const TableOptions& options = {});

/// Text of a file as UTF-8 with line feeds: BOM, UTF-16 and Windows-1252 are dealt with as in tables,
/// control characters replaced and noted.
struct DecodedText {
    std::string text;
    std::string encoding;
    std::vector<ReadNote> notes;
};

[[nodiscard]] DecodedText decode_text(std::string_view bytes, std::string_view file_name,
                                      std::string_view encoding = {});

/// Column positions by header name: folded case, blanks and hyphens as underscores.
class TableHeader {
  public:
    explicit TableHeader(const TableRow& row);

    [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
    /// The first of several names that is there.
    [[nodiscard]] std::optional<std::size_t> find_any(std::span<const std::string_view> names) const;

    [[nodiscard]] bool has(std::string_view name) const { return find(name).has_value(); }

    [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }

  private:
    std::vector<std::string> names_;
};

/// The cell, trimmed, or empty when the row is shorter.
[[nodiscard]] std::string_view cell(const TableRow& row, std::optional<std::size_t> column);

/// Writes one row: quotes where needed, and a leading apostrophe before = + - @ so that no spreadsheet
/// takes text for a formula (only where `guard_formulas`).
struct RowWriter {
    char delimiter = ',';
    std::string_view line_end = "\n";
    bool always_quote = false;
    bool guard_formulas = false;

    [[nodiscard]] std::string write(std::span<const std::string> cells) const;
};

} // namespace planum::strat
