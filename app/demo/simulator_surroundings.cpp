// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/demo/simulator_random.hpp"
#include "app/demo/simulator_scanner.hpp"

namespace planum::app::demo {

namespace {

constexpr double kCell = 0.06;   ///< coarse cells of the trench [m]
constexpr double kMarch = 0.008; ///< step inside a cell that may hold something [m]
constexpr double kReach = 60.0;  ///< of the scanner [m]

// Where a ray is above the rectangle of the trench; empty when begin >= end.
struct Span {
    double begin;
    double end;
};

Span over(const Bounds& b, const Vec3& o, const Vec3& d) noexcept {
    Span span{0.0, kReach};
    const auto clip = [&](double origin, double along, double low, double high) {
        if (std::abs(along) < 1e-12) {
            if (origin <= low || origin >= high) span.end = -1.0;
            return;
        }
        const double a = (low - origin) / along;
        const double c = (high - origin) / along;
        span.begin = std::max(span.begin, std::min(a, c));
        span.end = std::min(span.end, std::max(a, c));
    };
    clip(o.x, d.x, b.low.x, b.high.x);
    clip(o.y, d.y, b.low.y, b.high.y);
    return span;
}

} // namespace

Surroundings::Surroundings(const Formation& formation, const DigPlan& plan, const ColumnGrid& grid, const DugGrid& dug,
                           SurfaceNo surface, const Scene& scene)
    : formation_(formation), plan_(plan), surface_(surface), scene_(scene), top_(plan.site.trench.high.z + 0.3) {
    mark_cells(grid, dug);
}

void Surroundings::mark_cells(const ColumnGrid& grid, const DugGrid& dug) {
    const Bounds& t = plan_.site.trench;
    nx_ = static_cast<std::size_t>(std::ceil((t.high.x - t.low.x) / kCell)) + 1;
    ny_ = static_cast<std::size_t>(std::ceil((t.high.y - t.low.y) / kCell)) + 1;
    nz_ = static_cast<std::size_t>(std::ceil((top_ - t.low.z) / kCell)) + 1;
    filled_.assign(nx_ * ny_ * nz_, 0);
    const auto mark = [&](double x, double y, double low, double high) {
        // A margin of a column around, because between columns the ground may stand a little higher.
        const double margin = grid.cell();
        const auto index = [&](double v, double from) {
            return static_cast<std::size_t>(std::max(0.0, std::floor((v - from) / kCell)));
        };
        const std::size_t k0 = index(low - 0.03, t.low.z);
        const std::size_t k1 = std::min(nz_ - 1, index(high + 0.03, t.low.z));
        for (std::size_t j = index(y - margin, t.low.y); j <= std::min(ny_ - 1, index(y + margin, t.low.y)); ++j) {
            for (std::size_t i = index(x - margin, t.low.x); i <= std::min(nx_ - 1, index(x + margin, t.low.x)); ++i) {
                for (std::size_t k = k0; k <= k1; ++k) filled_[(j * nx_ + i) * nz_ + k] = 1;
            }
        }
    };
    for (std::size_t index = 0; index < grid.size(); ++index) {
        const double x = grid.x_of(index % grid.columns());
        const double y = grid.y_of(index / grid.columns());
        for (const DugRun& run : dug.at(index)) {
            if (run.gone > surface_) mark(x, y, static_cast<double>(run.low), static_cast<double>(run.high));
        }
        const Slump& slump = plan_.slump;
        if (slump.fell && slump.surface == surface_ &&
            std::hypot((x - slump.x) / slump.half_x, (y - slump.y) / slump.half_y) < 1.1) {
            mark(x, y, slump.floor, slump.floor + slump.height);
        }
    }
    // The sides, which lie between the columns and the edge.
    for (std::size_t j = 0; j < ny_; ++j) {
        for (std::size_t i = 0; i < nx_; ++i) {
            if (i > 0 && j > 0 && i + 2 < nx_ && j + 2 < ny_) continue;
            for (std::size_t k = 0; k < nz_; ++k) filled_[(j * nx_ + i) * nz_ + k] = 1;
        }
    }
}

bool Surroundings::solid(const Vec3& p) const noexcept {
    const Body body = formation_.body_at(p);
    if (body.unit != kAir && plan_.gone_on(formation_, body.unit, p) > surface_) return true;
    return surface_ == plan_.slump.surface && plan_.slump.holds(p);
}

double Surroundings::trench_hit(const Vec3& from, const Vec3& direction, double begin, double end) const noexcept {
    const Bounds& t = plan_.site.trench;
    // Only the part between the highest and the lowest that may hold something.
    if (std::abs(direction.z) > 1e-12) {
        const double a = (top_ - from.z) / direction.z;
        const double b = (t.low.z + 0.02 - from.z) / direction.z;
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    } else if (from.z > top_) {
        return 0.0;
    }
    double t_now = begin + 1e-6;
    double t_free = t_now;
    while (t_now < end) {
        const Vec3 p = from + t_now * direction;
        const double u = (p.x - t.low.x) / kCell;
        const double v = (p.y - t.low.y) / kCell;
        const double w = (p.z - t.low.z) / kCell;
        const auto i = static_cast<std::size_t>(std::clamp(u, 0.0, static_cast<double>(nx_ - 1)));
        const auto j = static_cast<std::size_t>(std::clamp(v, 0.0, static_cast<double>(ny_ - 1)));
        const auto k = static_cast<std::size_t>(std::clamp(w, 0.0, static_cast<double>(nz_ - 1)));
        if (filled_[(j * nx_ + i) * nz_ + k] == 0) {
            // To the far face of the empty cell.
            const auto leave = [](double at, double index, double along) {
                if (std::abs(along) < 1e-12) return 1e9;
                return ((along > 0.0 ? index + 1.0 : index) - at) * kCell / along;
            };
            const double step =
                std::min({leave(u, static_cast<double>(i), direction.x), leave(v, static_cast<double>(j), direction.y),
                          leave(w, static_cast<double>(k), direction.z)});
            t_now += std::max(step, 0.0) + 1e-6;
            t_free = t_now;
            continue;
        }
        if (solid(p)) {
            double near = t_free;
            double far = t_now;
            while (far - near > 2e-5) {
                const double middle = 0.5 * (near + far);
                (solid(from + middle * direction) ? far : near) = middle;
            }
            return 0.5 * (near + far);
        }
        t_free = t_now;
        t_now += kMarch;
    }
    return 0.0;
}

double Surroundings::terrain_hit(const Vec3& from, const Vec3& direction, double begin, double end) const noexcept {
    constexpr double kSteepest = 1.9; // slope of the spoil heap with its clods
    double t = begin;
    double before = begin;
    for (int step = 0; step < 400 && t < end; ++step) {
        const Vec3 p = from + t * direction;
        const double above = p.z - scene_.terrain.at(p.x, p.y);
        if (above < 0.0) {
            double near = before;
            double far = t;
            while (far - near > 2e-5) {
                const double middle = 0.5 * (near + far);
                const Vec3 q = from + middle * direction;
                (q.z < scene_.terrain.at(q.x, q.y) ? far : near) = middle;
            }
            return 0.5 * (near + far);
        }
        if (above > 7.0 && direction.z > 0.0) return 0.0;
        before = t;
        t += std::max(above / kSteepest, 0.003);
    }
    return 0.0;
}

double Surroundings::ground_hit(const Vec3& from, const Vec3& direction) const noexcept {
    const Span span = over(plan_.site.trench, from, direction);
    if (span.begin >= span.end) return terrain_hit(from, direction, 0.3, kReach);
    if (const double t = terrain_hit(from, direction, 0.3, span.begin); t > 0.0) return t;
    if (const double t = trench_hit(from, direction, span.begin, span.end); t > 0.0) return t;
    // The far edge of the trench, where the ray comes out of it below the turf.
    const Vec3 out = from + span.end * direction;
    if (out.z < scene_.terrain.at(out.x, out.y)) return span.end;
    return terrain_hit(from, direction, span.end, kReach);
}

double Surroundings::ground_look(const Vec3& p) const noexcept {
    const Bounds& t = plan_.site.trench;
    constexpr double kTurf = 0.42;
    double brightness = kTurf;
    double mottle = 0.10;
    std::uint64_t key = mix(plan_.seed, 801);
    if (t.holds(p.x, p.y)) {
        const Body body = formation_.body_at({p.x, p.y, p.z - 0.003});
        const bool fallen = surface_ == plan_.slump.surface && plan_.slump.holds({p.x, p.y, p.z - 0.003});
        if (body.unit != kAir && !fallen) {
            key = mix(plan_.seed, static_cast<std::uint64_t>(900 + body.unit));
            const FormedUnit& unit = formation_.units()[static_cast<std::size_t>(body.unit)];
            brightness = 0.25 + 0.4 * unit_of(key);
            if (unit.kind == model::UnitKind::Natural) brightness = 0.72;
            if (unit.form == model::UnitForm::Fill) brightness = 0.2 + 0.2 * unit_of(key);
            if (unit.thin) brightness = 0.85;
            mottle = 0.05 + 0.08 * unit_of(mix(key, 1));
            if (unit.kind == model::UnitKind::Structure) {
                // Stones in courses, joints of mortar.
                const double stone = noise(mix(key, 3), p.x * 4.5, p.y * 4.5, p.z * 7.0);
                return std::abs(stone) < 0.08 ? 0.8 : 0.5 + 0.25 * stone;
            }
        }
    }
    double look = brightness + mottle * noise(mix(key, 5), p.x * 3.0, p.y * 3.0, p.z * 3.0) +
                  0.6 * mottle * noise(mix(key, 6), p.x * 13.0, p.y * 13.0, p.z * 13.0);
    // Pebbles and sherds.
    const double pebble = noise(mix(key, 7), p.x * 22.0, p.y * 22.0, p.z * 22.0);
    if (pebble > 0.62) look += 0.25;
    if (pebble < -0.68) look -= 0.15;
    return look;
}

} // namespace planum::app::demo
