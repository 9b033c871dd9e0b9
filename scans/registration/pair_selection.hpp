// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace planum::scans {

/// Two scans that may be linked, and how well that promises to go (inliers of the coarse alignment, say).
struct PairCandidate {
    std::size_t target = 0;
    std::size_t source = 0;
    double promise = 0.0;

    friend bool operator==(const PairCandidate&, const PairCandidate&) = default;
};

/// Which candidates to align finely: a spanning forest of the greatest promise, so that all that can hang together
/// does; then for every scan its most promising ones until it has `links_per_scan`, half of them with the scans of
/// `hubs`, so that paths to these stay short. Ordered by target, then source.
[[nodiscard]] std::vector<PairCandidate> select_pairs(std::span<const PairCandidate> candidates, std::size_t scans,
                                                      std::size_t links_per_scan, std::span<const std::size_t> hubs);

/// For every scan the smallest number of a scan that it hangs together with.
[[nodiscard]] std::vector<std::size_t> connected_parts(std::span<const PairCandidate> pairs, std::size_t scans);

} // namespace planum::scans
