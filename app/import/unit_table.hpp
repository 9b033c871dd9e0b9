// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/base/uuid.hpp"
#include "core/model/record.hpp"
#include "strat/exchange/imported_record.hpp"

namespace planum::app {

/// The units of a record and those that an import adds, by name. Invariant: every unit has an id, and in
/// `Site` scope a number stands for one unit, in `Area` scope a number within its area.
class UnitTable {
  public:
    UnitTable(const model::Record& current, model::NumberScope scope, UuidSource& ids);

    struct Entry {
        model::StratigraphicUnit unit;
        bool is_new = false;
        bool is_changed = false;
    };

    /// Position of the unit a sheet is about; makes it when there is none.
    std::size_t of_sheet(const strat::UnitName& raw);

    /// Position of the unit that a relation of a unit in `from_area` means. A number without area is looked
    /// for in the speaker's area first, then wherever it is unique; else a mentioned unit is made.
    std::size_t mentioned(const strat::UnitName& raw, const std::string& from_area);

    [[nodiscard]] Entry& at(std::size_t position) { return entries_[position]; }

    [[nodiscard]] const std::vector<Entry>& entries() const noexcept { return entries_; }

    [[nodiscard]] const std::vector<model::Area>& new_areas() const noexcept { return new_areas_; }

    /// Id of the area with that name; makes it when there is none. Nil for an empty name.
    model::AreaId area(const std::string& name);

    /// The same with all that a source says of it. Only areas that this import makes take it; they are dug as the
    /// project is, unless a source says planum or mixed.
    void offer(const model::Area& area);
    [[nodiscard]] std::string area_name(model::AreaId id) const;

    /// `NUMBER`, with its area in front in `Area` scope.
    [[nodiscard]] std::string display(std::size_t position) const;
    /// Empty for a unit that is not here. Looks through all units: for a sentence now and then.
    [[nodiscard]] std::string display_of(model::UnitId id) const;

  private:
    [[nodiscard]] std::string key(const std::string& area, const std::string& number) const;
    std::size_t add(const strat::UnitName& name, model::UnitOrigin origin);

    model::NumberScope scope_;
    model::DigMethod method_;
    UuidSource* ids_;
    std::vector<Entry> entries_;
    std::vector<model::Area> new_areas_;
    std::unordered_map<std::string, model::AreaId> area_ids_;
    std::unordered_map<model::AreaId, std::string> area_names_;
    std::unordered_map<std::string, std::size_t> by_key_;
    std::unordered_map<std::string, std::vector<std::size_t>> by_number_;
};

} // namespace planum::app
