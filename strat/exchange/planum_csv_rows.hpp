// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "strat/exchange/planum_csv.hpp"
#include "strat/exchange/record_builder.hpp"

namespace planum::strat {

/// One row of one of our tables: cells by column name, numbers with a note where they are none.
class CsvRow {
  public:
    CsvRow(const TableHeader& header, const TableRow& row, std::string_view file, RecordBuilder& builder)
        : header_(&header), row_(&row), file_(file), builder_(&builder) {}

    [[nodiscard]] std::string text(std::string_view column) const;
    [[nodiscard]] std::optional<double> number(std::string_view column) const;
    [[nodiscard]] std::optional<std::int64_t> integer(std::string_view column) const;
    /// An ISO date; what is none is reported and left out.
    [[nodiscard]] std::string date(std::string_view column) const;
    /// The unit in the columns `unit` and `area`.
    [[nodiscard]] UnitName unit(std::string_view column = "unit", std::string_view area_column = "area") const;
    /// A unit named without its area is of the same area as `near`.
    [[nodiscard]] UnitName unit_near(const UnitName& near, std::string_view text, std::string_view area) const;

    [[nodiscard]] Place place(std::string_view raw_text = {}) const { return {file_, row_->line, raw_text}; }

    [[nodiscard]] const TableHeader& header() const { return *header_; }

    [[nodiscard]] std::string_view at(std::size_t column) const { return cell(*row_, column); }

    void note(std::string_view raw_text, std::string_view code, std::string message) const;

  private:
    const TableHeader* header_;
    const TableRow* row_;
    std::string_view file_;
    RecordBuilder* builder_;
};

/// Reads a row of that table into the record. Columns that the table does not know are kept by units
/// only, under `custom`.
void read_csv_row(CsvTable table, const CsvRow& row, RecordBuilder& builder);

} // namespace planum::strat
