// SPDX-License-Identifier: MIT
#include "strat/layout/path_mover.hpp"

#include <algorithm>
#include <limits>

namespace planum::strat {

namespace {

constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);
constexpr std::int32_t kReach = 40;

// One crossing outweighs all ways aside: among places that cross alike the nearest is taken.
constexpr std::int64_t kCrossing = std::int64_t{1} << 24;

} // namespace

PathMover::PathMover(LayeredGraph& graph, const Adjacency& up, const Adjacency& down,
                     std::vector<std::uint32_t>& position, const std::vector<std::uint32_t>& layer)
    : g_(graph), up_(up), down_(down), position_(position), layer_(layer) {
    find_paths();
}

void PathMover::find_paths() {
    const auto inner = [&](std::uint32_t v) { return up_.row(v).size() <= 1 && down_.row(v).size() <= 1; };
    for (const std::vector<std::uint32_t>& layer : g_.layers) {
        for (const std::uint32_t v : layer) {
            if (!inner(v) || (!up_.row(v).empty() && inner(up_.row(v)[0]))) continue;
            paths_.push_back({v});
            for (std::uint32_t w = v; !down_.row(w).empty() && inner(down_.row(w)[0]);) {
                w = down_.row(w)[0];
                paths_.back().push_back(w);
            }
        }
    }
    // Longest first: the others make way more easily.
    std::stable_sort(paths_.begin(), paths_.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
}

std::int64_t PathMover::improve(std::int64_t& work, std::int64_t most_work) {
    std::int64_t saved = 0;
    for (const std::vector<std::uint32_t>& path : paths_) {
        if (work >= most_work) break;
        if (crosses(path)) saved += move(path, work);
    }
    return saved;
}

// Whether any edge of the path is crossed.
bool PathMover::crosses(const std::vector<std::uint32_t>& path) const {
    const auto edge_crosses = [&](std::uint32_t upper, std::uint32_t lower) {
        const std::vector<std::uint32_t>& layer = g_.layers[layer_[upper]];
        for (std::uint32_t i = 0; i < layer.size(); ++i) {
            if (i == position_[upper]) continue;
            for (const std::uint32_t w : down_.row(layer[i])) {
                if (w != lower && (i < position_[upper]) != (position_[w] < position_[lower])) return true;
            }
        }
        return false;
    };
    if (!up_.row(path.front()).empty() && edge_crosses(up_.row(path.front())[0], path.front())) return true;
    for (const std::uint32_t v : path) {
        if (!down_.row(v).empty() && edge_crosses(v, down_.row(v)[0])) return true;
    }
    return false;
}

// Place among the nodes of the level without the path's, held to just outside the window.
std::int32_t PathMover::place_of(std::uint32_t node, const Window& window) const {
    const auto at = static_cast<std::int32_t>(position_[node]);
    return std::clamp(at > window.own ? at - 1 : at, window.low - 1, window.high);
}

// Crossings of the edge from each gap to a node of another level that stays where it is.
void PathMover::end_costs(std::uint32_t node, std::uint32_t fixed, const Adjacency& side, const Window& window,
                          std::vector<std::int32_t>& costs) const {
    costs.assign(window.width() + 1, 0);
    const std::vector<std::uint32_t>& layer = g_.layers[layer_[node]];
    std::int32_t at_low = 0; // edges from the right half of the window to the left of the fixed node
    for (std::int32_t i = window.low; i < window.high; ++i) {
        const std::uint32_t w = layer[static_cast<std::size_t>(i < window.own ? i : i + 1)];
        for (const std::uint32_t end : side.row(w)) {
            if (end == fixed) continue;
            const bool left = position_[end] < position_[fixed];
            if (left) ++at_low;
            // Passing w, this edge no longer lies right of the gap.
            costs[static_cast<std::size_t>(i - window.low) + 1] += left ? -1 : 1;
        }
    }
    std::int32_t sum = at_low;
    for (std::int32_t& c : costs) {
        sum += c;
        c = sum;
    }
}

// Crossings of the edge from the lowest gap above to each gap below.
void PathMover::first_row(std::uint32_t upper, std::uint32_t lower, const Window& a, const Window& b) {
    row_.assign(b.width() + 1, 0);
    const std::vector<std::uint32_t>& below = g_.layers[layer_[lower]];
    std::int32_t at_low = 0;
    for (std::int32_t i = b.low; i < b.high; ++i) {
        const std::uint32_t w = below[static_cast<std::size_t>(i < b.own ? i : i + 1)];
        for (const std::uint32_t end : up_.row(w)) {
            const bool left = place_of(end, a) < a.low;
            if (left) ++at_low; // ends right of the lowest gap below
            row_[static_cast<std::size_t>(i - b.low) + 1] += left ? -1 : 1;
        }
    }
    // Edges from the window above to what lies left of the window below are crossed by every gap below.
    const std::vector<std::uint32_t>& above = g_.layers[layer_[upper]];
    for (std::int32_t i = a.low; i < a.high; ++i) {
        const std::uint32_t v = above[static_cast<std::size_t>(i < a.own ? i : i + 1)];
        for (const std::uint32_t end : down_.row(v)) at_low += place_of(end, b) < b.low ? 1 : 0;
    }
    std::int32_t sum = at_low;
    for (std::int32_t& c : row_) {
        sum += c;
        c = sum;
    }
}

// The gap above moves one place to the right, past this node.
void PathMover::next_row(std::uint32_t passed, const Window& b) {
    for (const std::uint32_t end : down_.row(passed)) {
        const std::int32_t at = place_of(end, b);
        const auto left_of = static_cast<std::size_t>(at - b.low + 1); // gaps not right of the end
        for (std::size_t q = 0; q < left_of; ++q) ++row_[q];
        for (std::size_t q = left_of; q < b.width(); ++q) --row_[q];
    }
}

// From the costs of reaching each gap of one level to those of the next. Returns the crossings of the path's
// edge as it runs now.
std::int64_t PathMover::step(std::uint32_t upper, std::uint32_t lower, const Window& a, const Window& b) {
    first_row(upper, lower, a, b);
    const std::vector<std::uint32_t>& above = g_.layers[layer_[upper]];
    std::vector<std::int32_t>& from = came_from_.emplace_back(b.width(), a.low);
    next_cost_.assign(b.width(), std::numeric_limits<std::int64_t>::max());
    std::int64_t now = 0;
    for (std::int32_t p = a.low; p <= a.high; ++p) {
        if (p > a.low) next_row(above[static_cast<std::size_t>(p - 1 < a.own ? p - 1 : p)], b);
        const std::int64_t reached = cost_[static_cast<std::size_t>(p - a.low)];
        for (std::size_t q = 0; q < b.width(); ++q) {
            const std::int64_t cost = reached + row_[q] * kCrossing;
            if (cost >= next_cost_[q]) continue;
            next_cost_[q] = cost;
            from[q] = p;
        }
        if (p == a.own) now = row_[static_cast<std::size_t>(b.own - b.low)];
    }
    for (std::int32_t q = b.low; q <= b.high; ++q) {
        next_cost_[static_cast<std::size_t>(q - b.low)] += std::abs(q - b.own);
    }
    cost_.swap(next_cost_);
    return now;
}

std::int64_t PathMover::move(const std::vector<std::uint32_t>& path, std::int64_t& work) {
    windows_.clear();
    for (const std::uint32_t v : path) {
        const auto own = static_cast<std::int32_t>(position_[v]);
        const auto last = static_cast<std::int32_t>(g_.layers[layer_[v]].size()) - 1;
        windows_.push_back({own, std::max(0, own - kReach), std::min(last, own + kReach)});
    }
    came_from_.clear();
    cost_.assign(windows_[0].width(), 0);
    std::int64_t now = 0;
    const auto own_of = [](const Window& w) { return static_cast<std::size_t>(w.own - w.low); };
    if (!up_.row(path.front()).empty()) {
        end_costs(path.front(), up_.row(path.front())[0], up_, windows_[0], ends_);
        for (std::size_t p = 0; p < cost_.size(); ++p) cost_[p] = ends_[p] * kCrossing;
        now += ends_[own_of(windows_[0])];
    }
    for (std::size_t p = 0; p < cost_.size(); ++p) {
        cost_[p] += std::abs(static_cast<std::int64_t>(p) + windows_[0].low - windows_[0].own);
    }
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        now += step(path[i], path[i + 1], windows_[i], windows_[i + 1]);
        work += static_cast<std::int64_t>(windows_[i].width() * windows_[i + 1].width());
    }
    const std::size_t last = path.size() - 1;
    if (!down_.row(path[last]).empty()) {
        end_costs(path[last], down_.row(path[last])[0], down_, windows_[last], ends_);
        for (std::size_t p = 0; p < cost_.size(); ++p) cost_[p] += ends_[p] * kCrossing;
        now += ends_[own_of(windows_[last])];
    }
    work += static_cast<std::int64_t>(windows_[last].width());
    const auto best = std::min_element(cost_.begin(), cost_.end());
    const std::int64_t saved = now - *best / kCrossing;
    if (saved <= 0) return 0;
    std::vector<std::int32_t> gaps(path.size());
    gaps[last] = windows_[last].low + static_cast<std::int32_t>(best - cost_.begin());
    for (std::size_t i = last; i-- > 0;) {
        gaps[i] = came_from_[i][static_cast<std::size_t>(gaps[i + 1] - windows_[i + 1].low)];
    }
    put_back(path, gaps);
    return saved;
}

void PathMover::put_back(const std::vector<std::uint32_t>& path, const std::vector<std::int32_t>& gaps) {
    for (std::size_t i = 0; i < path.size(); ++i) {
        std::vector<std::uint32_t>& layer = g_.layers[layer_[path[i]]];
        layer.erase(layer.begin() + windows_[i].own);
        layer.insert(layer.begin() + gaps[i], path[i]);
        const auto from = static_cast<std::size_t>(std::min(windows_[i].own, gaps[i]));
        const auto to = static_cast<std::size_t>(std::max(windows_[i].own, gaps[i]));
        for (std::size_t k = from; k <= to; ++k) position_[layer[k]] = static_cast<std::uint32_t>(k);
    }
}

} // namespace planum::strat
