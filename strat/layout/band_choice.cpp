// SPDX-License-Identifier: MIT
#include "strat/layout/band_choice.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "core/base/text.hpp"
#include "strat/layout/box_label.hpp"
#include "strat/layout/graph_selection.hpp"

namespace planum::strat {

namespace {

class BandChooser {
  public:
    BandChooser(const model::Record& record, const DrawingOptions& options, DrawnGraph& graph)
        : record_(record), options_(options), graph_(graph) {}

    void choose() {
        Bands bands = options_.bands;
        const bool asked = bands != Bands::Automatic;
        if (options_.fold != Fold::None || bands == Bands::None) return;
        const std::vector<std::int32_t> phases = fold_keys(record_, Fold::Phases);
        const std::vector<std::int32_t> periods = fold_keys(record_, Fold::Periods);
        if (bands == Bands::Automatic) {
            if (serve_as_bands(phases, record_.phases)) {
                bands = Bands::Phases;
            } else if (serve_as_bands(periods, record_.periods)) {
                bands = Bands::Periods;
            } else {
                return;
            }
        }
        make_bands(bands, bands == Bands::Phases ? phases : periods);
        if (asked || !many_against_bands()) return;
        graph_.bands.clear();
        for (GraphBox& b : graph_.boxes) b.band = kNoBand;
    }

  private:
    // Most boxes have one, they are few enough to structure the page, and their order in time is known.
    template<class Values>
    [[nodiscard]] bool serve_as_bands(const std::vector<std::int32_t>& keys, const std::vector<Values>& values) const {
        constexpr std::size_t kMostBands = 16;
        constexpr std::size_t kBoxesEach = 3;
        std::size_t with = 0;
        std::unordered_set<std::int32_t> used;
        for (const GraphBox& b : graph_.boxes) {
            const std::int32_t key = shared_key(keys, b.units);
            if (key < 0) continue;
            ++with;
            used.insert(key);
        }
        const bool dated = std::all_of(used.begin(), used.end(), [&](std::int32_t key) {
            const Values& value = values[static_cast<std::size_t>(key)];
            return value.rank.has_value() || value.from.has_value() || value.to.has_value();
        });
        return with * 5 >= graph_.boxes.size() * 4 && !used.empty() && used.size() <= kMostBands &&
               used.size() * kBoxesEach <= graph_.boxes.size() + kBoxesEach && dated;
    }

    // Each order against the bands is a line upwards around the others: a few show what to look at, many leave
    // nothing to be seen of the sequence.
    [[nodiscard]] bool many_against_bands() const {
        constexpr std::size_t kOneIn = 20;
        std::size_t against = 0;
        for (const GraphOrder& o : graph_.orders) {
            const std::int32_t later = graph_.boxes[o.later].band;
            const std::int32_t earlier = graph_.boxes[o.earlier].band;
            if (later != kNoBand && earlier != kNoBand && later > earlier) ++against;
        }
        return against * kOneIn > graph_.orders.size();
    }

    // Time of a phase or period for sorting: ranks first, then years, then the number.
    struct BandKey {
        std::array<std::int64_t, 4> time{};
        bool has_time = false;
        std::string number;
        std::int32_t position = -1;
    };

    [[nodiscard]] BandKey key_of_period(std::int32_t p) const {
        BandKey key;
        if (p < 0) return key;
        const model::Period& period = record_.periods[static_cast<std::size_t>(p)];
        key.time = {period.rank.value_or(0), period.from.value_or(period.to.value_or(0)), 0, 0};
        key.has_time = period.rank || period.from || period.to;
        key.number = period.number;
        key.position = p;
        return key;
    }

    [[nodiscard]] BandKey key_of_phase(std::int32_t p) const {
        const model::Phase& phase = record_.phases[static_cast<std::size_t>(p)];
        const auto period = std::find_if(record_.periods.begin(), record_.periods.end(),
                                         [&](const model::Period& c) { return c.id == phase.period; });
        BandKey key = key_of_period(
            period == record_.periods.end() ? -1 : static_cast<std::int32_t>(period - record_.periods.begin()));
        key.time[2] = phase.rank.value_or(0);
        key.time[3] = phase.from.value_or(phase.to.value_or(0));
        key.has_time = key.has_time || phase.rank || phase.from || phase.to;
        key.number = phase.number;
        key.position = p;
        return key;
    }

    // Where the record does not say when all of them were, the orders between their units do: each band goes where the
    // fewest orders run against the bands, dated ones counting for more than all orders together.
    void sort_by_orders(std::vector<BandKey>& used, const std::vector<std::int32_t>& keys) const {
        std::unordered_map<std::int32_t, std::size_t> place;
        for (std::size_t i = 0; i < used.size(); ++i) place.emplace(used[i].position, i);
        const std::size_t n = used.size();
        std::vector<std::int64_t> above(n * n, 0); // how much speaks for the first above the second
        const auto place_of = [&](std::uint32_t box) {
            const auto at = place.find(shared_key(keys, graph_.boxes[box].units));
            return at == place.end() ? n : at->second;
        };
        for (const GraphOrder& o : graph_.orders) {
            const std::size_t later = place_of(o.later);
            const std::size_t earlier = place_of(o.earlier);
            if (later < n && earlier < n && later != earlier) ++above[later * n + earlier];
        }
        const auto dated = static_cast<std::int64_t>(graph_.orders.size()) + 1;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t k = 0; k < n; ++k) {
                if (used[i].has_time && used[k].has_time && used[i].time > used[k].time) above[i * n + k] += dated;
            }
        }
        std::vector<std::size_t> order = from_the_top(above, n);
        for (bool better = true; better;) { // each move lessens what speaks against, so this ends
            better = false;
            for (std::size_t from = 0; from < n; ++from) better = move_to_best(order, from, above) || better;
        }
        std::vector<BandKey> sorted;
        for (const std::size_t i : order) sorted.push_back(used[i]);
        used = std::move(sorted);
    }

    // Next comes what the least is above of, of what is left: no order runs against the bands if that can be.
    static std::vector<std::size_t> from_the_top(const std::vector<std::int64_t>& above, std::size_t n) {
        std::vector<std::size_t> left(n);
        std::iota(left.begin(), left.end(), std::size_t{0});
        std::vector<std::size_t> order;
        while (!left.empty()) {
            const auto weight = [&](std::size_t band) {
                std::int64_t sum = 0;
                for (const std::size_t other : left) sum += above[other * n + band];
                return sum;
            };
            const auto next = std::min_element(left.begin(), left.end(),
                                               [&](std::size_t a, std::size_t b) { return weight(a) < weight(b); });
            order.push_back(*next);
            left.erase(next);
        }
        return order;
    }

    static bool move_to_best(std::vector<std::size_t>& order, std::size_t from,
                             const std::vector<std::int64_t>& above) {
        const std::size_t n = order.size();
        const std::size_t band = order[from];
        std::int64_t best = 0;
        std::size_t to = from;
        std::int64_t won = 0;
        for (std::size_t k = from; k-- > 0;) { // upwards past order[k]
            won += above[band * n + order[k]] - above[order[k] * n + band];
            if (won > best) {
                best = won;
                to = k;
            }
        }
        won = 0;
        for (std::size_t k = from + 1; k < n; ++k) {
            won += above[order[k] * n + band] - above[band * n + order[k]];
            if (won > best) {
                best = won;
                to = k;
            }
        }
        if (to == from) return false;
        order.erase(order.begin() + static_cast<std::ptrdiff_t>(from));
        order.insert(order.begin() + static_cast<std::ptrdiff_t>(to), band);
        return true;
    }

    void make_bands(Bands bands, const std::vector<std::int32_t>& keys) {
        std::vector<BandKey> used;
        std::unordered_set<std::int32_t> seen;
        for (const GraphBox& b : graph_.boxes) {
            const std::int32_t key = shared_key(keys, b.units);
            if (key < 0 || !seen.insert(key).second) continue;
            used.push_back(bands == Bands::Phases ? key_of_phase(key) : key_of_period(key));
        }
        std::sort(used.begin(), used.end(), [](const BandKey& a, const BandKey& b) {
            if (a.time != b.time) return a.time > b.time; // latest first
            if (const auto order = text::natural_order(a.number, b.number); order != 0) return order > 0;
            return a.position < b.position;
        });
        if (!std::all_of(used.begin(), used.end(), [](const BandKey& key) { return key.has_time; }))
            sort_by_orders(used, keys);
        std::unordered_map<std::int32_t, std::int32_t> band_of;
        for (const BandKey& key : used) {
            band_of.emplace(key.position, static_cast<std::int32_t>(graph_.bands.size()));
            const auto at = static_cast<std::size_t>(key.position);
            const std::string& title = bands == Bands::Phases ? record_.phases[at].title : record_.periods[at].title;
            graph_.bands.push_back({xml_id("band-", key.number), heading_with(key.number, title), 0.0});
        }
        for (GraphBox& b : graph_.boxes) {
            const auto band = band_of.find(shared_key(keys, b.units));
            if (band != band_of.end()) b.band = band->second;
        }
    }

    const model::Record& record_;
    const DrawingOptions& options_;
    DrawnGraph& graph_;
};

} // namespace

std::int32_t shared_key(const std::vector<std::int32_t>& keys, const std::vector<UnitIndex>& units) {
    std::int32_t shared = -1;
    for (const UnitIndex unit : units) {
        if (keys[unit] < 0) continue;
        if (shared >= 0 && keys[unit] != shared) return -1;
        shared = keys[unit];
    }
    return shared;
}

void choose_bands(const model::Record& record, const DrawingOptions& options, DrawnGraph& graph) {
    BandChooser(record, options, graph).choose();
}

std::string heading_with(const std::string& number, const std::string& title) {
    return text::on_one_line(title.empty() || title == number ? number : number + " " + title).text;
}

} // namespace planum::strat
