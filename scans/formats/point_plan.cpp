// SPDX-License-Identifier: MIT
#include "scans/formats/point_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/text.hpp"

namespace planum::scans {

namespace {

struct NamedRole {
    std::string_view name;
    Role role;
};

constexpr std::array kNames = {
    NamedRole{"x", Role::X},
    NamedRole{"y", Role::Y},
    NamedRole{"z", Role::Z},
    NamedRole{"easting", Role::X},
    NamedRole{"northing", Role::Y},
    NamedRole{"elevation", Role::Z},
    NamedRole{"height", Role::Z},
    NamedRole{"east", Role::X},
    NamedRole{"north", Role::Y},
    NamedRole{"rechtswert", Role::X},
    NamedRole{"hochwert", Role::Y},
    NamedRole{"höhe", Role::Z},
    NamedRole{"//x", Role::X},
    NamedRole{"#x", Role::X},
    NamedRole{"cartesianx", Role::X},
    NamedRole{"cartesiany", Role::Y},
    NamedRole{"cartesianz", Role::Z},
    NamedRole{"intensity", Role::Intensity},
    NamedRole{"intensität", Role::Intensity},
    NamedRole{"intensitaet", Role::Intensity},
    NamedRole{"i", Role::Intensity},
    NamedRole{"reflectance", Role::Intensity},
    NamedRole{"reflectivity", Role::Intensity},
    NamedRole{"remission", Role::Intensity},
    NamedRole{"amplitude", Role::Intensity},
    NamedRole{"scalar_intensity", Role::Intensity},
    NamedRole{"scalar_reflectance", Role::Intensity},
    NamedRole{"red", Role::Red},
    NamedRole{"green", Role::Green},
    NamedRole{"blue", Role::Blue},
    NamedRole{"r", Role::Red},
    NamedRole{"g", Role::Green},
    NamedRole{"b", Role::Blue},
    NamedRole{"diffuse_red", Role::Red},
    NamedRole{"diffuse_green", Role::Green},
    NamedRole{"diffuse_blue", Role::Blue},
    NamedRole{"rgb", Role::PackedRgb},
    NamedRole{"rgba", Role::PackedRgb},
    NamedRole{"row", Role::Row},
    NamedRole{"rowindex", Role::Row},
    NamedRole{"column", Role::Column},
    NamedRole{"col", Role::Column},
    NamedRole{"columnindex", Role::Column},
    NamedRole{"time", Role::Time},
    NamedRole{"timestamp", Role::Time},
    NamedRole{"gpstime", Role::Time},
    NamedRole{"gps_time", Role::Time},
    NamedRole{"scalar_gpstime", Role::Time},
};

std::uint64_t whole_number(double value) noexcept {
    // The comparison is written so that NaN ends at 0.
    return value >= 0.0 ? static_cast<std::uint64_t>(std::min(value, 4294967295.0)) : 0;
}

} // namespace

Role role_of_name(std::string_view name) {
    const std::string folded = text::fold_case(text::trim(name));
    const auto* const found =
        std::find_if(kNames.begin(), kNames.end(), [&](const NamedRole& n) { return n.name == folded; });
    return found == kNames.end() ? Role::Other : found->role;
}

std::string_view role_name(Role role) noexcept {
    switch (role) {
    case Role::Other: return "-";
    case Role::X: return "x";
    case Role::Y: return "y";
    case Role::Z: return "z";
    case Role::Intensity: return "intensity";
    case Role::Red: return "red";
    case Role::Green: return "green";
    case Role::Blue: return "blue";
    case Role::PackedRgb: return "rgb";
    case Role::Row: return "row";
    case Role::Column: return "column";
    case Role::Time: return "time";
    }
    return "-";
}

void ValueSampler::add(double value) noexcept {
    if (!std::isfinite(value)) return;
    minimum_ = count_ == 0 ? value : std::min(minimum_, value);
    maximum_ = count_ == 0 ? value : std::max(maximum_, value);
    whole_ = whole_ && value == std::floor(value);
    ++count_;
}

IntensityCoding ValueSampler::intensity_coding() const noexcept {
    if (count_ == 0 || (minimum_ >= 0.0 && maximum_ <= 1.0)) return {0.0, 1.0 / 65535.0};
    if (whole_ && minimum_ >= 0.0 && maximum_ <= 65535.0) return {0.0, 1.0};
    if (whole_ && minimum_ >= -32768.0 && maximum_ <= 32767.0) return {-32768.0, 1.0};
    const double reach = std::exp2(std::ceil(std::log2(std::max(std::abs(minimum_), std::abs(maximum_)))));
    if (!std::isfinite(reach)) return {0.0, 1.0};
    if (minimum_ >= 0.0) return {0.0, reach / 65535.0};
    return {-reach, 2.0 * reach / 65535.0};
}

double ValueSampler::colour_scale() const noexcept {
    if (count_ > 0 && !whole_ && maximum_ <= 1.0) return 255.0;
    return maximum_ > 255.0 ? 1.0 / 257.0 : 1.0;
}

bool PointPlan::has_colour() const noexcept {
    return has(Role::PackedRgb) || (has(Role::Red) && has(Role::Green) && has(Role::Blue));
}

Columns PointPlan::columns() const noexcept {
    Columns columns;
    columns.intensity = has(Role::Intensity);
    columns.colour = has_colour();
    columns.grid = has(Role::Row) && has(Role::Column);
    columns.time = has(Role::Time);
    return columns;
}

void PointPlan::place(std::span<const double> values, BlockBuilder& builder) const {
    const auto value = [&](Role role) { return values[static_cast<std::size_t>(index(role))]; };
    builder.set_place(value(Role::X), value(Role::Y), value(Role::Z));
    if (has(Role::Intensity)) builder.set_intensity(value(Role::Intensity), intensity);
    if (has(Role::PackedRgb)) {
        const auto packed = static_cast<std::uint32_t>(whole_number(value(Role::PackedRgb)));
        builder.block.colour[builder.slot()] = {static_cast<std::uint8_t>(packed >> 16U),
                                                static_cast<std::uint8_t>(packed >> 8U),
                                                static_cast<std::uint8_t>(packed)};
    } else if (has_colour()) {
        builder.set_colour(value(Role::Red) * colour_scale, value(Role::Green) * colour_scale,
                           value(Role::Blue) * colour_scale);
    }
    if (has(Role::Row) && has(Role::Column)) {
        builder.set_grid(whole_number(value(Role::Row)), whole_number(value(Role::Column)));
    }
    if (has(Role::Time)) builder.block.time[builder.slot()] = value(Role::Time);
}

void PointPlan::sample(std::span<const double> values, ValueSampler& intensities,
                       ValueSampler& colours) const noexcept {
    if (has(Role::Intensity)) intensities.add(values[static_cast<std::size_t>(index(Role::Intensity))]);
    for (const Role role : {Role::Red, Role::Green, Role::Blue}) {
        if (has(role)) colours.add(values[static_cast<std::size_t>(index(role))]);
    }
}

PointPlan plan_of(std::span<const Role> roles) noexcept {
    PointPlan plan;
    plan.at.fill(-1);
    for (std::size_t i = 0; i < roles.size(); ++i) {
        int& at = plan.at[static_cast<std::size_t>(roles[i])];
        if (at < 0) at = static_cast<int>(i);
    }
    return plan;
}

} // namespace planum::scans
