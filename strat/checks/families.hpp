// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/model/diagnostic.hpp"
#include "strat/checks/check_context.hpp"

// The families of checks, one source file each. A new check goes into the file of its family, gets a line
// in the table of check.cpp and a section in docs/checks.md.

namespace planum::strat {

void check_cycles(const CheckContext& context, Findings& findings);
void check_pairs(const CheckContext& context, Findings& findings);
void check_levels(const CheckContext& context, Findings& findings);
void check_surfaces(const CheckContext& context, Findings& findings);
void check_dates(const CheckContext& context, Findings& findings);
void check_phases(const CheckContext& context, Findings& findings);
void check_digging(const CheckContext& context, Findings& findings);
void check_kinds(const CheckContext& context, Findings& findings);
void check_numbers(const CheckContext& context, Findings& findings);
void check_sources(const CheckContext& context, Findings& findings);
void check_scans(const CheckContext& context, Findings& findings);
void check_regions(const CheckContext& context, Findings& findings);
void check_ground(const CheckContext& context, Findings& findings);
void check_surface_order(const CheckContext& context, Findings& findings);
void check_redundancy(const CheckContext& context, Findings& findings);

/// How many of the relations that state an order could be judged by heights or surfaces; `verdicts` gets what is said
/// about each, by position in the record.
[[nodiscard]] model::Coverage measure_coverage(const CheckContext& context,
                                               std::vector<model::EvidenceVerdict>& verdicts);

/// What the levels of its two units say about a relation.
enum class LevelVerdict { Confirmed, Contradicted, Untestable };

struct LevelJudgement {
    LevelVerdict verdict = LevelVerdict::Untestable;
    std::string_view why;      ///< reason when untestable
    double upper = 0.0;        ///< [m] the two heights compared: that of the subject …
    double lower = 0.0;        ///< … and that of the object
    std::string_view upper_is; ///< "highest level on top", …
    std::string_view lower_is;
    bool near = false; ///< both points lie within CheckOptions::near
};

[[nodiscard]] LevelJudgement judge_by_levels(const CheckContext& context, RelationIndex relation);

/// Bounds of a unit's formation from its datings, with what they rest on.
struct DateBounds {
    std::optional<model::Year> from; ///< not earlier than
    std::optional<model::Year> to;   ///< not later than
    std::uint32_t from_dating = 0;   ///< position in record.datings
    std::uint32_t to_dating = 0;
};

[[nodiscard]] std::vector<DateBounds> date_bounds(const CheckContext& context);

/// How the phases (or periods) of two units stand in time; Unknown when neither ranks nor years tell.
enum class PhaseOrder { Earlier, Later, Same, Unknown };

struct PhaseComparison {
    PhaseOrder order = PhaseOrder::Unknown; ///< of the first unit's phase to the second's
    bool by_years = false;
    std::string first; ///< "phase 2 (1200 CE to 1300 CE)"
    std::string second;
};

/// Compares phases by position; keeps a reference to the record.
class PhaseComparer {
  public:
    explicit PhaseComparer(const model::Record& record);
    [[nodiscard]] PhaseComparison compare(UnitIndex a, UnitIndex b) const;

    [[nodiscard]] bool has_any() const noexcept { return any_; }

  private:
    struct Span;
    [[nodiscard]] Span span_of(UnitIndex u) const;
    const model::Record* record_;
    std::unordered_map<model::PhaseId, std::uint32_t> phases_;
    std::unordered_map<model::PeriodId, std::uint32_t> periods_;
    bool any_ = false;
};

/// Whether the digging dates say that `earlier` was dug out before `later` was begun; both known.
[[nodiscard]] bool dug_before(const model::StratigraphicUnit& earlier, const model::StratigraphicUnit& later);

/// Whether a relation's kind does not fit the kinds of its units (a deposit that cuts).
[[nodiscard]] bool kinds_mismatch(const CheckContext& context, RelationIndex relation, model::Strictness strictness);

} // namespace planum::strat
