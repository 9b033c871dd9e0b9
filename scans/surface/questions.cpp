// SPDX-License-Identifier: MIT
#include "scans/surface/questions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace planum::scans {

namespace {

constexpr double kQuestionsOnSurfaces = 0.2; // at most, for each relation proposed
constexpr double kQuestionsOnLevels = 1.0;
// So few proposals join too little for the orders a question settles to mean anything: the largest contacts then.
constexpr std::size_t kFewProposals = 8;

// What is later and earlier than what by the proposals, through any number of units.
class KnownOrders {
  public:
    KnownOrders(const std::vector<Conclusion>& all, std::size_t units, std::span<const KnownOrder> recorded)
        : below_(units, std::vector<bool>(units, false)), above_(units), under_(units) {
        std::vector<std::vector<UnitNumber>> next(units);
        for (const Conclusion& c : all) {
            if (!c.is_question) next[static_cast<std::size_t>(c.unit)].push_back(c.other);
        }
        for (const KnownOrder& order : recorded) next[static_cast<std::size_t>(order.later)].push_back(order.earlier);
        for (std::size_t u = 0; u < units; ++u) {
            std::vector<UnitNumber> waiting = {static_cast<UnitNumber>(u)};
            while (!waiting.empty()) {
                const auto v = static_cast<std::size_t>(waiting.back());
                waiting.pop_back();
                if (below_[u][v]) continue;
                below_[u][v] = true;
                under_[u].push_back(v);
                above_[v].push_back(u);
                waiting.insert(waiting.end(), next[v].begin(), next[v].end());
            }
        }
    }

    [[nodiscard]] bool order(UnitNumber u, UnitNumber v) const { return is_below(u, v) || is_below(v, u); }

    // Pairs of units that would be in order if `later` were later than `earlier`, and are not yet.
    [[nodiscard]] std::size_t settled_by(UnitNumber later, UnitNumber earlier) const {
        std::size_t pairs = 0;
        for (const std::size_t u : above_[static_cast<std::size_t>(later)]) {
            for (const std::size_t v : under_[static_cast<std::size_t>(earlier)]) pairs += below_[u][v] ? 0U : 1U;
        }
        return pairs;
    }

  private:
    [[nodiscard]] bool is_below(UnitNumber u, UnitNumber v) const {
        return below_[static_cast<std::size_t>(u)][static_cast<std::size_t>(v)];
    }

    std::vector<std::vector<bool>> below_; // by unit: itself and what is earlier
    std::vector<std::vector<std::size_t>> above_;
    std::vector<std::vector<std::size_t>> under_;
};

// How often two units of whom this is asked touched, in simulated digs.
double likelihood_of_contact(const Conclusion& question) {
    switch (question.ground) {
    case Ground::OnlyAlongOutlines: return question.area < kLeastProposed ? 0.5 : 0.95;
    case Ground::RoofOfHollow: return 0.7;
    case Ground::AppearsInside: return 0.75;
    case Ground::StructureStands: return 0.85;
    default: return 0.95;
    }
}

struct RankedQuestion {
    std::size_t position;
    double use;
    double area;
};

bool is_more_useful(const RankedQuestion& a, const RankedQuestion& b) {
    return a.use != b.use ? a.use > b.use : a.area < b.area;
}

} // namespace

void keep_useful_questions(std::vector<Conclusion>& all, std::size_t units, std::span<const KnownOrder> recorded) {
    const KnownOrders known(all, units, recorded);
    std::vector<bool> drop(all.size(), false);
    for (const bool levels : {false, true}) {
        std::vector<RankedQuestion> ranked;
        std::size_t relations = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Conclusion& c = all[i];
            if ((c.source == model::EvidenceSource::Levels) != levels) continue;
            if (!c.is_question) {
                ++relations;
                continue;
            }
            drop[i] = true;
            if (known.order(c.unit, c.other)) continue; // its answer is implied
            const auto settled = std::max(known.settled_by(c.unit, c.other), known.settled_by(c.other, c.unit));
            ranked.push_back({i, likelihood_of_contact(c) * static_cast<double>(settled), c.area});
        }
        if (relations < kFewProposals) {
            for (RankedQuestion& question : ranked) question.use = question.area;
        }
        std::stable_sort(ranked.begin(), ranked.end(), is_more_useful);
        const double room = (levels ? kQuestionsOnLevels : kQuestionsOnSurfaces) * static_cast<double>(relations);
        ranked.resize(std::min(ranked.size(), static_cast<std::size_t>(std::lround(room))));
        for (const RankedQuestion& question : ranked) drop[question.position] = false;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!drop[i]) all[kept++] = all[i];
    }
    all.resize(kept);
}

} // namespace planum::scans
