// SPDX-License-Identifier: MIT
#include "strat/layout/channel_router.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "strat/matrix/condensation.hpp"

namespace planum::strat {

namespace {

// A horizontal with its verticals: a wire, or the upper or lower half of one with a knee.
struct Bar {
    std::size_t wire = 0;
    std::vector<double> tops;    // ascending
    std::vector<double> bottoms; // ascending
    double low = 0.0;
    double high = 0.0;

    void measure() {
        std::sort(tops.begin(), tops.end());
        std::sort(bottoms.begin(), bottoms.end());
        low = std::numeric_limits<double>::infinity();
        high = -low;
        for (const std::vector<double>* ends : {&tops, &bottoms}) {
            if (ends->empty()) continue;
            low = std::min(low, ends->front());
            high = std::max(high, ends->back());
        }
    }

    [[nodiscard]] bool straight() const noexcept { return high - low < 1e-9; }
};

std::int64_t ends_within(const std::vector<double>& ends, const Bar& bar) {
    return std::upper_bound(ends.begin(), ends.end(), bar.high) - std::lower_bound(ends.begin(), ends.end(), bar.low);
}

// Crossings of two bars with `upper` on the higher track.
std::int64_t crossings(const Bar& upper, const Bar& lower) {
    return ends_within(upper.bottoms, lower) + ends_within(lower.tops, upper);
}

bool share_columns(const Bar& a, const Bar& b) { return a.low < b.high + kTouching && b.low < a.high + kTouching; }

class Channel {
  public:
    explicit Channel(const std::vector<Wire>& wires) {
        route_.wires.resize(wires.size());
        for (std::size_t w = 0; w < wires.size(); ++w) {
            for (const std::vector<double>* ends : {&wires[w].tops, &wires[w].bottoms}) {
                columns_.insert(columns_.end(), ends->begin(), ends->end());
            }
            Bar bar{w, wires[w].tops, wires[w].bottoms, 0.0, 0.0};
            bar.measure();
            if (!bar.straight()) bars_.push_back(std::move(bar));
        }
        std::sort(columns_.begin(), columns_.end());
    }

    ChannelRoute route() {
        find_musts();
        break_rings();
        arrange();
        assign_tracks();
        return std::move(route_);
    }

  private:
    // musts_: (a, b), a's track must be above b's, because a comes from above where b goes down.
    void find_musts() {
        struct End {
            double x;
            std::uint32_t bar;
        };

        std::vector<End> tops;
        std::vector<End> bottoms;
        for (std::uint32_t b = 0; b < bars_.size(); ++b) {
            for (const double x : bars_[b].tops) tops.push_back({x, b});
            for (const double x : bars_[b].bottoms) bottoms.push_back({x, b});
        }
        const auto by_x = [](const End& a, const End& b) { return a.x != b.x ? a.x < b.x : a.bar < b.bar; };
        std::sort(tops.begin(), tops.end(), by_x);
        std::sort(bottoms.begin(), bottoms.end(), by_x);
        musts_.clear();
        std::size_t first = 0;
        for (const End& top : tops) {
            while (first < bottoms.size() && bottoms[first].x <= top.x - kTouching) ++first;
            for (std::size_t i = first; i < bottoms.size() && bottoms[i].x < top.x + kTouching; ++i) {
                if (bars_[bottoms[i].bar].wire != bars_[top.bar].wire) musts_.push_back({top.bar, bottoms[i].bar});
            }
        }
        for (std::uint32_t b = 0; b < bars_.size(); ++b) { // the halves of a wire with a knee
            for (std::uint32_t c = b + 1; has_knee(b) && c < bars_.size(); ++c) {
                if (bars_[c].wire != bars_[b].wire) continue;
                musts_.push_back({b, c});
                break;
            }
        }
        std::sort(musts_.begin(), musts_.end());
        musts_.erase(std::unique(musts_.begin(), musts_.end()), musts_.end());
    }

    [[nodiscard]] bool has_knee(std::uint32_t bar) const { return route_.wires[bars_[bar].wire].knee.has_value(); }

    // A wire with a knee is in no ring: its upper half has only wires below it, its lower half only above.
    void break_rings() {
        while (true) {
            const Condensation groups = condense(bars_.size(), musts_);
            std::vector<std::uint32_t> bend;
            for (std::uint32_t c = 0; c < groups.members.rows(); ++c) {
                const auto members = groups.members.row(c);
                if (members.size() < 2) continue;
                std::vector<std::size_t> degree(members.size(), 0);
                for (const Order& must : musts_) {
                    for (const std::uint32_t end : {must.later, must.earlier}) {
                        const auto at = std::lower_bound(members.begin(), members.end(), end);
                        if (at != members.end() && *at == end) ++degree[static_cast<std::size_t>(at - members.begin())];
                    }
                }
                const auto most = std::max_element(degree.begin(), degree.end());
                bend.push_back(members[static_cast<std::size_t>(most - degree.begin())]);
            }
            if (bend.empty()) return;
            for (const std::uint32_t bar : bend) bend_bar(bar);
            find_musts();
        }
    }

    void bend_bar(std::uint32_t b) {
        const double x = free_column(bars_[b]);
        route_.wires[bars_[b].wire].knee = WireRoute::Knee{x, 0};
        columns_.insert(std::lower_bound(columns_.begin(), columns_.end(), x), x);
        Bar lower{bars_[b].wire, {x}, std::move(bars_[b].bottoms), 0.0, 0.0};
        bars_[b].bottoms = {x};
        bars_[b].measure();
        lower.measure();
        bars_.push_back(std::move(lower));
    }

    // Nearest to the middle of the wire where no vertical of the channel is near.
    [[nodiscard]] double free_column(const Bar& bar) const {
        const double middle = std::round(bar.low + bar.high) / 2.0;
        const auto is_free = [&](double x) {
            const auto at = std::lower_bound(columns_.begin(), columns_.end(), x - kTouching - 0.5);
            return at == columns_.end() || *at > x + kTouching + 0.5;
        };
        for (double away = 0.0;; away += 0.5) {
            if (is_free(middle - away)) return middle - away;
            if (is_free(middle + away)) return middle + away;
        }
    }

    // An order of the bars from above to below that keeps all musts: first a good guess, then bars moved to
    // where they cross least.
    void arrange() {
        sequence_ = guess();
        constexpr std::size_t kMostSifted = 220;
        if (bars_.size() <= kMostSifted && bars_.size() > 1) sift();
    }

    // Of bars that run to the right the rightmost comes first, of those to the left the leftmost: these do
    // not cross each other.
    std::vector<std::uint32_t> guess() const {
        const auto mean = [](const std::vector<double>& v) {
            double sum = 0.0;
            for (const double x : v) sum += x;
            return v.empty() ? 0.0 : sum / static_cast<double>(v.size());
        };
        std::vector<double> urgency(bars_.size());
        for (std::size_t b = 0; b < bars_.size(); ++b) {
            const bool rightwards =
                !bars_[b].tops.empty() && !bars_[b].bottoms.empty() && mean(bars_[b].bottoms) > mean(bars_[b].tops);
            urgency[b] = rightwards ? -bars_[b].low : bars_[b].high;
        }
        std::vector<std::uint32_t> waiting(bars_.size(), 0);
        std::vector<std::vector<std::uint32_t>> after(bars_.size());
        for (const Order& must : musts_) {
            after[must.later].push_back(must.earlier);
            ++waiting[must.earlier];
        }
        using Entry = std::pair<double, std::uint32_t>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
        for (std::uint32_t b = 0; b < bars_.size(); ++b) {
            if (waiting[b] == 0) open.push({urgency[b], b});
        }
        std::vector<std::uint32_t> sequence;
        while (!open.empty()) {
            const std::uint32_t b = open.top().second;
            open.pop();
            sequence.push_back(b);
            for (const std::uint32_t next : after[b]) {
                if (--waiting[next] == 0) open.push({urgency[next], next});
            }
        }
        return sequence;
    }

    void sift() {
        const std::size_t n = bars_.size();
        std::vector<std::int32_t> gain(n * n, 0); // crossings of (a above b) minus (b above a)
        std::vector<bool> must(n * n, false);
        for (std::size_t a = 0; a < n; ++a) {
            for (std::size_t b = a + 1; b < n; ++b) {
                if (!share_columns(bars_[a], bars_[b])) continue;
                const auto g = static_cast<std::int32_t>(crossings(bars_[a], bars_[b]) - crossings(bars_[b], bars_[a]));
                gain[a * n + b] = g;
                gain[b * n + a] = -g;
            }
        }
        for (const Order& m : musts_) must[m.later * n + m.earlier] = true;
        constexpr int kRounds = 4;
        for (int round = 0; round < kRounds; ++round) {
            bool better = false;
            for (std::uint32_t b = 0; b < n; ++b) better = sift_bar(b, gain, must) || better;
            if (!better) return;
        }
    }

    bool sift_bar(std::uint32_t b, const std::vector<std::int32_t>& gain, const std::vector<bool>& must) {
        const std::size_t n = bars_.size();
        const auto at = static_cast<std::size_t>(std::find(sequence_.begin(), sequence_.end(), b) - sequence_.begin());
        std::int64_t delta = 0;
        std::int64_t best = 0;
        std::size_t to = at;
        for (std::size_t i = at + 1; i < n && !must[b * n + sequence_[i]]; ++i) {
            delta -= gain[b * n + sequence_[i]];
            if (delta < best) {
                best = delta;
                to = i;
            }
        }
        delta = 0;
        for (std::size_t i = at; i-- > 0 && !must[sequence_[i] * n + b];) {
            delta += gain[b * n + sequence_[i]];
            if (delta < best) {
                best = delta;
                to = i;
            }
        }
        if (to == at) return false;
        sequence_.erase(sequence_.begin() + static_cast<std::ptrdiff_t>(at));
        sequence_.insert(sequence_.begin() + static_cast<std::ptrdiff_t>(to), b);
        return true;
    }

    // Each bar as high as those before it in its columns let it.
    void assign_tracks() {
        std::vector<std::int32_t> track(bars_.size(), 0);
        for (std::size_t i = 0; i < sequence_.size(); ++i) {
            const std::uint32_t b = sequence_[i];
            for (std::size_t j = 0; j < i; ++j) {
                const std::uint32_t before = sequence_[j];
                if (track[before] >= track[b] && share_columns(bars_[before], bars_[b])) track[b] = track[before] + 1;
            }
            route_.tracks = std::max(route_.tracks, track[b] + 1);
        }
        for (std::uint32_t b = 0; b < bars_.size(); ++b) {
            WireRoute& wire = route_.wires[bars_[b].wire];
            if (wire.knee && wire.track >= 0) {
                wire.knee->track = track[b]; // the lower half comes second in bars_
            } else {
                wire.track = track[b];
            }
        }
    }

    std::vector<Bar> bars_;
    std::vector<double> columns_; // all verticals, ascending
    std::vector<Order> musts_;
    std::vector<std::uint32_t> sequence_;
    ChannelRoute route_;
};

} // namespace

ChannelRoute route_channel(const std::vector<Wire>& wires) { return Channel(wires).route(); }

} // namespace planum::strat
