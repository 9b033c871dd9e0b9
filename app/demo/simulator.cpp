// SPDX-License-Identifier: MIT
#include "app/demo/simulator.hpp"

#include <numeric>
#include <utility>

namespace planum::app::demo {

DemoDig simulate(const SimulationOptions& options, Progress& progress) {
    DemoDig dig;
    dig.options = options;
    dig.site = site_shape(options.size);
    progress.step("letting a site come to be");
    dig.formation = compose_site(dig.site, options.seed);
    progress.step("looking at what touches what");
    dig.grid = std::make_shared<const ColumnGrid>(dig.site, dig.formation, progress);
    dig.contacts = find_contacts(*dig.grid, dig.formation);
    progress.step("digging it");
    dig.plan = plan_dig(dig.site, dig.formation, *dig.grid, dig.contacts, options.method, options.seed);
    dig.dug = std::make_shared<const DugGrid>(*dig.grid, dig.formation, dig.plan);
    settle_slump(dig.plan, *dig.grid, *dig.dug);
    dig.volumes = dug_volumes(*dig.grid, *dig.dug, dig.plan);
    for (SurfaceNo s = 0; s < dig.plan.surfaces; ++s) {
        progress.check();
        progress.fraction(static_cast<double>(s) / dig.plan.surfaces);
        dig.maps.push_back(map_surface(*dig.grid, *dig.dug, dig.plan, s));
    }
    forget_late_features(dig.maps, *dig.grid, dig.formation, dig.plan);
    number_units(dig.formation, dig.plan, dig.maps);
    progress.step("drawing and writing sheets");
    dig.seen = seen_contacts(dig.maps, *dig.grid);
    for (SurfaceNo s = 0; s < dig.plan.surfaces; ++s) {
        progress.check();
        auto drawn = draw_outlines(dig.maps[static_cast<std::size_t>(s)], *dig.grid, s, options.seed);
        std::move(drawn.begin(), drawn.end(), std::back_inserter(dig.regions));
    }
    dig.record = keep_record(dig.formation, dig.plan, *dig.grid, *dig.dug, dig.contacts);
    dig.mistaken = dig.record;
    dig.mistakes = make_mistakes(dig.mistaken, dig.plan, dig.seen);
    return dig;
}

std::vector<SimulatedScan> scan_surface(const DemoDig& dig, SurfaceNo surface, Progress& progress) {
    double gone = 0.0;
    for (const auto& [key, volume] : dig.volumes) gone += key.second <= surface ? volume : 0.0;
    const Scene scene = make_scene(dig.site, dig.options.seed, gone);
    const Surroundings around(dig.formation, dig.plan, *dig.grid, *dig.dug, surface, scene);
    std::vector<SimulatedScan> scans;
    for (const Station& station : stations_of(dig.plan, surface)) {
        progress.step("scanning " + station.name);
        scans.push_back({station, scan(around, dig.site, station, progress), measure_markers(around, station)});
    }
    return scans;
}

} // namespace planum::app::demo
