// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/model/record.hpp"

namespace planum::strat {

/// What everything in a record is called in a file. Keeps a reference to the record.
class RecordNames {
  public:
    explicit RecordNames(const model::Record& record);

    /// `NUMBER`, or `AREA::NUMBER` where the number alone is not unique.
    [[nodiscard]] std::string unit(model::UnitId id) const { return index_.name(id); }

    [[nodiscard]] bool has(model::UnitId id) const { return index_.find(id) != model::kNoUnit; }

    [[nodiscard]] const model::StratigraphicUnit& unit_at(model::UnitId id) const {
        return record_->units[index_.find(id)];
    }

    /// The number, with its period before it (`II.3`) where several phases have the same; empty for nil.
    [[nodiscard]] std::string phase(model::PhaseId id) const;
    [[nodiscard]] std::string period(model::PeriodId id) const;
    [[nodiscard]] std::string group(model::GroupId id) const;
    [[nodiscard]] std::string area(model::AreaId id) const;
    [[nodiscard]] std::string find(model::FindId id) const;
    /// The period of a phase, nil when it has none or is unknown.
    [[nodiscard]] model::PeriodId period_of(model::PhaseId id) const;

    [[nodiscard]] const model::Record& record() const { return *record_; }

  private:
    const model::Record* record_;
    model::RecordIndex index_;
    std::unordered_map<model::PhaseId, std::string> phases_;
    std::unordered_map<model::PhaseId, model::PeriodId> period_of_phase_;
    std::unordered_map<model::PeriodId, std::string> periods_;
    std::unordered_map<model::GroupId, std::string> groups_;
    std::unordered_map<model::AreaId, std::string> areas_;
    std::unordered_map<model::FindId, std::string> finds_;
};

/// The relations both of whose units are in the record, by position. Filtered records have others too.
[[nodiscard]] std::vector<std::size_t> complete_relations(const RecordNames& names);

/// Gives each text a name that is used once, by a number behind it where needed.
class UniqueNames {
  public:
    [[nodiscard]] std::string take(std::string wanted);

  private:
    std::set<std::string, std::less<>> taken_;
};

/// What a format can hold; what it cannot is counted and said.
struct Carries {
    bool (*kind)(const model::StratigraphicUnit& unit) = nullptr; ///< null: no kinds at all
    bool all_areas = false;                                       ///< not only where numbers repeat
    bool status = false;
    bool title = false;
    bool description = false;
    bool interpretation = false;
    bool excavation = false; ///< days, recorder, parent
    bool details = false;
    bool mentioned = false; ///< tells units with a sheet from those only named
    bool phases = false;
    bool periods = false;
    bool chronology_years = false; ///< years and ranks of phases and periods
    bool groups = false;
    bool contact_kinds = false; ///< cuts, fills, abuts as such, not as covers
    bool later = false;         ///< order without contact as such
    bool same_as = false;
    bool bonds = false;
    bool contemporary = false;
    bool borders = false;
    bool certainty = false;
    bool statements = false; ///< who said it
    bool datings = false;
    bool levels = false;
    bool finds = false;
    bool samples = false;
    bool documents = false;
};

/// What a format of our own carries.
[[nodiscard]] Carries carries_everything();

/// The sentences for everything that the record has and the format has not.
[[nodiscard]] std::vector<std::string> losses(const model::Record& record, const Carries& carries);

/// `levels not written: 3`; nothing for none.
void add_loss(std::vector<std::string>& lost, std::size_t count, std::string_view sentence);

} // namespace planum::strat
