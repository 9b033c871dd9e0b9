// SPDX-License-Identifier: MIT
#include "app/demo/simulator_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "app/demo/simulator_random.hpp"

namespace planum::app::demo {

namespace {

using Look = Solid::Look;
using Type = Solid::Type;

constexpr double kReach = 55.0;    ///< how far the ground is known around the trench [m]
constexpr double kLoosened = 1.25; ///< dug earth takes more room
constexpr double kRepose = 0.65;   ///< slope of the spoil heap

Solid solid(Type type, Look look, Vec3 centre, Vec3 half, double yaw, double brightness, std::uint64_t key) {
    return {type, look, centre, half, std::cos(yaw), std::sin(yaw), brightness, key};
}

// Collects what stands around, each thing with a key of its own.
class SceneBuilder {
  public:
    SceneBuilder(const SiteShape& site, std::uint64_t seed) : site_(site), seed_(seed), draw_(seed, 500) {}

    void houses() {
        const int count = 4 + draw_.below(3);
        for (int i = 0; i < count; ++i) {
            const double angle = 2.0 * std::numbers::pi * (i + draw_.between(-0.25, 0.25)) / count;
            const double far = reach() + draw_.between(16.0, 26.0);
            const Vec3 half{draw_.between(4.0, 8.0), draw_.between(3.0, 5.0), draw_.between(2.8, 5.5)};
            put(Type::Box, draw_.chance(0.5) ? Look::Windows : Look::Bricks, angle, far, half, draw_.between(0.0, 3.0),
                0.55);
        }
    }

    void hut_and_container() {
        const double angle = draw_.between(0.0, 6.28);
        put(Type::Box, Look::Boards, angle, reach() + 5.5, {2.5, 1.2, 1.3}, angle + 0.4, 0.5);
        put(Type::Box, Look::Corrugated, angle + 0.9, reach() + 6.0, {3.0, 1.22, 1.3}, angle + 0.2, 0.45);
    }

    void fence() {
        // Along three sides of the site; boards with gaps, posts every 2.5 m.
        const double away = reach() + 8.5;
        const double cx = middle_x();
        const double cy = middle_y();
        for (int side = 0; side < 3; ++side) {
            for (double t = -away; t < away; t += 2.5) {
                const double x = side == 0 ? cx - away : side == 1 ? cx + away : cx + t + 1.25;
                const double y = side == 2 ? cy + away : cy + t + 1.25;
                const double yaw = side == 2 ? 0.0 : std::numbers::pi * 0.5;
                const double ground = ground_at(x, y);
                solids.push_back(solid(Type::Box, Look::Boards, {x, y, ground + 1.0}, {1.15, 0.02, 0.85}, yaw,
                                       draw_.between(0.45, 0.65), draw_.next()));
                solids.push_back(solid(Type::Box, Look::Bark,
                                       {x - 1.25 * std::cos(yaw), y - 1.25 * std::sin(yaw), ground + 1.0},
                                       {0.05, 0.05, 1.1}, 0.0, 0.35, draw_.next()));
            }
        }
    }

    void trees() {
        const int count = 6 + draw_.below(4);
        for (int i = 0; i < count; ++i) {
            const double angle = draw_.between(0.0, 6.28);
            const double far = reach() + draw_.between(9.5, 20.0);
            const double x = middle_x() + far * std::cos(angle);
            const double y = middle_y() + far * std::sin(angle);
            const double ground = ground_at(x, y);
            const double trunk = draw_.between(1.2, 2.0);
            const double radius = draw_.between(0.14, 0.3);
            solids.push_back(solid(Type::Cylinder, Look::Bark, {x, y, ground + trunk}, {radius, radius, trunk}, 0.0,
                                   0.3, draw_.next()));
            for (int c = 0; c < 3; ++c) {
                const double r = draw_.between(1.0, 1.9);
                solids.push_back(solid(Type::Ellipsoid, Look::Leaves,
                                       {x + draw_.between(-0.8, 0.8), y + draw_.between(-0.8, 0.8),
                                        ground + 2.0 * trunk + draw_.between(0.2, 1.4)},
                                       {r, r, 0.8 * r}, 0.0, 0.5, draw_.next()));
            }
        }
    }

    void clutter() {
        for (int i = 0; i < 14; ++i) {
            const double angle = draw_.between(0.0, 6.28);
            const double size = draw_.between(0.15, 0.5);
            put(Type::Box, draw_.chance(0.5) ? Look::Boards : Look::Plain, angle, reach() + draw_.between(3.0, 8.0),
                {size * draw_.between(0.6, 2.0), size, size * draw_.between(0.5, 1.2)}, draw_.between(0.0, 3.0),
                draw_.between(0.2, 0.8));
        }
    }

    // A ring of poles with balls on top, close enough that each station has five within 4 to 14 m.
    void poles(std::vector<Marker>& markers) {
        const double rx = 0.5 * (site_.trench.high.x - site_.trench.low.x) + 2.4;
        const double ry = 0.5 * (site_.trench.high.y - site_.trench.low.y) + 2.4;
        const int count = std::max(9, static_cast<int>((rx + ry) * 1.1));
        for (int i = 0; i < count; ++i) {
            const double angle = 2.0 * std::numbers::pi * (i + draw_.between(-0.2, 0.2)) / count;
            const double x = middle_x() + (rx + draw_.between(0.0, 1.2)) * std::cos(angle) * 1.15;
            const double y = middle_y() + (ry + draw_.between(0.0, 1.2)) * std::sin(angle) * 1.15;
            const double height = draw_.between(0.9, 1.9);
            const double ground = ground_at(x, y);
            solids.push_back(solid(Type::Cylinder, Look::Plain, {x, y, ground + 0.5 * height},
                                   {0.02, 0.02, 0.5 * height}, 0.0, 0.6, draw_.next()));
            const Vec3 ball{round_to_tenth_mm(x), round_to_tenth_mm(y), round_to_tenth_mm(ground + height + 0.07)};
            solids.push_back(solid(Type::Ellipsoid, Look::Target, ball, {0.07, 0.07, 0.07}, 0.0, 0.95, draw_.next()));
            markers.push_back({fmt::format("M{}", i + 1), ball});
        }
    }

    std::vector<Solid> solids;

  private:
    static double round_to_tenth_mm(double x) { return std::round(x * 1e4) * 1e-4; }

    [[nodiscard]] double middle_x() const { return 0.5 * (site_.trench.low.x + site_.trench.high.x); }

    [[nodiscard]] double middle_y() const { return 0.5 * (site_.trench.low.y + site_.trench.high.y); }

    [[nodiscard]] double reach() const {
        return 0.5 * std::max(site_.trench.high.x - site_.trench.low.x, site_.trench.high.y - site_.trench.low.y);
    }

    [[nodiscard]] double ground_at(double x, double y) const { return turf_height(site_, seed_, x, y); }

    void put(Type type, Look look, double angle, double far, Vec3 half, double yaw, double brightness) {
        const double x = middle_x() + far * std::cos(angle);
        const double y = middle_y() + far * std::sin(angle);
        solids.push_back(
            solid(type, look, {x, y, ground_at(x, y) + half.z - 0.1}, half, yaw, brightness, draw_.next()));
    }

    const SiteShape& site_;
    std::uint64_t seed_;
    Draw draw_;
};

// Where the earth is thrown: a ridge beside the long side, as high as its volume asks.
HeightTable terrain_with_spoil(const SiteShape& site, std::uint64_t seed, double volume) {
    const Bounds around{{site.trench.low.x - kReach, site.trench.low.y - kReach, 0.0},
                        {site.trench.high.x + kReach, site.trench.high.y + kReach, 0.0}};
    HeightTable terrain(around, 0.2);
    const double half_ridge = 0.3 * (site.trench.high.x - site.trench.low.x);
    const double x0 = 0.5 * (site.trench.low.x + site.trench.high.x);
    // Volume of a ridge with round ends: width² ∙ slope ∙ length + cone.
    double height = 0.0;
    while (height < 6.0 && height * height / kRepose * (2.0 * half_ridge + 1.05 * height / kRepose) < volume)
        height += 0.01;
    const double y0 = site.trench.low.y - 4.2 - height / kRepose;
    terrain.fill([&](double x, double y) {
        const double beyond = std::max(0.0, std::abs(x - x0) - half_ridge);
        const double away = std::hypot(beyond, y - y0);
        const double rough =
            0.12 * noise(mix(seed, 61), x / 0.9, y / 0.9) + 0.05 * noise(mix(seed, 62), x / 0.3, y / 0.3);
        const double heap = height - kRepose * away + rough * std::min(1.0, height);
        return turf_height(site, seed, x, y) + std::max(0.0, heap);
    });
    return terrain;
}

void add_person(std::vector<Solid>& solids, const Vec3& feet, Draw& draw) {
    const double tall = draw.between(0.8, 0.95);
    const double yaw = draw.between(0.0, 6.28);
    for (const double side : {-0.11, 0.11}) {
        solids.push_back(solid(Type::Cylinder, Look::Cloth,
                               {feet.x + side * std::cos(yaw), feet.y + side * std::sin(yaw), feet.z + 0.45},
                               {0.08, 0.08, 0.45}, 0.0, 0.25, draw.next()));
    }
    solids.push_back(solid(Type::Ellipsoid, Look::Cloth, {feet.x, feet.y, feet.z + 0.9 + 0.3 * tall},
                           {0.24, 0.16, 0.36}, yaw, 0.6, draw.next()));
    solids.push_back(solid(Type::Ellipsoid, Look::Plain, {feet.x, feet.y, feet.z + 0.9 + 0.85 * tall}, {0.1, 0.1, 0.13},
                           yaw, 0.7, draw.next()));
}

} // namespace

Scene make_scene(const SiteShape& site, std::uint64_t seed, double dug) {
    Scene scene;
    SceneBuilder builder(site, seed);
    builder.houses();
    builder.hut_and_container();
    builder.fence();
    builder.trees();
    builder.clutter();
    builder.poles(scene.markers);
    scene.standing = std::move(builder.solids);
    scene.spoil_volume = dug * kLoosened;
    scene.terrain = terrain_with_spoil(site, seed, scene.spoil_volume);
    return scene;
}

std::vector<Solid> passers_by(const SiteShape& site, const Scene& scene, std::uint64_t key) {
    std::vector<Solid> solids;
    Draw draw(key, 600);
    if (!draw.chance(0.4)) return solids;
    const double width = site.trench.high.x - site.trench.low.x;
    const double depth = site.trench.high.y - site.trench.low.y;
    const int people = 1 + draw.below(3);
    for (int i = 0; i < people; ++i) {
        const double x = site.trench.low.x + draw.between(-0.4, 1.4) * width;
        const bool near_side = draw.chance(0.5);
        const double away = draw.between(1.6, 5.0);
        const double y = near_side ? site.trench.low.y - away : site.trench.low.y + depth + away;
        add_person(solids, {x, y, scene.terrain.at(x, y)}, draw);
    }
    if (draw.chance(0.5)) {
        // An excavator or a van behind the trench.
        const double x = site.trench.low.x + draw.between(0.0, 1.0) * width;
        const double y = site.trench.high.y + draw.between(5.0, 7.0);
        const double ground = scene.terrain.at(x, y);
        const double yaw = draw.between(0.0, 3.14);
        solids.push_back(solid(Type::Box, Look::Plain, {x, y, ground + 0.45}, {1.8, 0.9, 0.45}, yaw, 0.3, draw.next()));
        solids.push_back(
            solid(Type::Box, Look::Windows, {x, y, ground + 1.45}, {1.1, 0.85, 0.6}, yaw, 0.7, draw.next()));
    }
    return solids;
}

} // namespace planum::app::demo
