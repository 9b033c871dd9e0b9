// SPDX-License-Identifier: MIT
#include "strat/checks/check.hpp"

#include <array>

#include "strat/checks/check_context.hpp"
#include "strat/checks/families.hpp"
#include "strat/checks/finish.hpp"

namespace planum::strat {

namespace {

using model::Severity;

// The table of checks: what is said by whom. A new check adds its codes below and its function here.
struct Family {
    std::string_view step;
    void (*run)(const CheckContext&, Findings&);
};

constexpr std::array kFamilies = {
    Family{"looking for circles", check_cycles},
    Family{"comparing relations", check_pairs},
    Family{"comparing levels", check_levels},
    Family{"comparing surfaces", check_surfaces},
    Family{"comparing dates", check_dates},
    Family{"comparing phases", check_phases},
    Family{"following the digging", check_digging},
    Family{"looking at kinds", check_kinds},
    Family{"looking at numbers", check_numbers},
    Family{"looking at sources", check_sources},
    Family{"looking at scans", check_scans},
    Family{"looking at outlines", check_regions},
    Family{"looking at the order of surfaces", check_surface_order},
    Family{"looking at ground that changed", check_ground},
    Family{"counting redundant relations", check_redundancy},
};

constexpr std::array kCodes = {
    CheckCode{"cycle", Severity::Error, "units lie above one another in a circle"},
    CheckCode{"cycle-by-same-as", Severity::Error, "a circle, or a unit above itself, that only same-as makes"},
    CheckCode{"self-relation", Severity::Error, "a unit above itself"},
    CheckCode{"contradicting-pair", Severity::Error, "two units each above the other"},
    CheckCode{"contemporary-ordered", Severity::Error,
              "bonded (error) or contemporary (warning) units that a path puts one after the other"},
    CheckCode{"height-contradiction", Severity::Error,
              "the recorded surfaces show the opposite (error where both faces are the units' own, else warning)"},
    CheckCode{"level-contradiction", Severity::Warning, "measured heights exclude a unit or a relation"},
    CheckCode{"date-contradiction", Severity::Error, "later than something that is younger by its dates"},
    CheckCode{"phase-contradiction", Severity::Error, "later than something of a later phase"},
    CheckCode{"dug-too-early", Severity::Warning, "dug out before a unit recorded above it"},
    CheckCode{"find-outside-unit", Severity::Warning, "a find above or below its unit, or in a cut"},
    CheckCode{"kind-mismatch", Severity::Warning, "a relation that units of these kinds cannot have"},
    CheckCode{"fill-without-cut", Severity::Warning, "a fill that fills nothing"},
    CheckCode{"cut-without-fill", Severity::Warning, "a cut that nothing fills"},
    CheckCode{"cut-cuts-nothing", Severity::Warning, "a cut that cuts nothing"},
    CheckCode{"natural-not-lowest", Severity::Warning, "natural ground above something that is not"},
    CheckCode{"number-reused", Severity::Warning, "one number in two areas, though unique on the site"},
    CheckCode{"number-outside-block", Severity::Warning, "a number outside the block of its area"},
    CheckCode{"duplicate-relation", Severity::Warning, "a contact stated twice on one sheet, or as two kinds"},
    CheckCode{"missing-reciprocal", Severity::Warning,
              "relations on one sheet only, in a source that states most on both; one line a source"},
    CheckCode{"dangling-unit", Severity::Warning, "a unit that is named but has no sheet"},
    CheckCode{"unparsed", Severity::Warning, "a line of a source that was not understood"},
    CheckCode{"region-overlap", Severity::Warning, "two outlines that claim the same ground"},
    CheckCode{"region-astray", Severity::Warning, "an outline more than 100 m away from all scans"},
    CheckCode{"surface-order", Severity::Warning, "a surface that stands in the order before one of an earlier day"},
    CheckCode{"isolated-unit", Severity::Info, "a unit in no order"},
    CheckCode{"unit-without-region", Severity::Info, "a unit that is outlined nowhere"},
    CheckCode{"region-without-unit", Severity::Info, "an outline of a unit that has no number, or one that is no unit"},
    CheckCode{"scan-unregistered", Severity::Info, "a scan without a place on the site grid"},
    CheckCode{"scan-poorly-registered", Severity::Info, "a scan whose place is not sure to 10 mm and 0.1 degrees"},
    CheckCode{"surface-changed-within", Severity::Info, "scans of one surface that disagree about the ground"},
    CheckCode{"surface-rose", Severity::Info, "ground that lies higher than on the surface before"},
    CheckCode{"redundant-relation", Severity::Info, "a relation that follows from others"},
};

} // namespace

CheckResult check(const model::Record& record, const HarrisMatrix& merged, const CheckOptions& options,
                  std::span<const model::SurfaceEvidence> surfaces, Progress& progress,
                  std::span<const model::GroundAlteration> alterations,
                  std::span<const model::OutlineOverlap> overlaps) {
    CheckContext context(record, merged, options, surfaces, progress);
    context.alterations = alterations;
    context.overlaps = overlaps;
    CheckResult result;
    for (const Family& family : kFamilies) {
        progress.check();
        progress.step(family.step);
        family.run(context, result.diagnostics);
    }
    finish(context, result.diagnostics);
    result.coverage = measure_coverage(context, result.verdicts);
    return result;
}

std::span<const CheckCode> all_check_codes() noexcept { return kCodes; }

} // namespace planum::strat
