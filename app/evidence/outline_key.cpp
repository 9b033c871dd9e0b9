// SPDX-License-Identifier: MIT
#include "app/evidence/outline_key.hpp"

#include <fmt/format.h>

namespace planum::app {

std::string outline_key(const model::Region& region) {
    std::string text = fmt::format("{} {} {} {}\n", region.unit.to_string(), static_cast<int>(region.category),
                                   static_cast<int>(region.shows), region.sigma);
    for (const model::Polygon& polygon : region.outline) {
        const auto add = [&](const model::Ring& ring) {
            for (const auto& p : ring) text += fmt::format("{} {},", p[0], p[1]);
            text += '\n';
        };
        add(polygon.outer);
        for (const model::Ring& hole : polygon.holes) add(hole);
    }
    return text;
}

} // namespace planum::app
