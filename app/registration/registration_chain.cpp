// SPDX-License-Identifier: MIT
#include "app/registration/registration_chain.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "app/registration/scan_shelf.hpp"
#include "core/base/text.hpp"
#include "core/base/whole_progress.hpp"
#include "scans/registration/coarse_alignment.hpp"
#include "scans/registration/pair_selection.hpp"

namespace planum::app {

using geometry::Matrix6;
using geometry::Rigid3;

namespace {

constexpr double kFarthestPair = 40.0; ///< between stations, where start values and not features say that they meet [m]

/// Files say where they stand in poses that mean something only if they differ from nothing.
std::optional<Rigid3> header_pose(const model::Scan& scan) {
    if (!scan.header_pose) return std::nullopt;
    const Rigid3 pose = geometry::from_row_major(*scan.header_pose);
    if (pose == Rigid3{}) return std::nullopt;
    return pose;
}

/// A pair that may be linked, with where features or start values put it.
struct Candidate {
    scans::PairCandidate pair;
    Rigid3 start; ///< target_from_source
    Matrix6 covariance = Matrix6::Zero();
    int matches = 0;
    int inliers = 0;
    double rms = 0.0;
    std::string verdict;
    bool is_tried = false;
};

/// When each part is through, as a share of the time that all takes; measured on small digs.
constexpr double kFeaturesFound = 0.05;
constexpr double kMatched = 0.1;
constexpr double kAligned = 0.97;

class Chain {
  public:
    Chain(const ChainInput& input, const RegisterOptions& options, WholeProgress& progress)
        : input_(input), options_(options), progress_(progress),
          shelf_(input.project, scans_of(input), fine_options_, progress) {
        result_.scans.resize(input.scans.size());
    }

    ChainResult run() {
        place_by_markers();
        if (options_.method != RegisterMethod::Markers) {
            if (options_.method != RegisterMethod::Icp) match_features();
            add_candidates_from_starts();
            progress_.part(kAligned);
            link();
        }
        progress_.part(1.0, 3);
        solve();
        explain();
        return std::move(result_);
    }

  private:
    static std::vector<model::Scan> scans_of(const ChainInput& input) {
        std::vector<model::Scan> scans;
        for (const auto& scan : input.scans) scans.push_back(scan.scan);
        return scans;
    }

    void place_by_markers() {
        for (std::size_t i = 0; i < input_.scans.size(); ++i) {
            const ChainScan& scan = input_.scans[i];
            if (scan.markers.empty()) continue;
            result_.scans[i].markers = scans::place_by_markers(input_.survey, scan.markers);
        }
    }

    /// Where a scan stands before anything was aligned.
    [[nodiscard]] std::optional<Rigid3> start_of(std::size_t i) const {
        const ChainScan& scan = input_.scans[i];
        if (!scan.is_asked) return scan.accepted->site_from_scan;
        if (result_.scans[i].markers.is_placed) return result_.scans[i].markers.site_from_scan;
        if (options_.method != RegisterMethod::Icp) return std::nullopt;
        if (scan.accepted) return scan.accepted->site_from_scan;
        return header_pose(scan.scan);
    }

    [[nodiscard]] bool is_of_interest(std::size_t a, std::size_t b) const {
        return input_.scans[a].is_asked || input_.scans[b].is_asked;
    }

    void match_features() {
        std::vector<std::size_t> all(input_.scans.size());
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
        progress_.part(kFeaturesFound);
        shelf_.make_features(all);
        progress_.part(kMatched);
        scans::CoarseOptions coarse;
        coarse.seed = options_.seed;
        for (std::size_t a = 0; a < all.size(); ++a) {
            progress_.fraction(static_cast<double>(a) / static_cast<double>(all.size()));
            for (std::size_t b = a + 1; b < all.size(); ++b) {
                if (!is_of_interest(a, b)) continue;
                progress_.check();
                ++result_.pairs_tried;
                const auto found = scans::align_coarsely(shelf_.features(a), shelf_.features(b), coarse);
                best_inliers_[a] = std::max(best_inliers_[a], found.inliers);
                best_inliers_[b] = std::max(best_inliers_[b], found.inliers);
                if (!found.is_accepted) continue;
                candidates_.push_back({{a, b, static_cast<double>(found.inliers)},
                                       found.target_from_source,
                                       found.covariance,
                                       found.matches,
                                       found.inliers,
                                       found.rms,
                                       found.verdict});
            }
        }
    }

    void add_candidates_from_starts() {
        for (std::size_t a = 0; a < input_.scans.size(); ++a) {
            const auto from = start_of(a);
            for (std::size_t b = a + 1; from && b < input_.scans.size(); ++b) {
                const auto to = start_of(b);
                if (!to || !is_of_interest(a, b) || has_candidate(a, b)) continue;
                const double distance = (from->translation - to->translation).norm();
                if (distance > kFarthestPair) continue;
                Candidate candidate;
                candidate.pair = {a, b, 1.0 / (1.0 + distance)};
                candidate.start = from->inverse() * *to;
                candidates_.push_back(std::move(candidate));
            }
        }
    }

    [[nodiscard]] bool has_candidate(std::size_t a, std::size_t b) const {
        return std::any_of(candidates_.begin(), candidates_.end(),
                           [&](const Candidate& c) { return c.pair.target == a && c.pair.source == b; });
    }

    /// Scans whose place is known: paths to them shall be short.
    [[nodiscard]] std::vector<std::size_t> hubs() const {
        std::vector<std::size_t> hubs;
        for (std::size_t i = 0; i < input_.scans.size(); ++i) {
            if (!input_.scans[i].is_asked || result_.scans[i].markers.is_placed || input_.scans[i].is_origin) {
                hubs.push_back(i);
            }
        }
        return hubs;
    }

    void link() {
        std::vector<scans::PairCandidate> pairs;
        for (const auto& candidate : candidates_) pairs.push_back(candidate.pair);
        try_all(scans::select_pairs(pairs, input_.scans.size(), options_.links_per_scan, hubs()));
        // What a refused link leaves apart may hang together by others.
        for (;;) {
            std::vector<scans::PairCandidate> used;
            for (const auto& link : result_.links) {
                if (link.is_used) used.push_back({link.target, link.source, 0.0});
            }
            const auto part = scans::connected_parts(used, input_.scans.size());
            pairs.clear();
            for (const auto& candidate : candidates_) {
                const auto& pair = candidate.pair;
                if (!candidate.is_tried && part[pair.target] != part[pair.source]) pairs.push_back(pair);
            }
            if (pairs.empty()) break;
            try_all(scans::select_pairs(pairs, input_.scans.size(), 0, {}));
        }
        std::sort(result_.links.begin(), result_.links.end(), [](const ChainLink& a, const ChainLink& b) {
            return std::tuple(a.target, a.source) < std::tuple(b.target, b.source);
        });
    }

    void try_all(const std::vector<scans::PairCandidate>& pairs) {
        WholeProgress whole(progress_, fmt::format("aligning {} pairs of scans", pairs.size()));
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            whole.part(static_cast<double>(i + 1) / static_cast<double>(pairs.size()), 3);
            const auto it = std::find_if(candidates_.begin(), candidates_.end(),
                                         [&](const Candidate& c) { return c.pair == pairs[i]; });
            if (it->is_tried) continue;
            it->is_tried = true;
            result_.links.push_back(options_.method == RegisterMethod::Features ? coarse_link(*it)
                                                                                : fine_link(*it, whole));
        }
    }

    static ChainLink coarse_link(const Candidate& candidate) {
        ChainLink link;
        link.target = candidate.pair.target;
        link.source = candidate.pair.source;
        link.target_from_source = candidate.start;
        link.covariance = candidate.covariance;
        link.is_coarse = true;
        link.matches = candidate.matches;
        link.inliers = candidate.inliers;
        link.rms = candidate.rms;
        link.is_used = candidate.inliers > 0;
        link.verdict = candidate.verdict;
        return link;
    }

    ChainLink fine_link(const Candidate& candidate, Progress& progress) {
        ChainLink link = coarse_link(candidate);
        link.is_coarse = false;
        const auto target = shelf_.prepared(link.target, progress);
        const auto source = shelf_.prepared(link.source, progress);
        scans::FineResult fine = scans::align_scans(*target, *source, candidate.start, fine_options_, progress);
        link.is_used = fine.is_accepted;
        link.verdict = fine.verdict;
        link.rms = fine.rms;
        link.overlap = fine.overlap;
        link.patches = std::move(fine.patches);
        if (!fine.is_accepted) return link;
        link.target_from_source = fine.target_from_source;
        link.covariance = fine.covariance;
        return link;
    }

    [[nodiscard]] std::vector<scans::NetworkAnchor> anchors() const {
        std::vector<scans::NetworkAnchor> anchors;
        for (std::size_t i = 0; i < input_.scans.size(); ++i) {
            const ChainScan& scan = input_.scans[i];
            const auto& markers = result_.scans[i].markers;
            if (!scan.is_asked) {
                anchors.push_back({i, scan.accepted->site_from_scan, scan.accepted->covariance, true});
            } else if (scan.is_origin) {
                anchors.push_back({i, header_pose(scan.scan).value_or(Rigid3{}), Matrix6::Zero(), true});
            } else if (markers.is_placed) {
                anchors.push_back({i, markers.site_from_scan, markers.covariance, false});
            }
        }
        return anchors;
    }

    void solve() {
        std::vector<scans::NetworkLink> links;
        std::vector<std::size_t> of_link;
        for (std::size_t i = 0; i < result_.links.size(); ++i) {
            const ChainLink& link = result_.links[i];
            if (!link.is_used) continue;
            links.push_back({link.target, link.source, link.target_from_source, link.covariance});
            of_link.push_back(i);
        }
        const auto known = anchors();
        const auto solved = scans::solve_network(input_.scans.size(), links, known, {}, progress_);
        for (std::size_t i = 0; i < links.size(); ++i) {
            ChainLink& link = result_.links[of_link[i]];
            link.check = solved.links[i];
            link.is_used = solved.links[i].is_used;
            if (!link.is_used) link.verdict = "left out: " + solved.links[i].reason;
            if (link.is_used) note_link(link);
        }
        for (std::size_t i = 0; i < known.size(); ++i) {
            ChainScanResult& scan = result_.scans[known[i].scan];
            scan.anchored_by_markers = !known[i].is_held && solved.anchors[i].is_used;
            scan.anchor_doubt = solved.anchors[i].reason;
        }
        for (std::size_t i = 0; i < input_.scans.size(); ++i) {
            result_.scans[i].pose = solved.poses[i];
            if (result_.scans[i].links == 0) result_.scans[i].rms = result_.scans[i].markers.rms;
        }
    }

    void note_link(const ChainLink& link) {
        for (const std::size_t end : {link.target, link.source}) {
            ChainScanResult& scan = result_.scans[end];
            ++scan.links;
            scan.by_features_only = link.is_coarse;
            if (link.overlap < scan.overlap && scan.links > 1) continue;
            scan.overlap = link.overlap;
            scan.rms = link.rms;
        }
    }

    void explain() {
        const bool has_anchor = std::any_of(result_.scans.begin(), result_.scans.end(),
                                            [](const ChainScanResult& scan) { return scan.pose.has_value(); });
        if (!has_anchor) {
            result_.notes.push_back("nothing says where the site grid is: import the markers of one scan at least "
                                    "(planum markers import), or name a scan whose own frame is the grid (--origin)");
        }
        for (std::size_t i = 0; i < input_.scans.size(); ++i) {
            if (!result_.scans[i].pose) result_.scans[i].why_not = reason_of(i);
        }
    }

    [[nodiscard]] std::string reason_of(std::size_t i) const {
        const ChainScanResult& scan = result_.scans[i];
        std::vector<std::string> reasons;
        if (input_.scans[i].scan.points == 0) return "not placed: the scan has no points";
        if (!input_.scans[i].markers.empty()) reasons.push_back("its markers: " + scan.markers.verdict);
        if (options_.method == RegisterMethod::Markers) {
            if (input_.scans[i].markers.empty()) reasons.emplace_back("no markers were measured in it");
        } else if (scan.links > 0) {
            reasons.push_back(fmt::format(
                "it hangs together with {}, but nothing says where these are on the site grid", neighbour_of(i)));
        } else {
            reasons.push_back(best_refusal(i));
        }
        return "not placed: " + text::join(reasons, "; ");
    }

    [[nodiscard]] std::string neighbour_of(std::size_t i) const {
        for (const auto& link : result_.links) {
            if (!link.is_used) continue;
            if (link.target == i) return input_.scans[link.source].scan.name;
            if (link.source == i) return input_.scans[link.target].scan.name;
        }
        return "others";
    }

    /// Why the link that promised most was refused.
    [[nodiscard]] std::string best_refusal(std::size_t i) const {
        const ChainLink* best = nullptr;
        for (const auto& link : result_.links) {
            if (link.target != i && link.source != i) continue;
            if (best == nullptr || link.inliers > best->inliers) best = &link;
        }
        if (best != nullptr) {
            const std::size_t other = best->target == i ? best->source : best->target;
            return fmt::format("with {} {}", input_.scans[other].scan.name, best->verdict);
        }
        if (options_.method == RegisterMethod::Icp) return "no start value near that of another scan";
        const auto it = best_inliers_.find(i);
        return fmt::format("it shares too little with the other scans: at best {} places look alike and lie the same "
                           "way to each other",
                           it == best_inliers_.end() ? 0 : it->second);
    }

    const ChainInput& input_;
    const RegisterOptions& options_;
    WholeProgress& progress_;
    scans::FineOptions fine_options_;
    ScanShelf shelf_;
    std::vector<Candidate> candidates_;
    std::map<std::size_t, int> best_inliers_;
    ChainResult result_;
};

} // namespace

ChainResult run_chain(const ChainInput& input, const RegisterOptions& options, Progress& progress) {
    WholeProgress whole(progress, fmt::format("registering {} scans", input.scans.size()));
    return Chain(input, options, whole).run();
}

} // namespace planum::app
