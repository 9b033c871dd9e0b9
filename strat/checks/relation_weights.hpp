// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "strat/checks/families.hpp"

namespace planum::strat {

/// How sure a relation is, as log-odds (natural) that it is right, with the sentences behind it.
struct RelationWeight {
    double log_odds = 0.0;
    std::vector<std::string> against; ///< reasons to doubt it, weightiest first
    std::vector<std::string> in_favour;
};

/// Weighs relations by how right ones of the same record look. Everything that can be counted is counted:
/// on how many sheets relations stand, whether the upper unit was dug first, lies higher, has the lower
/// number, how far apart the units are in plan and in numbers. Relations outside cycle groups are taken
/// as right; a wrong one would show the mirror image (direction) or a chance pair (distance). Where the
/// record is silent or too small to count, the feature weighs nothing. On top come fixed weights for
/// kinds, certainty, levels that exclude each other, dates, phases and surfaces (docs/checks.md).
class RelationWeights {
  public:
    explicit RelationWeights(const CheckContext& context);

    [[nodiscard]] double log_odds(RelationIndex relation) const;
    [[nodiscard]] RelationWeight explain(RelationIndex relation) const;

    /// A number on one of the relation's sheets that is one slip away from a unit whose own sheet states
    /// just this relation: `written` was probably meant to be `meant`.
    struct Slip {
        UnitIndex written = model::kNoUnit;
        UnitIndex meant = model::kNoUnit;
        bool reciprocal = false; ///< the sheet of `meant` states the relation, the other does not
        double fit = 0.0;        ///< how well `meant` would fit, to choose among several
        std::string why;
    };

    [[nodiscard]] std::optional<Slip> reciprocal_slip(RelationIndex relation) const;
    /// The best unit one slip away, reciprocal or not, that would not stand in the same cycle group.
    [[nodiscard]] std::optional<Slip> best_slip(RelationIndex relation) const;

    /// Log-odds of a same_as statement.
    [[nodiscard]] RelationWeight weigh_same_as(RelationIndex relation) const;

  private:
    struct Evidence {
        double log_ratio; ///< positive speaks for the relation
        std::string_view what;
    };

    using EvidenceList = std::array<Evidence, 16>;

    struct Gathered {
        EvidenceList items{};
        std::size_t count = 0;

        void add(double log_ratio, std::string_view what) {
            if (log_ratio != 0.0 && count < items.size()) items[count++] = {log_ratio, what};
        }
    };

    /// Of a feature with three outcomes: as expected, undecided, contrary.
    struct Direction {
        std::array<double, 3> count{};
        [[nodiscard]] double log_ratio(int outcome) const;
    };

    /// Of a distance: bounds of its bins and how right and chance pairs fall into them.
    struct Distance {
        std::array<double, 3> bounds{};
        std::array<double, 4> right{};
        std::array<double, 4> chance{};
        bool usable = false;
        [[nodiscard]] double log_ratio(double distance) const;
    };

    void count();
    void count_distances(const std::vector<RelationIndex>& right);
    [[nodiscard]] Gathered gather(RelationIndex relation) const;
    void gather_statements(RelationIndex relation, Gathered& g) const;
    void gather_directions(RelationIndex relation, Gathered& g) const;
    void gather_distances(RelationIndex relation, Gathered& g) const;
    void gather_fixed(RelationIndex relation, Gathered& g) const;

    [[nodiscard]] int digging_outcome(RelationIndex relation) const;
    [[nodiscard]] int height_outcome(RelationIndex relation) const;
    [[nodiscard]] int number_outcome(RelationIndex relation) const;
    [[nodiscard]] std::optional<double> plan_distance(UnitIndex a, UnitIndex b) const;
    [[nodiscard]] std::optional<double> number_distance(UnitIndex a, UnitIndex b) const;
    [[nodiscard]] bool has_sheets(RelationIndex relation) const;
    [[nodiscard]] std::uint32_t source_of(RelationIndex relation) const;
    [[nodiscard]] bool fits_as_meant(RelationIndex relation, UnitIndex meant, UnitIndex written) const;

    const CheckContext& c_;
    std::vector<DateBounds> dates_;
    PhaseComparer phases_;
    std::vector<std::optional<double>> numbers_;               ///< the number as a value, where it is one
    std::vector<std::optional<std::array<double, 2>>> places_; ///< mean of the levels in plan [m]
    std::unordered_map<model::SourceId, std::uint32_t> sources_;

    struct Sides {
        double both = 0.0;
        double one = 0.0;
    };

    std::vector<Sides> sides_; ///< by source; the last is "typed in"
    static constexpr std::size_t kKinds = 9;
    std::array<Direction, kKinds> digging_{};
    std::array<Direction, kKinds> heights_{};
    std::array<Direction, kKinds> order_of_numbers_{};
    Distance plan_;
    Distance number_;
    std::unordered_map<std::uint64_t, double> surfaces_; ///< signed evidence of a pair
};

/// Whether two numbers differ by one digit exchanged, or by two neighbouring ones changed over; never
/// for numbers of one digit.
[[nodiscard]] bool one_slip_apart(std::string_view a, std::string_view b) noexcept;
/// All texts one such slip away from the number.
[[nodiscard]] std::vector<std::string> one_slip_away(std::string_view number);

} // namespace planum::strat
