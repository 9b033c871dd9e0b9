// SPDX-License-Identifier: MIT
#include "app/demo/simulator_random.hpp"

namespace planum::app::demo {

namespace {

struct Lattice {
    std::int64_t cell;
    double blend; ///< 0…1 inside the cell, with flat ends
};

Lattice lattice(double x) noexcept {
    const double floor = std::floor(x);
    const double t = x - floor;
    return {static_cast<std::int64_t>(floor), t * t * (3.0 - 2.0 * t)};
}

double corner(std::uint64_t key, std::int64_t x, std::int64_t y) noexcept {
    const auto packed = static_cast<std::uint64_t>(x) * 0x8da6b343ULL + static_cast<std::uint64_t>(y) * 0xd8163841ULL;
    return 2.0 * unit_of(key ^ packed) - 1.0;
}

double plane(std::uint64_t key, const Lattice& x, const Lattice& y) noexcept {
    const double low = corner(key, x.cell, y.cell) * (1.0 - x.blend) + corner(key, x.cell + 1, y.cell) * x.blend;
    const double high =
        corner(key, x.cell, y.cell + 1) * (1.0 - x.blend) + corner(key, x.cell + 1, y.cell + 1) * x.blend;
    return low * (1.0 - y.blend) + high * y.blend;
}

} // namespace

double noise(std::uint64_t seed, double x, double y) noexcept { return plane(mix(seed), lattice(x), lattice(y)); }

double noise(std::uint64_t seed, double x, double y, double z) noexcept {
    const Lattice lx = lattice(x);
    const Lattice ly = lattice(y);
    const Lattice lz = lattice(z);
    const auto layer = static_cast<std::uint64_t>(lz.cell);
    return plane(mix(seed, layer), lx, ly) * (1.0 - lz.blend) + plane(mix(seed, layer + 1), lx, ly) * lz.blend;
}

} // namespace planum::app::demo
