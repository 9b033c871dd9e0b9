// SPDX-License-Identifier: MIT
#include "strat/layout/fan_centring.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace planum::strat {

namespace {

class FanCentrer : public LevelNeighbours {
  public:
    explicit FanCentrer(const LevelNeighbours& neighbours) : LevelNeighbours(neighbours) {}

    void centre(std::vector<double>& x) const {
        const std::vector<std::vector<std::uint32_t>> chains = straight_chains(x);
        constexpr int kRounds = 8; // a box may make room for the next
        for (int round = 0; round < kRounds; ++round) {
            bool moved = false;
            for (std::size_t i = 0; i < chains.size(); ++i) {
                moved = centre_chain(chains[round % 2 == 0 ? chains.size() - 1 - i : i], x) || moved;
            }
            if (!moved) return;
        }
    }

  private:
    // Whatever stands in one vertical with nothing else joined to it between the ends.
    [[nodiscard]] std::vector<std::vector<std::uint32_t>> straight_chains(const std::vector<double>& x) const {
        const auto next = [&](std::uint32_t v) {
            if (down_.row(v).size() != 1) return kNone;
            const std::uint32_t w = down_.row(v)[0];
            return up_.row(w).size() == 1 && x[w] == x[v] ? w : kNone;
        };
        std::vector<bool> inside(g_.nodes, false);
        for (std::uint32_t v = 0; v < g_.nodes; ++v) {
            if (const std::uint32_t w = next(v); w != kNone) inside[w] = true;
        }
        std::vector<std::vector<std::uint32_t>> chains;
        for (const std::vector<std::uint32_t>& layer : g_.layers) {
            for (const std::uint32_t v : layer) {
                if (inside[v]) continue;
                chains.push_back({v});
                for (std::uint32_t w = next(v); w != kNone; w = next(w)) chains.back().push_back(w);
            }
        }
        return chains;
    }

    // The middle between the inner two of an even number of neighbours.
    [[nodiscard]] static std::optional<double> middle(std::span<const std::uint32_t> row,
                                                      const std::vector<double>& x) {
        if (row.size() < 2) return std::nullopt;
        const std::size_t half = row.size() / 2;
        if (row.size() % 2 == 1) return x[row[half]];
        return (x[row[half - 1]] + x[row[half]]) / 2.0;
    }

    // What the edges at the ends of a chain come to if it is put somewhere.
    struct Cost {
        int bent_lines = 0;
        int bent = 0;     // edges between boxes
        double way = 0.0; // horizontal [pt]

        friend auto operator<=>(const Cost&, const Cost&) = default;
    };

    // Between boxes with no more than two lines there, what a straight vertical from port to port can bridge is no way.
    [[nodiscard]] Cost cost(const std::vector<std::uint32_t>& chain, double at, const std::vector<double>& x) const {
        Cost sum;
        const auto add = [&](std::uint32_t end, std::uint32_t other, bool few) {
            const bool line = extents_[end].is_line || extents_[other].is_line;
            const double bridged = few && !line ? reach(end) + reach(other) : 0.0;
            const double way = std::max(0.0, std::abs(x[other] - at) - bridged);
            if (way > 0.0) ++(line ? sum.bent_lines : sum.bent);
            sum.way += (line ? 2.0 : 1.0) * way;
        };
        const std::uint32_t top = chain.front();
        const std::uint32_t foot = chain.back();
        for (const std::uint32_t w : up_.row(top)) add(top, w, up_.row(top).size() <= 2 && down_.row(w).size() <= 2);
        for (const std::uint32_t w : down_.row(foot)) {
            add(foot, w, down_.row(foot).size() <= 2 && up_.row(w).size() <= 2);
        }
        sum.way = std::round(sum.way * 2.0) / 2.0;
        return sum;
    }

    // How far from its centre a line can leave or enter a node.
    [[nodiscard]] double reach(std::uint32_t v) const {
        return extents_[v].is_line ? 0.0 : std::max(0.0, extents_[v].width / 2.0 - style::kPortMargin);
    }

    bool centre_chain(const std::vector<std::uint32_t>& chain, std::vector<double>& x) const {
        const std::optional<double> above = middle(up_.row(chain.front()), x);
        const std::optional<double> below = middle(down_.row(chain.back()), x);
        if (!above && !below) return false;
        double least = -std::numeric_limits<double>::infinity();
        double most = -least;
        for (const std::uint32_t v : chain) {
            least = std::max(least, bound(v, x, true));
            most = std::min(most, bound(v, x, false));
        }
        if (least > most) return false;
        const double wanted = above && below ? (*above + *below) / 2.0 : above ? *above : *below;
        // Whole halves of points: twins left and right of the middle are then equally far from it.
        const double target = std::round(std::clamp(wanted, least, most) * 2.0) / 2.0;
        const double now = x[chain.front()];
        if (target < least || target > most || std::abs(target - now) < 0.5) return false;
        // What stands at an end of the drawing is worth a bend more: there a lopsided fan is seen at once.
        const bool at_end = up_.row(chain.front()).empty() || down_.row(chain.back()).empty();
        const Cost before = cost(chain, now, x);
        Cost then = cost(chain, target, x);
        if (at_end) then.bent = before.bent;
        if (then > before) return false;
        for (const std::uint32_t v : chain) x[v] = target;
        return true;
    }
};

} // namespace

void centre_over_fans(const LevelNeighbours& neighbours, std::vector<double>& x) { FanCentrer(neighbours).centre(x); }

} // namespace planum::strat
