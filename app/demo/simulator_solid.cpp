// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/demo/simulator_random.hpp"
#include "app/demo/simulator_scene.hpp"

namespace planum::app::demo {

namespace {

std::optional<double> box(const Vec3& half, const Vec3& o, const Vec3& d) noexcept {
    double near = 0.0;
    double far = 1e9;
    const double origin[3] = {o.x, o.y, o.z};
    const double along[3] = {d.x, d.y, d.z};
    const double side[3] = {half.x, half.y, half.z};
    for (int i = 0; i < 3; ++i) {
        if (std::abs(along[i]) < 1e-12) {
            if (std::abs(origin[i]) > side[i]) return std::nullopt;
            continue;
        }
        const double a = (-side[i] - origin[i]) / along[i];
        const double b = (side[i] - origin[i]) / along[i];
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    if (near >= far || near <= 0.0) return std::nullopt;
    return near;
}

std::optional<double> front_root(double a, double b, double c) noexcept {
    const double root = b * b - a * c;
    if (root < 0.0 || a < 1e-12) return std::nullopt;
    const double t = (-b - std::sqrt(root)) / a;
    if (t <= 0.0) return std::nullopt;
    return t;
}

double tiles(std::uint64_t key, double u, double v, double du, double dv) noexcept {
    const auto row = static_cast<std::int64_t>(std::floor(v / dv));
    const double shift = (row & 1) != 0 ? 0.5 : 0.0;
    const auto column = static_cast<std::int64_t>(std::floor(u / du + shift));
    return unit_of(mix(mix(key, static_cast<std::uint64_t>(row)), static_cast<std::uint64_t>(column)));
}

double in_tile(double u, double du) noexcept { return u / du - std::floor(u / du); }

} // namespace

std::optional<double> Solid::hit(const Vec3& from, const Vec3& direction) const noexcept {
    const Vec3 relative = from - centre;
    const Vec3 o{relative.x * cos_yaw + relative.y * sin_yaw, relative.y * cos_yaw - relative.x * sin_yaw, relative.z};
    const Vec3 d{direction.x * cos_yaw + direction.y * sin_yaw, direction.y * cos_yaw - direction.x * sin_yaw,
                 direction.z};
    switch (type) {
    case Type::Box: return box(half, o, d);
    case Type::Cylinder: {
        const auto t =
            front_root(d.x * d.x + d.y * d.y, o.x * d.x + o.y * d.y, o.x * o.x + o.y * o.y - half.x * half.x);
        if (!t || std::abs(o.z + *t * d.z) > half.z) return std::nullopt;
        return t;
    }
    case Type::Ellipsoid: {
        const Vec3 os{o.x / half.x, o.y / half.y, o.z / half.z};
        const Vec3 ds{d.x / half.x, d.y / half.y, d.z / half.z};
        return front_root(dot(ds, ds), dot(os, ds), dot(os, os) - 1.0);
    }
    }
    return std::nullopt;
}

double Solid::look_at(const Vec3& p) const noexcept {
    const Vec3 r = p - centre;
    const double along = r.x * cos_yaw + r.y * sin_yaw;
    const double across = r.y * cos_yaw - r.x * sin_yaw;
    // On a face of a box: the coordinate that runs along it.
    const double u = type == Type::Box && std::abs(std::abs(along) - half.x) < 1e-4 ? across + 100.0 : along;
    const double grain = 0.06 * noise(key, p.x * 8.0, p.y * 8.0, p.z * 8.0);
    switch (look) {
    case Look::Plain: return brightness + grain + 0.15 * noise(mix(key, 1), p.x * 2.0, p.y * 2.0, p.z * 2.0);
    case Look::Boards:
        return brightness * (0.7 + 0.6 * tiles(key, u, 0.0, 0.14, 1.0)) + grain -
               (in_tile(u, 0.14) < 0.12 ? 0.25 : 0.0);
    case Look::Bricks: {
        const bool joint = in_tile(r.z, 0.25) < 0.1;
        return joint ? 0.75 : brightness * (0.6 + 0.7 * tiles(key, u, r.z, 0.5, 0.25)) + grain;
    }
    case Look::Windows: {
        const bool pane =
            in_tile(u, 1.7) > 0.35 && in_tile(u, 1.7) < 0.85 && in_tile(r.z, 2.1) > 0.3 && in_tile(r.z, 2.1) < 0.8;
        const bool lit = tiles(key, u, r.z, 1.7, 2.1) > 0.6;
        return pane ? (lit ? 0.3 : 0.12) : brightness + grain + 0.12 * noise(mix(key, 2), u, r.z);
    }
    case Look::Corrugated: {
        const double sign = tiles(key, u, r.z, 0.35, 0.3) > 0.8 && r.z > 0.2 ? 0.35 : 0.0;
        return brightness + 0.12 * std::sin(u * 40.0) + grain + sign;
    }
    case Look::Bark: return brightness + 0.2 * noise(key, p.x * 20.0, p.y * 20.0, p.z * 4.0);
    case Look::Leaves: return brightness + 0.25 * noise(key, p.x * 6.0, p.y * 6.0, p.z * 6.0);
    case Look::Cloth: return brightness + grain;
    case Look::Target: return brightness;
    }
    return brightness;
}

} // namespace planum::app::demo
