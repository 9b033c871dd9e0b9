// SPDX-License-Identifier: MIT
#include "app/regions/outline_remarks.hpp"

#include <fmt/format.h>

#include "app/regions/region_layout.hpp"
#include "app/regions/region_names.hpp"
#include "core/model/astray.hpp"

namespace planum::app {

std::vector<std::string> outline_remarks(const model::Record& record, const model::RecordIndex& index,
                                         const model::Region& wished) {
    std::vector<std::string> said;
    const model::ScannedBox scanned(record);
    if (scanned.is_astray(wished)) said.push_back("it " + model::astray_words(scanned.distance(wished)));
    const model::Section* section = section_of(record, wished);
    std::vector<const model::Region*> regions =
        section == nullptr ? regions_on(record, wished.surface) : regions_on(record, wished.section);
    for (const model::Region*& region : regions) {
        if (region->id == wished.id) region = &wished;
    }
    for (const RegionOverlap& overlap : layout_regions(regions, section).overlaps) {
        if (overlap.first != &wished && overlap.second != &wished) continue;
        const model::Region& other = overlap.first == &wished ? *overlap.second : *overlap.first;
        said.push_back(fmt::format("it overlaps {} by {:.2f} m²; neither gets that ground",
                                   region_name(record, index, other), overlap.area));
    }
    return said;
}

} // namespace planum::app
