// SPDX-License-Identifier: MIT
#include "scans/registration/patch_votes.hpp"

#include <algorithm>
#include <cmath>
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

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

struct Sums {
    double weight = 0.0;
    double offset = 0.0;
    double square = 0.0;
    double precision = 0.0;
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
        sums[at].weight += match.weight;
        sums[at].offset += match.weight * match.offset;
        sums[at].square += match.weight * match.offset * match.offset;
        sums[at].precision += match.weight / match.variance;
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        Patch& patch = map.patches[i];
        if (patch.agreeing == 0) continue;
        patch.offset = sums[i].offset / sums[i].weight;
        const double variance = std::max(0.0, sums[i].square / sums[i].weight - patch.offset * patch.offset);
        patch.stated = std::sqrt(1.0 / sums[i].precision);
        patch.sigma = std::max(patch.stated, std::sqrt(variance / std::max(1, patch.agreeing - 1)));
    }
}

// Scatter of the patches beyond what their points explain: robust, from the middle of them.
double scatter_between(const PatchMap& map) {
    constexpr double kLeast = 2e-5;         ///< [m]; nobody's ground is better than that
    constexpr double kMedianOfChi = 0.4549; // median of χ² with one degree of freedom
    std::vector<double> squares;
    std::vector<double> explained;
    for (const auto& patch : map.patches) {
        if (patch.agreeing < kFewest) continue;
        squares.push_back(patch.offset * patch.offset);
        explained.push_back(patch.sigma * patch.sigma);
    }
    const double excess = median(std::move(squares)) / kMedianOfChi - median(std::move(explained));
    return std::sqrt(std::max(excess, kLeast * kLeast));
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
    std::vector<std::pair<Key, std::uint32_t>> keyed;
    keyed.reserve(target.surfels.size());
    for (std::size_t i = 0; i < target.surfels.size(); ++i) {
        const Surfel& surfel = target.surfels[i];
        const auto cell = [&](Eigen::Index axis) {
            return static_cast<std::int64_t>(std::floor(surfel.position[axis] / edge));
        };
        keyed.push_back({{cell(0), cell(1), cell(2), facing_of(surfel)}, static_cast<std::uint32_t>(i)});
    }
    std::sort(keyed.begin(), keyed.end());
    PatchMap map;
    map.patch_of.resize(target.surfels.size());
    for (std::size_t i = 0; i < keyed.size();) {
        std::size_t end = i;
        Patch patch;
        for (; end < keyed.size() && keyed[end].first == keyed[i].first; ++end) {
            patch.center += target.surfels[keyed[end].second].position;
            map.patch_of[keyed[end].second] = static_cast<std::uint32_t>(map.patches.size());
        }
        patch.center /= static_cast<double>(end - i);
        map.patches.push_back(patch);
        i = end;
    }
    return map;
}

double judge_patches(PatchMap& map, std::span<const SurfelMatch> matches) {
    measure(map, matches);
    const double between = scatter_between(map);
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
    return between;
}

std::vector<double> weights_of(const PatchMap& map) {
    std::vector<double> weights;
    weights.reserve(map.patches.size());
    for (const auto& patch : map.patches) weights.push_back(patch.weight);
    return weights;
}

} // namespace planum::scans
