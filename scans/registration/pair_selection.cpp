// SPDX-License-Identifier: MIT
#include "scans/registration/pair_selection.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace planum::scans {

namespace {

/// Union-find whose representative is the smallest member.
class Parts {
  public:
    explicit Parts(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

    std::size_t find(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    bool join(std::size_t a, std::size_t b) {
        a = find(a);
        b = find(b);
        if (a == b) return false;
        parent_[std::max(a, b)] = std::min(a, b);
        return true;
    }

  private:
    std::vector<std::size_t> parent_;
};

} // namespace

std::vector<PairCandidate> select_pairs(std::span<const PairCandidate> candidates, std::size_t scans,
                                        std::size_t links_per_scan, std::span<const std::size_t> hubs) {
    std::vector<PairCandidate> sorted(candidates.begin(), candidates.end());
    std::sort(sorted.begin(), sorted.end(), [](const PairCandidate& a, const PairCandidate& b) {
        return std::tuple(-a.promise, a.target, a.source) < std::tuple(-b.promise, b.target, b.source);
    });
    std::vector<bool> is_taken(sorted.size(), false);
    std::vector<std::size_t> links(scans, 0);
    std::vector<bool> is_hub(scans, false);
    for (const std::size_t hub : hubs) is_hub[hub] = true;
    const auto take = [&](std::size_t i) {
        is_taken[i] = true;
        ++links[sorted[i].target];
        ++links[sorted[i].source];
    };
    Parts parts(scans);
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        if (parts.join(sorted[i].target, sorted[i].source)) take(i);
    }
    std::vector<std::size_t> to_hubs(scans, 0);
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const auto& [target, source, promise] = sorted[i];
        if (is_taken[i] || is_hub[target] == is_hub[source]) continue;
        const std::size_t other = is_hub[target] ? source : target;
        if (to_hubs[other] >= links_per_scan / 2) continue;
        ++to_hubs[other];
        take(i);
    }
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const bool wanted = links[sorted[i].target] < links_per_scan || links[sorted[i].source] < links_per_scan;
        if (!is_taken[i] && wanted) take(i);
    }
    std::vector<PairCandidate> selected;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        if (is_taken[i]) selected.push_back(sorted[i]);
    }
    std::sort(selected.begin(), selected.end(), [](const PairCandidate& a, const PairCandidate& b) {
        return std::tuple(a.target, a.source) < std::tuple(b.target, b.source);
    });
    return selected;
}

std::vector<std::size_t> connected_parts(std::span<const PairCandidate> pairs, std::size_t scans) {
    Parts parts(scans);
    for (const auto& pair : pairs) parts.join(pair.target, pair.source);
    std::vector<std::size_t> part(scans);
    for (std::size_t i = 0; i < scans; ++i) part[i] = parts.find(i);
    return part;
}

} // namespace planum::scans
