// SPDX-License-Identifier: MIT
// Outlines as GeoJSON, as pixel polygons and as typed text: refused with an Error, or read; what was read is made sound
// or refused, and what is sound stays so.
#include <cstdlib>
#include <string_view>

#include "app/regions/geojson_outlines.hpp"
#include "app/regions/outline_text.hpp"
#include "app/regions/pixel_outlines.hpp"
#include "core/base/error.hpp"
#include "core/geometry/polygon_overlay.hpp"

namespace {

void use(const planum::geometry::MultiPolygon& shape) {
    try {
        const auto once = planum::geometry::make_sound(shape);
        const auto twice = planum::geometry::make_sound(once.shape);
        if (twice.shape.empty()) std::abort();
    } catch (const planum::Error&) {
        return;
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size); // bytes are bytes
    try {
        for (const auto& outline : planum::app::read_geojson_outlines(bytes).outlines) use(outline.shape);
    } catch (const planum::Error&) {
        // Refused in a sentence, which is what is wanted.
    }
    try {
        for (const auto& picture : planum::app::read_pixel_outlines(bytes)) {
            const planum::scans::Projection projection(picture.projection);
            for (const auto& outline : picture.outlines) use(outline.shape);
        }
    } catch (const planum::Error&) {
        // As above.
    }
    try {
        use(planum::app::parse_outline(bytes));
    } catch (const planum::Error&) {
        // As above.
    }
    return 0;
}
