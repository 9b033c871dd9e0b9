// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/demo/dig_surfaces.hpp"
#include "core/model/chronology.hpp"
#include "core/model/measured.hpp"

namespace planum::app::demo {

/// One sheet.
struct RecordedUnit {
    std::string number;
    model::UnitKind kind = model::UnitKind::Deposit;
    model::UnitForm form = model::UnitForm::None;
    model::UnitStatus status = model::UnitStatus::Excavated;
    std::string title;
    std::string excavated_from;
    std::string excavated_on;
    std::string recorded_by;
    std::string phase;
    std::string group;
};

/// One box ticked on one sheet: `unit` says it of `other`.
struct RecordedRelation {
    std::string unit;
    std::string relation; ///< `covers`, `covered by`, …
    std::string other;
    bool uncertain = false;
    std::string person;
    UnitNo later = kAir; ///< the contact it is true of
    UnitNo earlier = kAir;
};

struct RecordedLevel {
    std::string unit;
    Vec3 at;
    model::LevelRole role = model::LevelRole::Top;
    std::string label;
};

struct RecordedFind {
    std::string number;
    std::string unit;
    Vec3 at;
    std::string type;
    std::string material;
    int count = 1;
    double weight = 0.0; ///< [g]
    std::string found_on;
};

struct RecordedDating {
    std::string label;
    std::string unit;
    std::string find;
    model::DatingKind kind = model::DatingKind::Coin;
    std::optional<int> from;
    std::optional<int> to;
};

struct RecordedPhase {
    std::string number;
    std::string title;
    std::string period;
    int from = 0;
    int to = 0;
};

struct RecordedGroup {
    std::string number;
    std::string type;
    std::string title;
};

/// All the dig's paper.
struct DigRecord {
    std::vector<RecordedUnit> units;
    std::vector<RecordedRelation> relations;
    std::vector<RecordedLevel> levels;
    std::vector<RecordedFind> finds;
    std::vector<RecordedDating> datings;
    std::vector<RecordedPhase> phases;
    std::vector<RecordedPhase> periods; ///< `period` empty
    std::vector<RecordedGroup> groups;
};

/// Numbers the units in the order in which a digger meets them.
void number_units(Formation& formation, const DigPlan& plan, const std::vector<SurfaceMap>& maps);

/// Writes the sheets as diggers do: what touched what, mostly from both sides, a few contacts overlooked,
/// highest and lowest points measured, finds where they lay.
[[nodiscard]] DigRecord keep_record(const Formation& formation, const DigPlan& plan, const ColumnGrid& grid,
                                    const DugGrid& dug, const std::vector<Contact>& contacts);

/// One mistake that was put into the copy of the record.
struct Mistake {
    std::string kind;  ///< reversed-relation, mistyped-number, transposed-number, swapped-heights, number-used-twice,
                       ///< find-in-wrong-unit
    std::string table; ///< file it is in
    std::string unit;  ///< the unit or find it is about
    std::string was;
    std::string is;
    bool visible = false; ///< surfaces show that it is wrong
};

/// Spoils a copy of the record; says where.
[[nodiscard]] std::vector<Mistake> make_mistakes(DigRecord& record, const DigPlan& plan, const SeenContacts& seen);

} // namespace planum::app::demo
