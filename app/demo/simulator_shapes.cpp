// SPDX-License-Identifier: MIT
#include "app/demo/simulator_shapes.hpp"

#include <algorithm>
#include <cmath>

#include "app/demo/simulator_random.hpp"

namespace planum::app::demo {

namespace {

constexpr double kAboveMouth = 0.4; ///< how far a cut reaches above its rim, so that no crumb stays [m]

struct Local {
    double along;
    double across;
};

template<class Shape>
Local local_of(const Shape& shape, const Vec3& p) noexcept {
    const double dx = p.x - shape.x;
    const double dy = p.y - shape.y;
    return {dx * shape.axis_x + dy * shape.axis_y, dy * shape.axis_x - dx * shape.axis_y};
}

// Share of the radius at a depth from 0 (mouth) to 1 (base).
double share_at(Profile profile, double depth) noexcept {
    const double foot = depth > 0.85 ? std::sqrt(std::max(0.0, 1.0 - std::pow((depth - 0.85) / 0.15, 2.0) * 0.6)) : 1.0;
    switch (profile) {
    case Profile::Vertical: return (1.0 - 0.06 * depth) * foot;
    case Profile::Sloping: return (1.0 - 0.5 * depth) * foot;
    case Profile::Bowl: return std::sqrt(std::max(0.0, 1.0 - depth * depth));
    case Profile::Bell: return (0.6 + 0.4 * depth * depth * (3.0 - 2.0 * depth)) * foot;
    case Profile::Vee: return 1.0 - 0.8 * depth;
    }
    return 1.0;
}

} // namespace

HeightTable::HeightTable(const Bounds& extent, double step)
    : x0_(extent.low.x), y0_(extent.low.y), step_(step), per_step_(1.0 / step),
      columns_(static_cast<std::size_t>(std::ceil((extent.high.x - extent.low.x) / step - 1e-9)) + 1),
      rows_(static_cast<std::size_t>(std::ceil((extent.high.y - extent.low.y) / step - 1e-9)) + 1),
      heights_(columns_ * rows_) {}

double HeightTable::at(double x, double y) const noexcept {
    const double u = std::clamp((x - x0_) * per_step_, 0.0, static_cast<double>(columns_ - 1));
    const double v = std::clamp((y - y0_) * per_step_, 0.0, static_cast<double>(rows_ - 1));
    const std::size_t i = std::min(static_cast<std::size_t>(u), columns_ > 1 ? columns_ - 2 : 0);
    const std::size_t j = std::min(static_cast<std::size_t>(v), rows_ > 1 ? rows_ - 2 : 0);
    const double a = u - static_cast<double>(i);
    const double b = v - static_cast<double>(j);
    const float* low = heights_.data() + j * columns_ + i;
    const float* high = rows_ > 1 ? low + columns_ : low;
    const std::size_t right = columns_ > 1 ? 1 : 0;
    const double lower = static_cast<double>(low[0]) * (1.0 - a) + static_cast<double>(low[right]) * a;
    const double upper = static_cast<double>(high[0]) * (1.0 - a) + static_cast<double>(high[right]) * a;
    return lower * (1.0 - b) + upper * b;
}

double HeightTable::highest() const noexcept {
    return heights_.empty() ? 0.0 : static_cast<double>(*std::max_element(heights_.begin(), heights_.end()));
}

Bounds HeightTable::extent() const noexcept { return {{x0_, y0_, 0.0}, {x_of(columns_ - 1), y_of(rows_ - 1), 0.0}}; }

double CutShape::half_width(double z) const noexcept {
    const double depth = std::clamp((mouth - z) / (mouth - base), 0.0, 1.0);
    return radius * share_at(profile, depth);
}

bool CutShape::contains(const Vec3& p) const noexcept {
    if (p.z < base || p.z > mouth + kAboveMouth) return false;
    const Local at = local_of(*this, p);
    const double half = half_width(p.z);
    if (plan == Plan::Linear) {
        if (std::abs(at.along) > half_length) return false;
        const double wave = 1.0 + wobble[0] * std::sin(2.1 * at.along + 30.0 * wobble[1]);
        return std::abs(at.across) < half * wave;
    }
    const double a = at.along / aspect;
    const double r = std::sqrt(a * a + at.across * at.across);
    if (r > 1.5 * radius) return false;
    if (r < 1e-9) return true;
    const double c = a / r;
    const double s = at.across / r;
    const double outline =
        1.0 + wobble[0] * (c * c - s * s) + wobble[1] * 2.0 * s * c + wobble[2] * c * (4.0 * c * c - 3.0);
    return r < half * outline;
}

Bounds CutShape::bounds() const noexcept {
    const double reach = plan == Plan::Linear ? half_length + radius : radius * std::max(1.0, aspect);
    const double r = reach * 1.3;
    return {{x - r, y - r, base}, {x + r, y + r, mouth + kAboveMouth}};
}

bool WallShape::contains(const Vec3& p, bool in_trench) const noexcept {
    if (p.z < base || p.z > top + 0.1) return false;
    const Local at = local_of(*this, p);
    const double across = std::abs(at.across);
    if (p.z < footing_top) return in_trench && across < footing_half;
    if (std::abs(at.along) > half_length) return false;
    const double half = half_width;
    if (across > half + 0.02) return false;
    if (p.z > top - 0.1) {
        // Ragged: courses were robbed stone by stone.
        const double ragged = 0.04 * noise(mix(seed, 2), at.along * 3.0, at.across * 4.0);
        if (p.z > top + ragged) return false;
    }
    if (across < half - 0.02) return true;
    // Faces of stones stand out or back by up to 1.5 cm.
    const double face = 0.015 * noise(mix(seed, at.across > 0 ? 3 : 4), at.along * 5.0, p.z * 7.0);
    return across < half + face;
}

Bounds WallShape::bounds() const noexcept {
    const double r = half_length + footing_half + 0.1;
    return {{x - r, y - r, base}, {x + r, y + r, top + 0.1}};
}

} // namespace planum::app::demo
