// SPDX-License-Identifier: MIT
#include "app/demo/simulator.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <rapidcheck.h>

#include "app/demo/simulator_random.hpp"
#include "core/model/relation.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using namespace planum::app::demo;

namespace {

DemoDig some_dig() {
    SimulationOptions options;
    options.size = DemoSize::Tiny;
    options.seed = *rc::gen::inRange<std::uint64_t>(0, 1000);
    options.method =
        *rc::gen::element(model::DigMethod::Stratigraphic, model::DigMethod::Planum, model::DigMethod::Mixed);
    return simulate(options, Progress::none());
}

// The sheets are true in time, and so free of cycles.
void relations_are_true(const DemoDig& dig) {
    std::map<std::string, UnitNo> formed; // units are in the order of formation
    for (std::size_t u = 0; u < dig.formation.units().size(); ++u)
        formed[dig.formation.units()[u].number] = static_cast<UnitNo>(u);
    RC_ASSERT(formed.size() == dig.formation.units().size());
    for (const RecordedRelation& r : dig.record.relations) {
        const auto kind = model::relation_from_any_word(r.relation);
        RC_ASSERT(kind.has_value());
        if (model::time_meaning(kind->kind) != model::TimeMeaning::SubjectLater) continue;
        const UnitNo later = formed.at(kind->inverse ? r.other : r.unit);
        const UnitNo earlier = formed.at(kind->inverse ? r.unit : r.other);
        RC_ASSERT(later > earlier);
    }
}

// Throwing points at the ground comes to the same volumes.
void volumes_add_up(const DemoDig& dig) {
    const Bounds& t = dig.site.trench;
    constexpr int kPoints = 40000;
    const double box = (t.high.x - t.low.x) * (t.high.y - t.low.y) * (t.high.z + 0.2 - t.low.z);
    Draw draw(dig.options.seed, 77);
    std::map<SurfaceNo, double> thrown;
    for (int i = 0; i < kPoints; ++i) {
        const Vec3 p{draw.between(t.low.x, t.high.x), draw.between(t.low.y, t.high.y),
                     draw.between(t.low.z, t.high.z + 0.2)};
        const Body body = dig.formation.body_at(p);
        if (body.unit == kAir) continue;
        const SurfaceNo gone = dig.plan.gone_on(dig.formation, body.unit, p);
        if (gone < dig.plan.surfaces) thrown[gone] += box / kPoints;
    }
    std::map<SurfaceNo, double> counted;
    for (const auto& [key, volume] : dig.volumes) counted[key.second] += volume;
    for (SurfaceNo s = 0; s < dig.plan.surfaces; ++s) {
        // Five standard deviations of a binomial share, and twenty litres for the columns.
        const double share = counted[s] / box;
        const double sigma = box * std::sqrt(share * (1.0 - share) / kPoints);
        RC_ASSERT(std::abs(thrown[s] - counted[s]) < 5.0 * sigma + 0.02);
    }
}

void ground_only_goes_down(const DemoDig& dig) {
    for (std::size_t s = 1; s < dig.maps.size(); ++s) {
        for (std::size_t i = 0; i < dig.grid->size(); ++i) {
            const SurfaceCell& cell = dig.maps[s][i];
            if (cell.shown == SurfaceCell::Shown::Slump || dig.maps[s - 1][i].shown == SurfaceCell::Shown::Slump)
                continue;
            RC_ASSERT(cell.z <= dig.maps[s - 1][i].z + 0.001F);
        }
    }
}

// On stratigraphic surfaces what lay bare first is later.
void first_bare_is_later(const DemoDig& dig) {
    if (dig.options.method != model::DigMethod::Stratigraphic) return;
    for (const auto& [pair, contact] : dig.seen) {
        // The roof of an undercut pit lies over the emptied cut, and is older.
        const bool hollow = dig.formation.units()[static_cast<std::size_t>(pair.second)].kind == model::UnitKind::Cut;
        if (contact.area > 0.0 && !hollow) RC_ASSERT(pair.first > pair.second);
    }
}

} // namespace

TEST_CASE("Digs of any seed and method: sheets are true, volumes add up, ground only goes down") {
    // One dig for all laws: making it takes longer than looking at it.
    CHECK(rc::check("laws of a dig", [] {
        const DemoDig dig = some_dig();
        relations_are_true(dig);
        volumes_add_up(dig);
        ground_only_goes_down(dig);
        first_bare_is_later(dig);
    }));
}

TEST_CASE("No wall hangs in the air: what it stands on goes with it at the earliest") {
    for (const model::DigMethod method : {model::DigMethod::Planum, model::DigMethod::Mixed}) { // by levels
        SimulationOptions options;
        options.size = DemoSize::Small;
        options.seed = 1;
        options.method = method;
        const DemoDig dig = simulate(options, Progress::none());
        std::size_t over_earth = 0;
        std::size_t hanging = 0;
        for (std::size_t i = 0; i < dig.grid->size(); ++i) {
            const double x = dig.grid->x_of(i % dig.grid->columns());
            const double y = dig.grid->y_of(i / dig.grid->columns());
            SurfaceNo wall_gone = 0;
            for (const Run& run : dig.grid->at(i)) { // from the top down
                const Vec3 middle{x, y, 0.5 * static_cast<double>(run.low + run.high)};
                const SurfaceNo gone = dig.plan.gone_on(dig.formation, run.unit, middle);
                const auto kind = dig.formation.units()[static_cast<std::size_t>(run.unit)].kind;
                if (wall_gone > 0 && kind != model::UnitKind::Structure) {
                    ++over_earth;
                    hanging += gone < std::min(wall_gone, dig.plan.surfaces) ? 1U : 0U;
                }
                if (kind == model::UnitKind::Structure) wall_gone = std::max(wall_gone, gone);
            }
        }
        CHECK(over_earth > 100);
        CHECK(hanging * 1000 < over_earth); // edges of stones thinner than 1 cm are not looked for
    }
}
