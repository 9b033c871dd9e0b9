// SPDX-License-Identifier: MIT
#include "strat/layout/net_phase.hpp"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>

namespace planum::strat {

namespace {

// What a line looks like; only like joins like.
std::uint32_t look_of(const DrawnLine& line) {
    std::uint32_t look = static_cast<std::uint32_t>(line.mark) << 3U;
    if (line.uncertain) look |= 1U;
    if (line.through) look |= 2U;
    if (line.in_cycle) look |= 4U;
    return look;
}

class Bundler {
  public:
    Bundler(const DrawnGraph& graph, const Ranking& ranking) : graph_(graph), ranking_(ranking) {
        look_.reserve(graph.orders.size());
        for (const GraphOrder& o : graph.orders) look_.push_back(look_of(o.line));
        taken_.assign(graph.orders.size(), false);
    }

    std::vector<Net> bundle() {
        take_upwards();
        take_fans();
        take_stars();
        return std::move(nets_);
    }

  private:
    void take_upwards() {
        for (std::uint32_t i = 0; i < graph_.orders.size(); ++i) {
            if (!ranking_.upwards[i]) continue;
            taken_[i] = true;
            nets_.push_back({{graph_.orders[i].later}, {graph_.orders[i].earlier}, {i}, true});
        }
    }

    // Earlier boxes under exactly the same later boxes, at least two of each.
    void take_fans() {
        std::vector<std::vector<std::uint32_t>> above(graph_.boxes.size()); // orders by earlier box
        for (std::uint32_t i = 0; i < graph_.orders.size(); ++i) {
            if (!taken_[i]) above[graph_.orders[i].earlier].push_back(i);
        }
        using Key = std::pair<std::uint32_t, std::vector<std::uint32_t>>; // look, later boxes
        std::map<Key, std::vector<std::uint32_t>> fans;
        for (std::uint32_t b = 0; b < graph_.boxes.size(); ++b) {
            if (above[b].size() < 2) continue;
            const std::uint32_t look = look_[above[b].front()];
            const bool alike =
                std::all_of(above[b].begin(), above[b].end(), [&](std::uint32_t i) { return look_[i] == look; });
            if (!alike) continue;
            Key key{look, {}};
            for (const std::uint32_t i : above[b]) key.second.push_back(graph_.orders[i].later);
            fans[key].push_back(b);
        }
        for (auto& [key, earlier] : fans) {
            if (earlier.size() < 2) continue;
            Net net{key.second, earlier, {}, false};
            for (const std::uint32_t b : earlier) {
                net.orders.insert(net.orders.end(), above[b].begin(), above[b].end());
                for (const std::uint32_t i : above[b]) taken_[i] = true;
            }
            std::sort(net.orders.begin(), net.orders.end());
            nets_.push_back(std::move(net));
        }
    }

    // A star is all orders of one look below (or above) one box that are still free.
    struct Star {
        std::uint32_t size = 0;
        bool downwards = true;
        std::uint32_t box = 0;
        std::uint32_t look = 0;

        // Largest first, then those below a box, then by box.
        bool operator<(const Star& o) const {
            return std::make_tuple(size, downwards, o.box, o.look) < std::make_tuple(o.size, o.downwards, box, look);
        }
    };

    void take_stars() {
        std::map<std::tuple<bool, std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> rays;
        for (std::uint32_t i = 0; i < graph_.orders.size(); ++i) {
            if (taken_[i]) continue;
            rays[{true, graph_.orders[i].later, look_[i]}].push_back(i);
            rays[{false, graph_.orders[i].earlier, look_[i]}].push_back(i);
        }
        std::priority_queue<Star> open;
        for (const auto& [key, orders] : rays) {
            open.push(
                {static_cast<std::uint32_t>(orders.size()), std::get<0>(key), std::get<1>(key), std::get<2>(key)});
        }
        while (!open.empty()) {
            Star star = open.top();
            open.pop();
            std::vector<std::uint32_t>& orders = rays.at({star.downwards, star.box, star.look});
            std::erase_if(orders, [&](std::uint32_t i) { return taken_[i]; });
            if (orders.empty()) continue;
            if (orders.size() < star.size) { // others took some: ask again later
                star.size = static_cast<std::uint32_t>(orders.size());
                open.push(star);
                continue;
            }
            take_star(star, orders);
        }
    }

    void take_star(const Star& star, const std::vector<std::uint32_t>& orders) {
        Net net;
        net.orders = orders;
        for (const std::uint32_t i : orders) {
            taken_[i] = true;
            (star.downwards ? net.earlier : net.later)
                .push_back(star.downwards ? graph_.orders[i].earlier : graph_.orders[i].later);
        }
        (star.downwards ? net.later : net.earlier).push_back(star.box);
        nets_.push_back(std::move(net));
    }

    const DrawnGraph& graph_;
    const Ranking& ranking_;
    std::vector<std::uint32_t> look_;
    std::vector<bool> taken_;
    std::vector<Net> nets_;
};

} // namespace

std::vector<Net> bundle_orders(const DrawnGraph& graph, const Ranking& ranking) {
    return Bundler(graph, ranking).bundle();
}

} // namespace planum::strat
