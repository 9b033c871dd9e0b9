// SPDX-License-Identifier: MIT
#include "core/model/zero_heights.hpp"

#include <algorithm>
#include <unordered_map>

namespace planum::model {

namespace {

constexpr double kSpare = 0.5;        // [m]
constexpr double kBelowScanner = 3.0; // [m]: the ground that it looks at

struct Heights {
    double low = 1e300;
    double high = -1e300;

    void add(double z) {
        low = std::min(low, z);
        high = std::max(high, z);
    }

    [[nodiscard]] bool empty() const { return low > high; }

    [[nodiscard]] bool hold_zero() const { return low <= kSpare && high >= -kSpare; }
};

template<class Visit>
void for_heights(const Region& region, Visit visit) {
    for (const Polygon& polygon : region.outline) {
        for (const auto& p : polygon.outer) visit(p[2]);
        for (const Ring& hole : polygon.holes) {
            for (const auto& p : hole) visit(p[2]);
        }
    }
}

bool is_zero(const Region& region) {
    bool zero = true;
    for_heights(region, [&](double z) { zero = zero && z == 0.0; });
    return zero;
}

} // namespace

void forget_zero_heights(Record& record) {
    std::vector<Region*> doubtful;
    std::unordered_map<SurfaceId, Heights> of_surface;
    Heights of_all;
    for (Region& region : record.regions) {
        if (!region.has_heights || region.surface.is_nil() || region.outline.empty()) continue;
        if (is_zero(region)) {
            doubtful.push_back(&region);
            continue;
        }
        Heights& here = of_surface[region.surface];
        for_heights(region, [&](double z) {
            here.add(z);
            of_all.add(z);
        });
    }
    if (doubtful.empty()) return;
    for (const Level& level : record.levels) of_all.add(level.z);
    for (const Scan& scan : record.scans) {
        const ScanPose* pose = pose_in_force(record, scan.id);
        if (pose == nullptr) continue;
        const double z = pose->site_from_scan[11];
        of_all.add(z);
        of_all.add(z - kBelowScanner);
    }
    for (Region* region : doubtful) {
        const auto here = of_surface.find(region->surface);
        const Heights& there = here == of_surface.end() ? of_all : here->second;
        region->has_heights = !there.empty() && there.hold_zero();
    }
}

} // namespace planum::model
