// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/progress.hpp"
#include "core/model/diagnostic.hpp"
#include "core/model/evidence.hpp"
#include "core/model/record.hpp"
#include "strat/checks/check.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::strat {

/// How often a relation was stated, by the sheet it stands on.
struct StatedSides {
    std::uint16_t subject = 0;
    std::uint16_t object = 0;
    std::uint16_t neither = 0;

    [[nodiscard]] bool both() const noexcept { return subject > 0 && object > 0; }

    [[nodiscard]] bool only_subject() const noexcept { return subject > 0 && object == 0; }

    [[nodiscard]] bool only_object() const noexcept { return object > 0 && subject == 0; }
};

/// What the levels of one unit span [m]. Cut levels count as base.
struct Heights {
    std::optional<double> highest_top;
    std::optional<double> lowest_top;
    std::optional<double> highest_base;
    std::optional<double> lowest_base;
    bool contradictory = false; ///< base above top, so that nothing can be concluded from them

    [[nodiscard]] bool any() const noexcept { return highest_top || highest_base; }
};

/// What every check looks at: the record by position instead of by id. Invariant: vectors have one entry
/// a relation or a unit; subject[r] or object[r] is kNoUnit where the record lacks the unit.
struct CheckContext {
    CheckContext(const model::Record& r, const HarrisMatrix& m, const CheckOptions& o,
                 std::span<const model::SurfaceEvidence> s, Progress& p);

    const model::Record& record;
    const HarrisMatrix& matrix;
    const CheckOptions& options;
    std::span<const model::SurfaceEvidence> surfaces;
    std::span<const model::GroundAlteration> alterations; ///< set by check(); none elsewhere
    std::span<const model::OutlineOverlap> overlaps;      ///< the same
    Progress& progress;
    model::RecordIndex index;

    std::unordered_map<model::AreaId, std::string_view> area_names;
    std::vector<UnitIndex> subject;
    std::vector<UnitIndex> object;
    std::vector<StatedSides> stated;
    std::vector<std::uint32_t> statement_begin; ///< of each relation in record.statements, one past at the end
    std::vector<std::uint32_t> level_begin;     ///< of each unit in levels_by_unit, one past at the end
    std::vector<std::uint32_t> levels_by_unit;  ///< positions in record.levels
    std::vector<Heights> heights;
    std::vector<std::uint32_t> relation_begin;    ///< of each unit in relations_by_unit, one past at the end
    std::vector<RelationIndex> relations_by_unit; ///< as subject or object; a self relation once

    [[nodiscard]] const model::StratigraphicUnit& unit(UnitIndex u) const { return record.units[u]; }

    [[nodiscard]] bool is_void(UnitIndex u) const noexcept;
    [[nodiscard]] bool is_mentioned(UnitIndex u) const noexcept;

    [[nodiscard]] bool known(RelationIndex r) const noexcept {
        return subject[r] != model::kNoUnit && object[r] != model::kNoUnit;
    }

    /// Both units are known and the kind puts the subject later.
    [[nodiscard]] bool states_order(RelationIndex r) const noexcept;
    [[nodiscard]] std::span<const RelationIndex> relations_of(UnitIndex u) const noexcept;
    [[nodiscard]] std::span<const std::uint32_t> levels_of(UnitIndex u) const noexcept;

    [[nodiscard]] std::string name(UnitIndex u) const { return index.name(u); }

    /// `AREA::NUMBER` wherever the unit has an area: what ids are made of.
    [[nodiscard]] std::string full_name(UnitIndex u) const;
    /// `1042 covers 1017`
    [[nodiscard]] std::string sentence(RelationIndex r) const;
    [[nodiscard]] model::NamedRelation named(RelationIndex r) const;
    /// Some relation that states later over earlier; kNoRelation when none does.
    [[nodiscard]] RelationIndex relation_between(UnitIndex later, UnitIndex earlier) const;
};

inline constexpr RelationIndex kNoRelation = static_cast<RelationIndex>(-1);

using Findings = std::vector<model::Diagnostic>;

[[nodiscard]] model::Diagnostic make_diagnostic(model::Severity severity, std::string_view code, std::string message);

/// `12.31 m`
[[nodiscard]] std::string metres(double value);
/// `2000 BCE`, `1250 CE`
[[nodiscard]] std::string year_text(model::Year year);
/// `1, 2 and 3`; beyond `limit` names: `1, 2, 3 and 17 more`.
[[nodiscard]] std::string list_names(const std::vector<std::string>& names, std::size_t limit);

/// Where a chain of orders begins and ends, if it matters which of the units that same_as makes one is meant.
struct PathEnds {
    UnitIndex later = model::kNoUnit;
    UnitIndex earlier = model::kNoUnit;
};

/// A chain of orders as a sentence: `1 covers 2, 2 is the same as 3, 3 cuts 4`. `orders` are positions in
/// matrix.orders(). With `ends` the same_as between them and the chain is named too.
[[nodiscard]] std::string path_text(const CheckContext& context, std::span<const std::uint32_t> orders,
                                    std::size_t limit, PathEnds ends = {});
/// The relations a chain of orders rests on, one an order (the first of each).
[[nodiscard]] std::vector<model::NamedRelation> path_relations(const CheckContext& context,
                                                               std::span<const std::uint32_t> orders);

} // namespace planum::strat
