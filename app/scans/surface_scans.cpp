// SPDX-License-Identifier: MIT
#include "app/scans/surface_scans.hpp"

#include <algorithm>

#include "app/scans/days_surface.hpp"

namespace planum::app {

bool may_show(const model::Record& record, const model::Scan& scan, const model::Surface& surface) {
    if (scan.surface == surface.id) return true;
    if (!holds_day(surface, scan.day)) return false;
    for (const model::Surface& other : record.surfaces) {
        if (other.id == scan.surface) return other.area != surface.area;
    }
    return true;
}

std::vector<const model::Scan*> scans_of(const model::Record& record, const model::Surface& surface) {
    std::vector<const model::Scan*> own;
    std::vector<const model::Scan*> shared;
    for (const model::Scan& scan : record.scans) {
        if (scan.surface == surface.id) {
            own.push_back(&scan);
        } else if (may_show(record, scan, surface)) {
            shared.push_back(&scan);
        }
    }
    return own.empty() ? shared : own;
}

std::vector<const model::Scan*> scans_of(const model::Record& record, model::SurfaceId surface) {
    const auto found = std::find_if(record.surfaces.begin(), record.surfaces.end(),
                                    [&](const model::Surface& one) { return one.id == surface; });
    return found == record.surfaces.end() ? std::vector<const model::Scan*>{} : scans_of(record, *found);
}

bool is_seen(const model::Record& record, const model::Surface& surface) {
    const std::vector<const model::Scan*> scans = scans_of(record, surface);
    return std::any_of(scans.begin(), scans.end(),
                       [&](const model::Scan* scan) { return model::pose_in_force(record, scan->id) != nullptr; });
}

std::string why_unseen(const model::Record& record, const model::Surface& surface) {
    return scans_of(record, surface).empty() ? "no scan of its days is in the project; planum scan add brings them"
                                             : "none of its scans stands on the site grid; planum register places them";
}

} // namespace planum::app
