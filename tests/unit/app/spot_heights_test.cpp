// SPDX-License-Identifier: MIT
#include "app/surfaces/spot_heights.hpp"

#include <utility>

#include "core/base/uuid.hpp"
#include "tests/support/catch.hpp"

using namespace planum;

namespace {

model::Region outline_of(const model::StratigraphicUnit& unit, const model::Surface& surface,
                         model::RegionShows shows) {
    model::Region region;
    region.unit = unit.id;
    region.surface = surface.id;
    region.shows = shows;
    region.outline = {{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {}}};
    return region;
}

} // namespace

TEST_CASE("Of all levels those of cuts that stand empty on the surface say how deep hollows are") {
    model::Record record;
    SeededUuids ids{1};
    model::Surface before;
    before.id = model::SurfaceId{ids.next()};
    model::Surface after;
    after.id = model::SurfaceId{ids.next()};
    model::StratigraphicUnit cut;
    cut.id = model::UnitId{ids.next()};
    model::StratigraphicUnit fill;
    fill.id = model::UnitId{ids.next()};
    record.regions = {outline_of(fill, before, model::RegionShows::Top),
                      outline_of(cut, after, model::RegionShows::Cut)};
    const auto level = [&](const model::StratigraphicUnit& unit, double x, double z) {
        model::Level l;
        l.unit = unit.id;
        l.x = x;
        l.y = 0.5;
        l.z = z;
        l.role = model::LevelRole::Base;
        record.levels.push_back(l);
    };
    level(fill, 0.5, 9.0);
    level(cut, 0.4, 8.0);
    level(cut, 0.6, 8.5);
    level(cut, 0.7, 8.6);
    record.levels.back().x.reset(); // on an old sheet without a place
    level(cut, 0.1, 9.2);
    record.levels.back().role = model::LevelRole::Top; // the rim
    CHECK(app::spot_heights(record, before).empty());
    const auto spots = app::spot_heights(record, after);
    REQUIRE(spots.size() == 2);
    CHECK(spots[0].x == 0.4);
    CHECK(spots[0].z == 8.0);
    CHECK(spots[1].z == 8.5);
    CHECK(spots[1].hollow.size() == 1);
}

TEST_CASE("A part of a cut in which nothing was measured is as deep as the nearest depth of that cut says") {
    model::Record record;
    SeededUuids ids{2};
    model::Surface surface;
    surface.id = model::SurfaceId{ids.next()};
    model::StratigraphicUnit cut;
    cut.id = model::UnitId{ids.next()};
    model::Region region = outline_of(cut, surface, model::RegionShows::Cut);
    region.outline.push_back({{{1.5, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1.5, 1, 0}}, {}}); // beyond a baulk
    region.outline.push_back({{{6, 0, 0}, {7, 0, 0}, {7, 1, 0}, {6, 1, 0}}, {}});     // a ditch may slope so far
    region.outline.push_back({{{4, 0, 0}}, {}});                                      // what a damaged file may hold
    region.outline.push_back({{}, {}});
    record.regions = {region};
    model::Level level;
    level.unit = cut.id;
    level.x = 0.5;
    level.y = 0.5;
    level.z = 8.0;
    level.role = model::LevelRole::Base;
    record.levels = {level};
    const auto spots = app::spot_heights(record, surface);
    REQUIRE(spots.size() == 2);
    CHECK(spots[0].x == 0.5);
    CHECK(spots[1].z == 8.0);
    CHECK(spots[1].x > 1.5);
    CHECK(spots[1].x < 2.0);
    CHECK(spots[1].sigma > spots[0].sigma);
    CHECK(spots[1].hollow != spots[0].hollow);
}

TEST_CASE("What is left of a fill lies in its pit as high as its top was measured, layers lie open") {
    model::Record record;
    SeededUuids ids{3};
    model::Surface surface;
    surface.id = model::SurfaceId{ids.next()};
    model::StratigraphicUnit unit;
    unit.id = model::UnitId{ids.next()};
    unit.kind = model::UnitKind::Deposit;
    unit.form = model::UnitForm::Fill;
    record.units = {unit};
    record.regions = {outline_of(unit, surface, model::RegionShows::Top)};
    for (const auto& [role, z] : {std::pair{model::LevelRole::Top, 8.4}, std::pair{model::LevelRole::Base, 8.0}}) {
        model::Level level;
        level.unit = unit.id;
        level.x = 0.5;
        level.y = 0.5;
        level.z = z;
        level.role = role;
        record.levels.push_back(level);
    }
    const auto spots = app::spot_heights(record, surface);
    REQUIRE(spots.size() == 1);
    CHECK(spots[0].z == 8.4);
    record.units.front().form = model::UnitForm::Layer;
    CHECK(app::spot_heights(record, surface).empty());
}

TEST_CASE("The bottom of a pit says nothing of its edge while a fill lies over it, but does under a roof") {
    model::Record record;
    SeededUuids ids{4};
    model::Surface surface;
    surface.id = model::SurfaceId{ids.next()};
    model::StratigraphicUnit cut;
    cut.id = model::UnitId{ids.next()};
    model::StratigraphicUnit over;
    over.id = model::UnitId{ids.next()};
    over.kind = model::UnitKind::Deposit;
    model::Region covered = outline_of(over, surface, model::RegionShows::Top);
    covered.outline = {{{{1.2, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1.2, 1, 0}}, {}}};
    record.regions = {outline_of(cut, surface, model::RegionShows::Cut), covered};
    model::Level level;
    level.unit = cut.id;
    level.x = 1.5;
    level.y = 0.5;
    level.z = 8.0;
    level.role = model::LevelRole::Base;
    record.levels = {level};
    over.form = model::UnitForm::Fill;
    record.units = {cut, over};
    CHECK(app::spot_heights(record, surface).empty());
    record.units.back().form = model::UnitForm::Layer;
    const auto spots = app::spot_heights(record, surface);
    REQUIRE(spots.size() == 1);
    CHECK(spots[0].z == 8.0);
}
