// SPDX-License-Identifier: MIT
#include "scans/registration/patch_votes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

namespace planum::scans {

namespace {

constexpr int kFewest = 6; ///< agreeing points that make a patch judgeable

struct Key {
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::int64_t z = 0;
    int facing = 0;

    friend auto operator<=>(const Key&, const Key&) = default;
};

int facing_of(const Surfel& surfel) {
    Eigen::Index axis = 0;
    surfel.normal.cwiseAbs().maxCoeff(&axis);
    return static_cast<int>(axis);
}

struct Sums {
    double weight = 0.0;
    double offset = 0.0;
    double square = 0.0;
    double precision = 0.0;
    double shares = 0.0; ///< as many points err on their own
};

void measure(PatchMap& map, std::span<const SurfelMatch> matches) {
    std::vector<Sums> sums(map.patches.size());
    for (auto& patch : map.patches) patch.agreeing = patch.disagreeing = 0;
    for (const auto& match : matches) {
        if (match.kind == MatchKind::None) continue;
        const auto at = map.patch_of[match.target];
        if (match.kind == MatchKind::Disagree) {
            ++map.patches[at].disagreeing;
            continue;
        }
        ++map.patches[at].agreeing;
        const double weight = match.weight * match.share;
        sums[at].weight += weight;
        sums[at].offset += weight * match.offset;
        sums[at].square += weight * match.offset * match.offset;
        sums[at].shares += match.share;
        sums[at].precision += match.weight / match.variance;
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        Patch& patch = map.patches[i];
        if (patch.agreeing == 0) continue;
        patch.offset = sums[i].offset / sums[i].weight;
        const double variance = std::max(0.0, sums[i].square / sums[i].weight - patch.offset * patch.offset);
        patch.stated = std::sqrt(1.0 / sums[i].precision);
        patch.sigma = std::max(patch.stated, std::sqrt(variance / std::max(1.0, sums[i].shares - 1.0)));
    }
}

/// A mean of several points or patches, and the variance that they explain.
struct Offset {
    double mean = 0.0;     ///< [m]
    double variance = 0.0; ///< [m²]
};

// Scatter beyond what is explained: such that half of the votes have offsets as small as chance makes half of them.
// Counted by weight, for what has most of it decides the pose.
double scatter_between(const std::vector<Offset>& offsets) {
    constexpr double kLeast = 2e-5;         ///< [m]; nobody's ground is better than that
    constexpr double kMost = 0.1;           ///< [m]
    constexpr double kMedianOfChi = 0.4549; // median of χ² with one degree of freedom
    const auto is_enough = [&](double scatter) {
        std::vector<std::pair<double, double>> squares; // with its weight
        double sum = 0.0;
        squares.reserve(offsets.size());
        for (const auto& o : offsets) {
            const double variance = o.variance + scatter * scatter;
            squares.emplace_back(o.mean * o.mean / variance, 1.0 / variance);
            sum += 1.0 / variance;
        }
        std::sort(squares.begin(), squares.end());
        double below = 0.0;
        for (const auto& [square, weight] : squares) {
            if (square >= kMedianOfChi) break;
            below += weight;
        }
        return below >= 0.5 * sum;
    };
    double low = kLeast;
    double high = kMost;
    if (is_enough(low)) return low;
    while (high > 1.01 * low) {
        const double middle = std::sqrt(low * high);
        (is_enough(middle) ? high : low) = middle;
    }
    return high;
}

double between_patches(const PatchMap& map) {
    std::vector<Offset> offsets;
    for (const auto& patch : map.patches) {
        if (patch.agreeing >= kFewest) offsets.push_back({patch.offset, patch.sigma * patch.sigma});
    }
    return scatter_between(offsets);
}

/// The offsets of whole blocks, from the patches that are stable.
std::vector<Offset> block_offsets(const PatchMap& map, double between) {
    std::vector<Offset> blocks(map.blocks);
    std::vector<double> precision(map.blocks, 0.0);
    for (std::size_t i = 0; i < map.patches.size(); ++i) {
        const Patch& patch = map.patches[i];
        if (patch.state != PatchState::Stable) continue;
        const double weight = 1.0 / (patch.sigma * patch.sigma + between * between);
        precision[map.block_of[i]] += weight;
        blocks[map.block_of[i]].mean += weight * patch.offset;
    }
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        if (precision[b] <= 0.0) continue;
        blocks[b].mean /= precision[b];
        blocks[b].variance = 1.0 / precision[b];
    }
    return blocks;
}

/// Blocks of which a good part lies a little off: shown by single patches, or by all of them together.
std::vector<bool> crept_blocks(const PatchMap& map, const std::vector<Offset>& blocks, double scatter) {
    constexpr double kGate = 3.0;        // standard deviations
    constexpr double kShiftedPart = 0.2; // of the patches; by chance three of a thousand are off
    constexpr int kShiftedPatches = 3;
    std::vector<int> shifted(map.blocks, 0);
    std::vector<int> stable(map.blocks, 0);
    for (std::size_t i = 0; i < map.patches.size(); ++i) {
        shifted[map.block_of[i]] += map.patches[i].state == PatchState::Shifted ? 1 : 0;
        stable[map.block_of[i]] += map.patches[i].state == PatchState::Stable ? 1 : 0;
    }
    std::vector<bool> is_crept(map.blocks, false);
    for (std::size_t b = 0; b < map.blocks; ++b) {
        const double sigma = std::sqrt(blocks[b].variance + scatter * scatter);
        const bool is_off = blocks[b].variance > 0.0 && std::abs(blocks[b].mean) > kGate * sigma;
        is_crept[b] = is_off || (shifted[b] >= kShiftedPatches && shifted[b] > kShiftedPart * (shifted[b] + stable[b]));
    }
    return is_crept;
}

// Of ground that both scans see, less than this would vote: then it did not creep here and there, but a scan is bent,
// as one is that was taken while the scanner drove. Simulated digs and the real trench keep 79 % and more.
constexpr double kLeastVoting = 2.0 / 3.0;
// Bent scans of one place agree by most pieces, those of two places only here and there: bent ones keep 59 % and more.
constexpr double kLeastStable = 0.5;

bool is_bent(const PatchMap& map, const std::vector<bool>& is_silent) {
    std::size_t judged = 0;
    std::size_t common = 0;
    std::size_t stable = 0;
    std::size_t voting = 0;
    for (std::size_t i = 0; i < map.patches.size(); ++i) {
        const PatchState state = map.patches[i].state;
        judged += state != PatchState::Thin ? 1U : 0U;
        common += state == PatchState::Stable || state == PatchState::Shifted ? 1U : 0U;
        stable += state == PatchState::Stable ? 1U : 0U;
        voting += state == PatchState::Stable && !is_silent[map.block_of[i]] ? 1U : 0U;
    }
    const auto share = [](std::size_t part, std::size_t whole) {
        return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
    };
    return share(voting, common) < kLeastVoting && share(stable, judged) >= kLeastStable;
}

// What one patch alone does not show: ground that leans or creeps together, as beside a heap that grew. Such change has
// no edge; where it becomes too little to be seen it is still there, so the blocks around do not vote either. All or
// nothing: a weight that fell with the offset would make the votes look surer than they are.
void judge_blocks(PatchMap& map, double between, BentScans bent) {
    const std::vector<Offset> blocks = block_offsets(map, between);
    std::vector<Offset> voting;
    std::copy_if(blocks.begin(), blocks.end(), std::back_inserter(voting),
                 [](const Offset& block) { return block.variance > 0.0; });
    const double scatter = scatter_between(voting);
    const std::vector<bool> is_crept = crept_blocks(map, blocks, scatter);
    std::vector<bool> is_silent = is_crept;
    for (std::size_t b = 0; b < map.blocks; ++b) {
        for (const auto beside : map.beside[b]) is_silent[b] = is_silent[b] || is_crept[beside];
    }
    map.is_bent = is_bent(map, is_silent);
    if (map.is_bent && bent == BentScans::VoteWhole) return;
    for (std::size_t i = 0; i < map.patches.size(); ++i) {
        Patch& patch = map.patches[i];
        if (patch.state != PatchState::Stable) continue;
        const Offset& block = blocks[map.block_of[i]];
        const bool is_off = is_silent[map.block_of[i]];
        if (is_off) patch.state = PatchState::Shifted;
        patch.weight *= is_off ? 0.0 : block.variance / (block.variance + scatter * scatter);
    }
}

void find_neighbours(PatchMap& map, const std::map<Key, std::uint32_t>& number) {
    map.beside.resize(map.blocks);
    for (const auto& [key, block] : number) {
        for (std::int64_t x = key.x - 1; x <= key.x + 1; ++x) {
            for (std::int64_t y = key.y - 1; y <= key.y + 1; ++y) {
                for (std::int64_t z = key.z - 1; z <= key.z + 1; ++z) {
                    const auto it = number.find({x, y, z, key.facing});
                    if (it != number.end() && it->second != block) map.beside[block].push_back(it->second);
                }
            }
        }
    }
}

constexpr int kLevels = 3; ///< of patch sizes, each twice the one before; the largest is a block

/// The cube of that level that the place lies in.
Key key_at(const Surfel& surfel, double edge, int level) {
    const double size = edge * (1 << level);
    const auto cell = [&](Eigen::Index axis) {
        return static_cast<std::int64_t>(std::floor(surfel.position[axis] / size));
    };
    return {cell(0), cell(1), cell(2), facing_of(surfel)};
}

/// The surfels of one patch.
struct Cell {
    Key key;
    int level = 0;
    std::vector<std::uint32_t> surfels;
};

// Far from the scanner a small piece holds too few points to be judged, and walls, which alone decide the shifts, are
// often far. There the pieces are larger: what is too few at one size goes on to the next.
std::vector<Cell> cells_of(const SurfelCloud& target, double edge) {
    constexpr int kEnough = 12; // twice what a patch needs, for not all will agree
    std::vector<Cell> cells;
    std::vector<std::uint32_t> left(target.surfels.size());
    std::iota(left.begin(), left.end(), 0U);
    for (int level = 0; level < kLevels; ++level) {
        std::vector<std::pair<Key, std::uint32_t>> keyed;
        keyed.reserve(left.size());
        for (const auto i : left) keyed.emplace_back(key_at(target.surfels[i], edge, level), i);
        std::sort(keyed.begin(), keyed.end());
        left.clear();
        for (std::size_t i = 0; i < keyed.size();) {
            Cell cell{keyed[i].first, level, {}};
            int flat = 0;
            for (; i < keyed.size() && keyed[i].first == cell.key; ++i) {
                cell.surfels.push_back(keyed[i].second);
                flat += target.surfels[keyed[i].second].is_flat ? 1 : 0;
            }
            if (flat >= kEnough || level + 1 == kLevels) {
                cells.push_back(std::move(cell));
            } else {
                left.insert(left.end(), cell.surfels.begin(), cell.surfels.end());
            }
        }
    }
    return cells;
}

// Numbers the blocks in the order of their first patch.
void gather_blocks(PatchMap& map, const std::vector<Cell>& cells) {
    std::map<Key, std::uint32_t> number;
    map.block_of.reserve(cells.size());
    for (const auto& [key, level, surfels] : cells) {
        const int up = kLevels - 1 - level; // shifting right rounds down, below nothing too
        const Key whole{key.x >> up, key.y >> up, key.z >> up, key.facing};
        map.block_of.push_back(number.try_emplace(whole, static_cast<std::uint32_t>(number.size())).first->second);
    }
    map.blocks = number.size();
    find_neighbours(map, number);
}

} // namespace

std::string_view to_word(PatchState state) noexcept {
    switch (state) {
    case PatchState::Stable: return "stable";
    case PatchState::Changed: return "changed";
    case PatchState::Shifted: return "shifted";
    case PatchState::Thin: return "thin";
    }
    return "thin";
}

PatchMap make_patches(const SurfelCloud& target, double edge) {
    const std::vector<Cell> cells = cells_of(target, edge);
    PatchMap map;
    map.patch_of.resize(target.surfels.size());
    for (const auto& cell : cells) {
        Patch patch;
        for (const auto i : cell.surfels) {
            patch.center += target.surfels[i].position;
            map.patch_of[i] = static_cast<std::uint32_t>(map.patches.size());
        }
        patch.center /= static_cast<double>(cell.surfels.size());
        map.patches.push_back(patch);
    }
    gather_blocks(map, cells);
    return map;
}

double judge_patches(PatchMap& map, std::span<const SurfelMatch> matches, BentScans bent) {
    measure(map, matches);
    const double between = between_patches(map);
    for (auto& patch : map.patches) {
        const double share = patch.agreeing + patch.disagreeing == 0
                                 ? 0.0
                                 : static_cast<double>(patch.agreeing) / (patch.agreeing + patch.disagreeing);
        const double sigma = std::hypot(patch.sigma, between);
        patch.weight = 0.0;
        if (patch.agreeing + patch.disagreeing < kFewest) {
            patch.state = PatchState::Thin;
        } else if (share < 0.6) {
            patch.state = PatchState::Changed;
        } else if (patch.agreeing < kFewest) {
            patch.state = PatchState::Thin;
        } else if (std::abs(patch.offset) > 3.0 * sigma) {
            patch.state = PatchState::Shifted;
        } else {
            patch.state = PatchState::Stable;
            // Points with the common error `between` and the scatter seen together weigh 1/sigma², whatever
            // they state themselves.
            patch.weight = share * share * patch.stated * patch.stated / (sigma * sigma);
        }
    }
    judge_blocks(map, between, bent);
    return between;
}

std::vector<double> weights_of(const PatchMap& map) {
    std::vector<double> weights;
    weights.reserve(map.patches.size());
    for (const auto& patch : map.patches) weights.push_back(patch.weight);
    return weights;
}

} // namespace planum::scans
