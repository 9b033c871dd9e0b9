// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <fmt/format.h>

#include "strat/checks/families.hpp"
#include "strat/checks/finish.hpp"

namespace planum::strat {

namespace {

using Kind = model::GroundAlteration::Kind;

// `1042 and 1017`; what lies in no unit's outline is ground.
std::string whose(const CheckContext& context, const model::GroundAlteration& altered) {
    std::vector<std::string> names;
    for (const model::UnitId id : altered.units) {
        if (const UnitIndex u = context.index.find(id); u != model::kNoUnit) names.push_back(context.name(u));
    }
    return names.empty() ? "ground without a unit" : list_names(names, 5);
}

std::string place(const model::GroundAlteration& altered) {
    return fmt::format("near {:.2f} {:.2f} at {:.2f} to {:.2f} m", altered.x, altered.y, altered.low, altered.high);
}

std::string sentence(const CheckContext& context, const model::GroundAlteration& altered) {
    if (altered.kind == Kind::ChangedWithin) {
        return fmt::format("on {} scans disagree over {:.2f} m² of {} {}: {} shows it {:.2f} m higher than {}; it "
                           "changed between the two, or one of them is misplaced",
                           altered.surface, altered.area, whose(context, altered), place(altered), altered.higher_scan,
                           altered.change, altered.lower_scan);
    }
    return fmt::format("on {} {:.2f} m² of {} {} lay {:.2f} m higher than on {}: heaped up, filled in, or a scan is "
                       "misplaced; nothing is concluded there until it is below its former height",
                       altered.surface, altered.area, whose(context, altered), place(altered), altered.change,
                       altered.since);
}

} // namespace

void check_ground(const CheckContext& context, Findings& findings) {
    if (!context.options.with_infos) return;
    for (const model::GroundAlteration& altered : context.alterations) {
        const bool within = altered.kind == Kind::ChangedWithin;
        auto d = make_diagnostic(model::Severity::Info, within ? "surface-changed-within" : "surface-rose",
                                 sentence(context, altered));
        for (const model::UnitId id : altered.units) {
            if (context.index.find(id) != model::kNoUnit) d.units.push_back(id);
        }
        d.evidence["surface"] = altered.surface;
        if (within) {
            d.evidence["higher_scan"] = altered.higher_scan;
            d.evidence["lower_scan"] = altered.lower_scan;
        } else {
            d.evidence["since"] = altered.since;
        }
        d.evidence["area_m2"] = altered.area;
        d.evidence["change_m"] = altered.change;
        d.evidence["tolerance_m"] = altered.detectable;
        d.evidence["x"] = altered.x;
        d.evidence["y"] = altered.y;
        d.evidence["z_min"] = altered.low;
        d.evidence["z_max"] = altered.high;
        findings.push_back(std::move(d));
    }
}

} // namespace planum::strat
