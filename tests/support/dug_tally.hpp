// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/demo/simulator.hpp"
#include "app/surfaces/dug_earth.hpp"

namespace planum::test {

/// A volume that was told, beside the true one.
struct ToldVolume {
    std::string of;     ///< the surface after the digging, or the number of a unit
    double dug = 0.0;   ///< the truth [m³]
    double told = 0.0;  ///< [m³]
    double bound = 0.0; ///< stated, 95 % [m³]

    [[nodiscard]] double error() const noexcept { return told - dug; }
};

/// How told volumes compare with true ones.
struct DugTally {
    std::size_t volumes = 0;
    std::size_t near = 0;     ///< within 1.5 % of the truth
    std::size_t within = 0;   ///< of the truth by no more than their bound
    std::size_t narrow = 0;   ///< whose bound is no more than 5 % or 0.05 m³
    double worst_share = 0.0; ///< largest error, as a share of the truth

    DugTally& operator+=(const ToldVolume& volume);
    DugTally& operator+=(const DugTally& other);
    void print(const std::string& name) const;
};

/// Volumes told of a simulated dig.
struct DugVolumesTold {
    ToldVolume total;              ///< over all steps
    std::vector<ToldVolume> days;  ///< all earth that went, from under overhangs too
    std::vector<ToldVolume> bare;  ///< the same days, by how much the ground that lay bare sank: what heights show
    std::vector<ToldVolume> units; ///< over all steps: by how much the ground sank where the unit lay bare
};

[[nodiscard]] DugVolumesTold compare_volumes(const app::demo::DemoDig& dig, const app::EarthReport& report);

} // namespace planum::test
