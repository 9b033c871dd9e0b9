// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "app/demo/dig_surfaces.hpp"
#include "app/demo/simulator_random.hpp"
#include "core/model/place.hpp"
#include "scans/surface/questions.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/evidence_tally.hpp"

// Digs of which not all was recorded as it should have been. What nobody could see counts neither way: the truth that
// is looked for is worked out again from what is left.

using namespace planum;
using namespace planum::test;
using app::demo::DemoDig;
using app::demo::SurfaceCell;
using app::demo::SurfaceMap;

namespace {

constexpr std::array kMethods = {model::DigMethod::Stratigraphic, model::DigMethod::Planum, model::DigMethod::Mixed};

struct Spoilt {
    double without_outline = 0.0; ///< share of the regions that nobody drew
    bool day_unscanned = false;   ///< one in the middle
    GroundNoise noise = {};
};

/// Forgets the outlines of some units on some surfaces, and leaves nothing to be seen on a day without scans.
void spoil(DemoDig& dig, const Spoilt& by) {
    std::vector<SurfaceMap> left = dig.maps;
    app::demo::Draw draw(dig.options.seed, 92000);
    std::vector<app::demo::DrawnRegion> drawn;
    for (const app::demo::DrawnRegion& region : dig.regions) {
        const bool is_missing = region.unit != app::demo::kAir && draw.between(0.0, 1.0) < by.without_outline;
        if (!is_missing) {
            drawn.push_back(region);
            continue;
        }
        // All of the unit on this surface: a second piece of it may still be drawn, so less may be left than is.
        for (SurfaceCell& cell : left[static_cast<std::size_t>(region.surface)]) {
            if (cell.unit == region.unit) cell.shown = SurfaceCell::Shown::Nothing;
        }
    }
    dig.regions = std::move(drawn);
    if (by.day_unscanned) {
        const auto day = static_cast<std::size_t>(dig.plan.surfaces / 2);
        for (std::vector<SurfaceMap>* maps : {&left, &dig.maps}) {
            for (SurfaceCell& cell : (*maps)[day]) cell.shown = SurfaceCell::Shown::Nothing;
        }
    }
    dig.seen = app::demo::seen_contacts(left, *dig.grid);
}

void check_digs(const std::string& name, const Spoilt& by) {
    for (const model::DigMethod method : kMethods) {
        EvidenceTally all;
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            DemoDig dig = demo_dig(seed, method);
            spoil(dig, by);
            auto conclusions = scans::conclude(history_of(dig, by.noise), known_units(dig));
            scans::keep_useful_questions(conclusions, known_units(dig).size());
            all += tally_of(dig, conclusions, std::getenv("PLANUM_LOUD") != nullptr);
        }
        INFO(name << ", " << model::to_word(method));
        all.print(name + ", " + std::string(model::to_word(method)));
        CHECK(all.inverted == 0);
        CHECK(all.contact_share() >= 0.95);
        CHECK(all.recall() >= 0.7);
    }
}

} // namespace

TEST_CASE("Where a tenth of the outlines is missing nothing is inverted, and most of the rest is found") {
    check_digs("without outline", {.without_outline = 0.1});
}

TEST_CASE("Where a day was not scanned nothing is inverted, and most of the rest is found") {
    check_digs("a day unscanned", {.day_unscanned = true});
}

TEST_CASE("Where a scan stands 5 cm off and says so nothing is inverted, and most is still found") {
    Spoilt by;
    by.noise.misplaced_by = 0.05;
    check_digs("misplaced", by);
}

TEST_CASE("Where outlines and a day are missing and outlines are 3 cm off, nothing is inverted") {
    Spoilt by{.without_outline = 0.1, .day_unscanned = true};
    by.noise.outline_shift = 0.03;
    check_digs("all at once", by);
}
