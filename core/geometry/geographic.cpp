// SPDX-License-Identifier: MIT
#include "core/geometry/geographic.hpp"

#include <cmath>
#include <string>
#include <utility>

#include <proj.h>

namespace planum::geometry {

struct Geographic::Proj {
    PJ_CONTEXT* context = nullptr;
    PJ* operation = nullptr;

    Proj() = default;
    Proj(const Proj&) = delete;
    Proj& operator=(const Proj&) = delete;

    ~Proj() {
        proj_destroy(operation);
        proj_context_destroy(context);
    }
};

std::optional<Geographic> Geographic::of_epsg(std::int64_t code) {
    auto proj = std::make_unique<Proj>();
    proj->context = proj_context_create();
    proj_log_level(proj->context, PJ_LOG_NONE); // a library does not print
    const std::string from = "EPSG:" + std::to_string(code);
    PJ* raw = proj_create_crs_to_crs(proj->context, from.c_str(), "EPSG:4326", nullptr);
    if (raw == nullptr) return std::nullopt;
    // x before y on both sides, whatever the authority says about axes: as a GeoPackage and GeoJSON have it.
    proj->operation = proj_normalize_for_visualization(proj->context, raw);
    proj_destroy(raw);
    if (proj->operation == nullptr) return std::nullopt;
    return Geographic{std::move(proj)};
}

Geographic::Geographic(std::unique_ptr<Proj> proj) noexcept : proj_(std::move(proj)) {}

Geographic::Geographic(Geographic&&) noexcept = default;
Geographic& Geographic::operator=(Geographic&&) noexcept = default;
Geographic::~Geographic() = default;

std::optional<std::array<double, 2>> Geographic::longitude_latitude(double x, double y) const {
    const PJ_COORD out = proj_trans(proj_->operation, PJ_FWD, proj_coord(x, y, 0.0, 0.0));
    if (!std::isfinite(out.xy.x) || !std::isfinite(out.xy.y)) return std::nullopt;
    return std::array{out.xy.x, out.xy.y};
}

} // namespace planum::geometry
