// SPDX-License-Identifier: MIT
#include "app/demo/digging.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <set>

#include <fmt/format.h>

namespace planum::app {

namespace {

// What lies below each unit, however far: one row of flags a unit. Trenches are small.
std::vector<std::vector<char>> everything_below(const TrenchHistory& history) {
    const std::size_t n = history.units.size();
    std::vector<std::vector<char>> below(n, std::vector<char>(n, 0));
    // Units stand in the order of their forming, so what lies below is finished before it is needed.
    std::vector<std::vector<std::uint32_t>> direct(n);
    for (const TrenchContact& c : history.contacts) direct[c.later].push_back(c.earlier);
    for (std::size_t u = 0; u < n; ++u) {
        for (const std::uint32_t v : direct[u]) {
            below[u][v] = 1;
            for (std::size_t w = 0; w < v; ++w) below[u][w] |= below[v][w];
        }
    }
    return below;
}

bool is_implied(const TrenchContact& contact, const TrenchHistory& history,
                const std::vector<std::vector<char>>& below) {
    return std::any_of(history.contacts.begin(), history.contacts.end(), [&](const TrenchContact& other) {
        return other.later == contact.later && other.earlier != contact.earlier &&
               below[other.earlier][contact.earlier] != 0;
    });
}

double distance(const TrenchUnit& a, const TrenchUnit& b) {
    return std::hypot(a.cells.front().x - b.cells.front().x, a.cells.front().y - b.cells.front().y);
}

} // namespace

Digging dig(Random& random, const TrenchHistory& history, std::size_t first_number, double blur) {
    const std::size_t n = history.units.size();
    std::vector<std::uint32_t> waiting(n, 0);
    for (const TrenchContact& c : history.contacts) ++waiting[c.earlier];
    std::vector<std::uint32_t> free;
    for (std::uint32_t u = 0; u < n; ++u) {
        if (waiting[u] == 0) free.push_back(u);
    }
    std::vector<double> noticed(n, 0.0);
    Digging digging;
    digging.number.assign(n, 0);
    digging.day.assign(n, 0);
    double day = 0.0;
    std::uint32_t last = free.empty() ? 0 : free.front();
    for (std::size_t turn = 0; !free.empty(); ++turn) {
        auto pick = free.begin() + static_cast<std::ptrdiff_t>(random.below(free.size()));
        if (random.chance(2.0 / 3.0)) {
            pick = std::min_element(free.begin(), free.end(), [&](std::uint32_t a, std::uint32_t b) {
                return distance(history.units[a], history.units[last]) <
                       distance(history.units[b], history.units[last]);
            });
        }
        last = *pick;
        free.erase(pick);
        day += random.exponential(0.4);
        digging.day[last] = static_cast<std::int64_t>(day);
        noticed[last] = static_cast<double>(turn) + blur * random.normal();
        for (const TrenchContact& c : history.contacts) {
            if (c.later == last && --waiting[c.earlier] == 0) free.push_back(c.earlier);
        }
    }
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return noticed[a] < noticed[b]; });
    std::size_t number = first_number;
    for (const std::uint32_t u : order) {
        while (random.chance(0.03)) ++number; // never used
        digging.number[u] = number++;
    }
    digging.next_number = number;
    return digging;
}

std::string iso_day(std::int64_t n) {
    using namespace std::chrono;
    const sys_days day = sys_days{year{2024} / June / 3} + days{n / 5 * 7 + n % 5};
    const year_month_day date{day};
    return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                       static_cast<unsigned>(date.day()));
}

std::vector<TrenchContact> recorded_contacts(Random& random, const TrenchHistory& history, double per_unit,
                                             double redundant) {
    const auto below = everything_below(history);
    std::vector<TrenchContact> recorded;
    std::vector<TrenchContact> implied;
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const TrenchContact& c : history.contacts) {
        if (!pairs.emplace(c.later, c.earlier).second) continue; // one kind a pair
        // What a fill fills stands on its sheet however many fills lie between.
        if (c.kind != model::RelationKind::Fills && is_implied(c, history, below)) {
            implied.push_back(c);
        } else if (!random.chance(0.05)) {
            recorded.push_back(c);
        }
    }
    const auto target = static_cast<std::size_t>(per_unit * static_cast<double>(history.units.size()));
    auto extra = static_cast<std::size_t>(static_cast<double>(recorded.size()) * redundant / (1.0 - redundant));
    if (recorded.size() < target) extra = std::max(extra, std::min(target - recorded.size(), 4 * recorded.size()));
    // The larger a contact, the likelier somebody writes it down.
    std::stable_sort(implied.begin(), implied.end(),
                     [](const TrenchContact& a, const TrenchContact& b) { return a.cells > b.cells; });
    while (extra > 0 && !implied.empty()) {
        const std::size_t at = std::min(random.below(implied.size()), random.below(implied.size()));
        recorded.push_back(implied[at]);
        implied.erase(implied.begin() + static_cast<std::ptrdiff_t>(at));
        --extra;
    }
    for (std::size_t tries = 0; recorded.size() < target && tries < 40 * target; ++tries) {
        const auto later = static_cast<std::uint32_t>(random.below(history.units.size()));
        const auto earlier = static_cast<std::uint32_t>(random.below(history.units.size()));
        if (later <= earlier || below[later][earlier] == 0 || !pairs.emplace(later, earlier).second) continue;
        recorded.push_back({later, earlier, model::RelationKind::Covers, 0});
    }
    std::sort(recorded.begin(), recorded.end());
    return recorded;
}

} // namespace planum::app
