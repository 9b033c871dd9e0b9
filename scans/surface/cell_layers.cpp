// SPDX-License-Identifier: MIT
#include "scans/surface/cell_layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace planum::scans {

namespace {

constexpr std::size_t kFewScans = 64;
constexpr std::uint64_t kMostCount = 65535;

double quantile(std::span<const PackedHeight> sorted, double share) {
    const double at = share * static_cast<double>(sorted.size() - 1);
    const auto low = static_cast<std::size_t>(at);
    const std::size_t high = std::min(low + 1, sorted.size() - 1);
    const double a = height_of(sorted[low]);
    return a + (at - static_cast<double>(low)) * (height_of(sorted[high]) - a);
}

/// The first `kFewScans` scans one by one; a surface with more of them is not compared scan by scan beyond that.
struct Census {
    std::array<std::uint32_t, kFewScans> count{};
    std::array<float, kFewScans> p16{};
    std::array<float, kFewScans> median{};
    std::array<float, kFewScans> p84{};
    std::size_t end = 0; // one more than the largest scan number
};

void count_scans(std::span<const PackedHeight> sorted, Census& census) {
    for (const PackedHeight packed : sorted) {
        const std::uint16_t scan = scan_of(packed);
        if (scan >= kFewScans) continue;
        ++census.count[scan];
        census.end = std::max<std::size_t>(census.end, scan + 1U);
    }
}

// A second walk in ascending order meets the quantiles of every scan.
void take_quantiles(std::span<const PackedHeight> sorted, Census& census) {
    std::array<std::uint32_t, kFewScans> seen{};
    for (const PackedHeight packed : sorted) {
        const std::uint16_t scan = scan_of(packed);
        if (scan >= kFewScans) continue;
        const std::uint32_t n = census.count[scan] - 1;
        const std::uint32_t i = seen[scan]++;
        const auto z = static_cast<float>(height_of(packed));
        if (i == n * 4 / 25) census.p16[scan] = z;
        if (i == n / 2) census.median[scan] = z;
        if (i == n - n * 4 / 25) census.p84[scan] = z;
    }
}

void compare_scans(std::span<const PackedHeight> sorted, HeightLayer& layer) {
    Census census;
    count_scans(sorted, census);
    take_quantiles(sorted, census);
    for (std::size_t scan = 0; scan < census.end; ++scan) {
        if (census.count[scan] == 0) continue;
        const ScanHeight one{census.median[scan], 0.5F * (census.p84[scan] - census.p16[scan]),
                             static_cast<std::uint16_t>(scan),
                             static_cast<std::uint16_t>(std::min<std::uint64_t>(census.count[scan], kMostCount))};
        if (!(one.height >= layer.lowest.height)) layer.lowest = one;
        if (!(one.height <= layer.highest.height)) layer.highest = one;
    }
}

HeightLayer describe(std::span<const PackedHeight> sorted, const LayerRules& rules) {
    HeightLayer layer;
    layer.height = static_cast<float>(quantile(sorted, 0.5));
    layer.low = static_cast<float>(quantile(sorted, 0.1));
    layer.high = static_cast<float>(quantile(sorted, 0.9));
    layer.spread = static_cast<float>(0.5 * (quantile(sorted, 0.84) - quantile(sorted, 0.16)));
    layer.count = static_cast<std::uint16_t>(std::min<std::uint64_t>(sorted.size(), kMostCount));
    layer.wide = static_cast<double>(layer.high) - static_cast<double>(layer.low) > rules.extent;
    for (const PackedHeight packed : sorted) layer.scans |= mask_of(scan_of(packed));
    if ((layer.scans & (layer.scans - 1)) != 0 || layer.scans >> kLastMaskBit != 0) compare_scans(sorted, layer);
    return layer;
}

/// Where a wide run is to be cut because one scan sees only its lower end; the size of the run when it is not.
std::size_t cut_above_ground(std::span<const PackedHeight> run, const LayerRules& rules) {
    const double ground = height_of(run[run.size() / 50]); // a stray below counts for nothing
    const auto above = std::partition_point(
        run.begin(), run.end(), [&](PackedHeight packed) { return height_of(packed) <= ground + rules.extent; });
    Census low;
    count_scans({run.begin(), above}, low);
    Census high;
    count_scans({above, run.end()}, high);
    for (std::size_t scan = 0; scan < low.end; ++scan) {
        if (low.count[scan] >= 2 && high.count[scan] == 0) return static_cast<std::size_t>(above - run.begin());
    }
    return run.size();
}

void add_run(std::span<const PackedHeight> run, const LayerRules& rules, std::vector<HeightLayer>& layers) {
    HeightLayer layer = describe(run, rules);
    if (layer.wide) {
        const std::size_t cut = cut_above_ground(run, rules);
        if (cut > 0 && cut < run.size()) {
            layers.push_back(describe(run.first(cut), rules));
            layer = describe(run.subspan(cut), rules);
        }
    }
    layers.push_back(layer);
}

} // namespace

SidePlace side_place(std::span<const PackedHeight> sorted, const LayerRules& rules) {
    if (sorted.empty()) return {};
    double low = quantile(sorted, 0.02);
    double high = quantile(sorted, 0.98);
    if (high - low > rules.extent) {
        const double fifth = 0.2 * (high - low);
        low += fifth;
        high -= fifth;
    }
    double east = 0.0;
    double north = 0.0;
    double number = 0.0;
    for (const PackedHeight packed : sorted) {
        const double z = height_of(packed);
        if (z < low || z > high) continue;
        const auto [x, y] = place_of(packed);
        east += x;
        north += y;
        number += 1.0;
    }
    if (number == 0.0) return {};
    return {static_cast<float>(east / number), static_cast<float>(north / number)};
}

void find_layers(std::span<const PackedHeight> sorted, const LayerRules& rules, std::vector<HeightLayer>& layers) {
    const std::size_t before = layers.size();
    const auto gap = static_cast<std::uint64_t>(rules.gap / kHeightStep);
    const double least = rules.share * static_cast<double>(sorted.size());
    for (std::size_t begin = 0, i = 0; i < sorted.size(); ++i) {
        if (i + 1 < sorted.size() && steps_of(sorted[i + 1]) - steps_of(sorted[i]) <= gap) continue;
        const std::span<const PackedHeight> run = sorted.subspan(begin, i + 1 - begin);
        if (static_cast<double>(run.size()) >= least) add_run(run, rules, layers);
        begin = i + 1;
    }
    while (layers.size() - before > rules.most) {
        const auto first = layers.begin() + static_cast<std::ptrdiff_t>(before);
        layers.erase(std::min_element(first, layers.end(),
                                      [](const HeightLayer& a, const HeightLayer& b) { return a.count < b.count; }));
    }
}

} // namespace planum::scans
