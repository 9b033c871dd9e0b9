// SPDX-License-Identifier: MIT
#include "core/geometry/coordinate_system.hpp"

#include <array>
#include <memory>

#include <proj.h>

namespace planum::geometry {

namespace {

struct DestroyContext {
    void operator()(PJ_CONTEXT* context) const noexcept { proj_context_destroy(context); }
};

struct DestroyObject {
    void operator()(PJ* object) const noexcept { proj_destroy(object); }
};

} // namespace

std::optional<CoordinateSystem> coordinate_system_of_epsg(std::int64_t code) {
    const std::unique_ptr<PJ_CONTEXT, DestroyContext> context{proj_context_create()};
    proj_log_level(context.get(), PJ_LOG_NONE); // a library does not print
    const std::string number = std::to_string(code);
    const std::unique_ptr<PJ, DestroyObject> crs{
        proj_create_from_database(context.get(), "EPSG", number.c_str(), PJ_CATEGORY_CRS, 0, nullptr)};
    if (!crs) return std::nullopt;
    const std::array<const char*, 2> options = {"MULTILINE=NO", nullptr};
    const char* wkt = proj_as_wkt(context.get(), crs.get(), PJ_WKT1_GDAL, options.data());
    const char* name = proj_get_name(crs.get());
    if (wkt == nullptr || name == nullptr) return std::nullopt;
    return CoordinateSystem{name, wkt};
}

} // namespace planum::geometry
