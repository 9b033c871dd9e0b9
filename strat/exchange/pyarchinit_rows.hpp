// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "strat/exchange/dating_text.hpp"
#include "strat/exchange/record_builder.hpp"

namespace planum::strat {

/// The tables of pyArchInit that are read, whether they come from its database or as CSV.
enum class PyarchinitTable { Units, Periods, PairsOfUnits, Levels, Finds, Samples, Datings };

/// One row: texts by column name, and where it stands (line of a CSV, row number of a database table).
struct PyarchinitRow {
    std::map<std::string, std::string, std::less<>> fields; ///< names in lower case
    std::string file;
    std::string table;       ///< of a database; empty in a CSV
    std::int64_t line = 0;   ///< in a database the number of the row
    std::optional<double> x; ///< of a level's point [m], site grid
    std::optional<double> y;

    /// The text of a column, trimmed; empty when the table has no such column.
    [[nodiscard]] std::string_view get(std::string_view column) const;
    /// The first of several columns that holds something.
    [[nodiscard]] std::string_view get_any(std::initializer_list<std::string_view> columns) const;
};

/// Gathers rows of all tables first, in any order, and makes one record of them in the end.
class PyarchinitRows {
  public:
    explicit PyarchinitRows(const ReadOptions& options) : options_(options), builder_(options) {}

    void add(PyarchinitTable table, PyarchinitRow row) { rows_[table].push_back(std::move(row)); }

    void add_notes(std::vector<ReadNote> notes) { builder_.add_notes(std::move(notes)); }

    void note(const Place& place, std::string_view code, std::string message) {
        builder_.note(place, code, std::move(message));
    }

    [[nodiscard]] Imported<ImportedRecord> finish();

  private:
    struct PhaseYears {
        std::set<std::string> titles;
        std::set<std::pair<std::optional<model::Year>, std::optional<model::Year>>> spans;
    };

    void note(const PyarchinitRow& row, const Place& place, std::string_view code, std::string_view message);
    void choose_site();
    [[nodiscard]] bool is_taken(const PyarchinitRow& row) const;
    [[nodiscard]] UnitName name_of(const PyarchinitRow& row, std::string_view area, std::string_view number) const;
    ImportedPhase& phase(const std::string& period, const std::string& phase);

    void read_unit(const PyarchinitRow& row);
    void read_unit_phase(const PyarchinitRow& row, const UnitName& name);
    void read_unit_dating(const PyarchinitRow& row, const UnitName& name);
    void read_relations(const PyarchinitRow& row);
    void state(const PyarchinitRow& row, const UnitName& unit, const struct PyarchinitRelation& relation);
    [[nodiscard]] UnitName unit_named(const PyarchinitRow& row, std::string_view number);
    void read_pair(const PyarchinitRow& row);
    void read_period(const PyarchinitRow& row);
    void read_level(const PyarchinitRow& row);
    void read_unit_levels(const PyarchinitRow& row, const UnitName& name);
    void read_find(const PyarchinitRow& row);
    void read_sample(const PyarchinitRow& row);
    [[nodiscard]] std::optional<YearSpan> years_of(std::string_view dating) const;
    void set_phase_years();

    ReadOptions options_;
    RecordBuilder builder_;
    std::map<PyarchinitTable, std::vector<PyarchinitRow>> rows_;
    std::string site_;           ///< the one taken; empty: all
    std::set<UnitName> not_dug_; ///< nodes of the Extended Matrix that are no units in the ground
    std::set<std::tuple<UnitName, model::RelationKind, UnitName>> stated_;
    std::multimap<std::string, UnitName> by_number_; ///< made when the first pair is read
    std::map<std::string, std::size_t, std::less<>> phase_at_;
    std::map<std::string, PhaseYears, std::less<>> phase_years_;
    std::map<std::string, std::string, std::less<>> dating_words_;
};

} // namespace planum::strat
