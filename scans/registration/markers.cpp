// SPDX-License-Identifier: MIT
#include "scans/registration/markers.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "scans/registration/marker_consensus.hpp"

namespace planum::scans {

namespace {

struct Pairs {
    std::vector<std::size_t> at; ///< index into the scan's markers
    std::vector<Eigen::Vector3d> x_in_scan;
    std::vector<Eigen::Vector3d> x_in_site;
};

std::map<std::string, std::vector<const Marker*>> by_name(std::span<const Marker> markers) {
    std::map<std::string, std::vector<const Marker*>> names;
    for (const auto& marker : markers) names[marker.name].push_back(&marker);
    return names;
}

// Says in `residuals` of what cannot be paired why.
Pairs pair_by_name(std::span<const Marker> survey, std::span<const Marker> in_scan,
                   std::vector<MarkerResidual>& residuals) {
    const auto surveyed = by_name(survey);
    const auto measured = by_name(in_scan);
    Pairs pairs;
    for (std::size_t i = 0; i < in_scan.size(); ++i) {
        residuals.push_back({in_scan[i].name, false, Eigen::Vector3d::Zero(), {}});
        const auto found = surveyed.find(in_scan[i].name);
        std::string& reason = residuals.back().reason;
        if (found == surveyed.end()) {
            reason = "not in the survey";
        } else if (found->second.size() > 1) {
            reason = fmt::format("surveyed {} times: keep one", found->second.size());
        } else if (measured.at(in_scan[i].name).size() > 1) {
            reason = "measured more than once in this scan: keep one";
        } else if (!in_scan[i].position.allFinite() || !found->second.front()->position.allFinite()) {
            reason = "a coordinate is not a number";
        } else {
            pairs.at.push_back(i);
            pairs.x_in_scan.push_back(in_scan[i].position);
            pairs.x_in_site.push_back(found->second.front()->position);
        }
    }
    return pairs;
}

// Another set of the same size that says something else, beyond what the sigmas allow.
const MarkerSet* rival(const MarkerConsensus& consensus) {
    const MarkerSet& best = consensus.agreeing.front();
    for (const auto& other : consensus.agreeing) {
        const geometry::Vector6 step =
            geometry::step_between(best.fit.target_from_source, other.fit.target_from_source);
        const geometry::Vector6 limit = 5.0 * (best.fit.covariance + other.fit.covariance).diagonal().cwiseSqrt();
        if ((step.cwiseAbs().array() > limit.array()).any()) return &other;
    }
    return nullptr;
}

std::string names_of(const Pairs& pairs, std::span<const Marker> in_scan, const std::vector<std::size_t>& members) {
    std::string text;
    for (const auto m : members) text += (text.empty() ? "" : ", ") + in_scan[pairs.at[m]].name;
    return text;
}

std::string worst_distance(const Pairs& pairs) {
    double worst = 0.0;
    for (std::size_t i = 0; i < pairs.at.size(); ++i) {
        for (std::size_t j = i + 1; j < pairs.at.size(); ++j) {
            worst = std::max(worst, std::abs((pairs.x_in_scan[i] - pairs.x_in_scan[j]).norm() -
                                             (pairs.x_in_site[i] - pairs.x_in_site[j]).norm()));
        }
    }
    return fmt::format("{:.1f} mm", 1000.0 * worst);
}

// Empty if there is one answer.
std::string why_not(const Pairs& pairs, const MarkerConsensus& consensus, std::span<const Marker> in_scan) {
    if (!consensus.any_spread) {
        return "the markers lie almost on one line, which leaves the turn about it open: add one beside it";
    }
    if (consensus.agreeing.empty()) {
        const std::string apart = worst_distance(pairs);
        if (pairs.at.size() == 3) {
            return fmt::format("the three markers do not fit the survey, distances differ by up to {}, and with "
                               "three nobody can say which is wrong: measure a fourth",
                               apart);
        }
        return fmt::format("no three of the {} markers fit the survey, distances differ by up to {}: is it the "
                           "survey of this site?",
                           pairs.at.size(), apart);
    }
    if (const MarkerSet* other = rival(consensus)) {
        return fmt::format("the markers {} and the markers {} say different poses and neither set is larger: "
                           "measure them again",
                           names_of(pairs, in_scan, consensus.agreeing.front().members),
                           names_of(pairs, in_scan, other->members));
    }
    return {};
}

// The other survey point that lies where this marker was measured, or nothing.
std::string place_name(const Marker& marker, const MarkerPlacement& placement, std::span<const Marker> survey,
                       double reach) {
    const Eigen::Vector3d x_in_site = placement.site_from_scan * marker.position;
    for (const auto& other : survey) {
        if (other.name != marker.name && (other.position - x_in_site).norm() < reach) return other.name;
    }
    return {};
}

void judge_markers(MarkerPlacement& placement, const Pairs& pairs, const MarkerSet& set, std::span<const Marker> survey,
                   std::span<const Marker> in_scan, double sigma) {
    std::map<std::string, std::string> lies_at; // name written → name of the place
    for (std::size_t i = 0; i < pairs.at.size(); ++i) {
        auto& entry = placement.residuals[pairs.at[i]];
        entry.residual = placement.site_from_scan * pairs.x_in_scan[i] - pairs.x_in_site[i];
        entry.is_used = std::binary_search(set.members.begin(), set.members.end(), i);
        if (entry.is_used) continue;
        const std::string place = place_name(in_scan[pairs.at[i]], placement, survey, 10.0 * sigma);
        if (!place.empty()) lies_at[entry.name] = place;
    }
    for (const auto at : pairs.at) {
        auto& entry = placement.residuals[at];
        if (entry.is_used) continue;
        const auto here = lies_at.find(entry.name);
        if (here == lies_at.end()) {
            entry.reason = fmt::format("{:.1f} mm off its place", 1000.0 * entry.residual.norm());
            continue;
        }
        const auto there = lies_at.find(here->second);
        const bool is_swap = there != lies_at.end() && there->second == entry.name;
        entry.reason = is_swap ? fmt::format("swapped with {}", here->second)
                               : fmt::format("lies where {} was surveyed: wrong name?", here->second);
    }
}

std::string describe(const MarkerPlacement& placement) {
    std::string text = fmt::format("{} of {} markers fit with {:.1f} mm rms", placement.used,
                                   placement.residuals.size(), 1000.0 * placement.rms);
    for (const auto& entry : placement.residuals) {
        if (!entry.is_used) text += fmt::format("; {} left out: {}", entry.name, entry.reason);
    }
    return text;
}

} // namespace

MarkerPlacement place_by_markers(std::span<const Marker> survey, std::span<const Marker> in_scan,
                                 const MarkerOptions& options) {
    if (!(options.survey_sigma > 0.0) || !(options.scan_sigma > 0.0)) {
        throw Error(ErrorCode::BadInput, "sigma of the markers must be above 0");
    }
    MarkerPlacement placement;
    const Pairs pairs = pair_by_name(survey, in_scan, placement.residuals);
    if (pairs.at.size() < 3) {
        placement.verdict = fmt::format("{} of the scan's {} markers can be paired with the survey, three are needed",
                                        pairs.at.size(), in_scan.size());
        for (const auto& entry : placement.residuals) {
            if (!entry.reason.empty()) placement.verdict += fmt::format("; {}: {}", entry.name, entry.reason);
        }
        return placement;
    }
    const double sigma = std::hypot(options.survey_sigma, options.scan_sigma);
    const MarkerConsensus consensus = agreeing_markers(pairs.x_in_scan, pairs.x_in_site, sigma);
    placement.verdict = why_not(pairs, consensus, in_scan);
    if (!placement.verdict.empty()) return placement;

    const MarkerSet& set = consensus.agreeing.front();
    placement.is_placed = true;
    placement.site_from_scan = set.fit.target_from_source;
    placement.rms = set.fit.rms;
    placement.used = static_cast<int>(set.members.size());
    const double degrees = 3.0 * static_cast<double>(set.members.size()) - 6.0;
    placement.covariance = std::max(1.0, set.chi_square / degrees) * set.fit.covariance;
    judge_markers(placement, pairs, set, survey, in_scan, sigma);
    placement.verdict = describe(placement);
    return placement;
}

} // namespace planum::scans
