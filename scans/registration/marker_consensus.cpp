// SPDX-License-Identifier: MIT
#include "scans/registration/marker_consensus.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

namespace planum::scans {

namespace {

using Points = std::span<const Eigen::Vector3d>;
using Members = std::vector<std::size_t>;

constexpr std::size_t kAllSubsetsUpTo = 12;
constexpr std::size_t kMaxTriples = 20000;

// The value χ² exceeds in one of a thousand cases (Wilson and Hilferty 1931).
double chi_square_limit(double degrees) {
    constexpr double kNormal = 3.0902;
    const double part = 2.0 / (9.0 * degrees);
    return degrees * std::pow(1.0 - part + kNormal * std::sqrt(part), 3.0);
}

class Search {
  public:
    Search(Points x_in_scan, Points x_in_site, double sigma)
        : x_in_scan_(x_in_scan), x_in_site_(x_in_site), sigma_(sigma) {}

    void try_all_subsets() {
        const std::size_t n = x_in_scan_.size();
        for (std::size_t size = n; size >= 3 && result.agreeing.empty(); --size) {
            for (std::uint32_t bits = 0; bits < (1U << n); ++bits) {
                if (static_cast<std::size_t>(std::popcount(bits)) != size) continue;
                Members members;
                for (std::size_t i = 0; i < n; ++i) {
                    if (((bits >> i) & 1U) != 0) members.push_back(i);
                }
                if (auto set = fit(members); set && agrees(*set)) result.agreeing.push_back(std::move(*set));
            }
        }
    }

    void try_triples() {
        const std::size_t n = x_in_scan_.size();
        const std::size_t all = n * (n - 1) * (n - 2) / 6;
        const std::size_t every = (all + kMaxTriples - 1) / kMaxTriples;
        std::size_t count = 0;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = i + 1; j < n; ++j) {
                for (std::size_t k = j + 1; k < n; ++k) {
                    if (count++ % every == 0) grow({i, j, k});
                }
            }
        }
    }

    MarkerConsensus result;

  private:
    // Nothing if the set lies on a line.
    std::optional<MarkerSet> fit(const Members& members) {
        std::vector<Eigen::Vector3d> source;
        std::vector<Eigen::Vector3d> target;
        for (const auto i : members) {
            source.push_back(x_in_scan_[i]);
            target.push_back(x_in_site_[i]);
        }
        const std::vector<double> weights(members.size(), 1.0 / (sigma_ * sigma_));
        MarkerSet set{members, geometry::fit_rigid(source, target, weights), 0.0};
        if (is_nearly_a_line(set.fit, sigma_)) return std::nullopt;
        result.any_spread = true;
        const double scaled = set.fit.rms / sigma_;
        set.chi_square = scaled * scaled * static_cast<double>(members.size());
        return set;
    }

    static bool agrees(const MarkerSet& set) {
        return set.chi_square <= chi_square_limit(3.0 * static_cast<double>(set.members.size()) - 6.0);
    }

    // Takes in what lies near the pose of the triple, then drops the worst until the rest agrees.
    void grow(const Members& triple) {
        auto set = fit(triple);
        if (!set || !agrees(*set)) return;
        for (int round = 0; round < 3; ++round) {
            Members near;
            for (std::size_t i = 0; i < x_in_scan_.size(); ++i) {
                if (distance(*set, i) < 8.0 * sigma_) near.push_back(i);
            }
            if (near.size() < 3) return;
            set = fit(near);
            if (!set) return;
        }
        while (!agrees(*set)) {
            Members fewer = set->members;
            fewer.erase(std::max_element(fewer.begin(), fewer.end(), [&](std::size_t a, std::size_t b) {
                return distance(*set, a) < distance(*set, b);
            }));
            if (fewer.size() < 3) return;
            set = fit(fewer);
            if (!set) return;
        }
        keep(std::move(*set));
    }

    double distance(const MarkerSet& set, std::size_t i) const {
        return (set.fit.target_from_source * x_in_scan_[i] - x_in_site_[i]).norm();
    }

    void keep(MarkerSet set) {
        auto& sets = result.agreeing;
        if (!sets.empty() && sets.front().members.size() > set.members.size()) return;
        if (!sets.empty() && sets.front().members.size() < set.members.size()) sets.clear();
        for (const auto& known : sets) {
            if (known.members == set.members) return;
        }
        sets.push_back(std::move(set));
    }

    Points x_in_scan_;
    Points x_in_site_;
    double sigma_;
};

} // namespace

bool is_nearly_a_line(const geometry::RigidFit& fit, double sigma) {
    return fit.spread[1] < std::max(20.0 * sigma, 0.02 * fit.spread[0]);
}

MarkerConsensus agreeing_markers(Points x_in_scan, Points x_in_site, double sigma) {
    Search search(x_in_scan, x_in_site, sigma);
    if (x_in_scan.size() <= kAllSubsetsUpTo) {
        search.try_all_subsets();
    } else {
        search.try_triples();
    }
    auto& sets = search.result.agreeing;
    std::stable_sort(sets.begin(), sets.end(),
                     [](const MarkerSet& a, const MarkerSet& b) { return a.chi_square < b.chi_square; });
    return std::move(search.result);
}

} // namespace planum::scans
