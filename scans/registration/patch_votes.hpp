// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "scans/registration/surfel_matching.hpp"

namespace planum::scans {

enum class PatchState : std::uint8_t {
    Stable,  ///< votes
    Changed, ///< most of it lies elsewhere now
    Shifted, ///< all of it is a little higher or lower than the rest of the ground, or it lies beside such ground
    Thin,    ///< too few points to judge
};

[[nodiscard]] std::string_view to_word(PatchState state) noexcept;

/// A piece of ground with one facing, a cube of the target's frame; the unit in which ground votes, because
/// what was dug away, moved or trodden down changes by pieces.
struct Patch {
    Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< mean of its target surfels, in target [m]
    PatchState state = PatchState::Thin;
    int agreeing = 0;
    int disagreeing = 0;
    double offset = 0.0; ///< mean signed distance [m]
    double stated = 0.0; ///< σ of offset as the surfels state it [m]
    double sigma = 0.0;  ///< of offset, from the scatter within, not below stated [m]
    double weight = 1.0; ///< of each of its points, 0…1
};

/// The patches of a target cloud.
struct PatchMap {
    std::vector<std::uint32_t> patch_of; ///< one a target surfel
    std::vector<Patch> patches;          ///< ordered by size and place
    std::vector<std::uint32_t> block_of; ///< one a patch: neighbours with one facing, several patches wide
    std::size_t blocks = 0;
    std::vector<std::vector<std::uint32_t>> beside; ///< one a block: those that touch it and face as it does
    bool is_bent = false; ///< so much of the common ground lies off by blocks that a scan is bent; see judge_patches()
};

/// What blocks of ground that lie a little off do in scans that are bent themselves.
enum class BentScans {
    VoteWhole, ///< they vote: which part of a bent scan is right nobody knows
    AsOthers   ///< they are silent, as where ground crept
};

/// Patches are cubes of the given edge [m]; where these hold too few points, of twice or four times that.
[[nodiscard]] PatchMap make_patches(const SurfelCloud& target, double edge);

/// Judges every patch from the matches of the present pose and sets its weight: nothing for ground that has
/// changed; for the rest such that a patch never counts more than the scatter between patches allows,
/// however many points it has (correlated points count once). Returns that scatter, one σ [m]. Says in `map` whether
/// the scans are bent, which changes what blocks do as `bent` tells.
double judge_patches(PatchMap& map, std::span<const SurfelMatch> matches, BentScans bent = BentScans::VoteWhole);

[[nodiscard]] std::vector<double> weights_of(const PatchMap& map);

} // namespace planum::scans
