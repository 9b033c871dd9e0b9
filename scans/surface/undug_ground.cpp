// SPDX-License-Identifier: MIT
#include "scans/surface/undug_ground.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "scans/surface/surface_difference.hpp"
#include "scans/surface/window_sums.hpp"

namespace planum::scans {

namespace {

/// What two surfaces say of one cell.
enum class Sign : std::uint8_t { Nothing, Still, Changed, Against };

/// One cell on one of two surfaces.
class CellOf {
  public:
    CellOf(const ClosedSurface& surface, std::size_t cell)
        : grid_(surface.grid), filled_(surface.filled), cell_(cell) {}

    [[nodiscard]] bool was_seen() const { return filled_.was_seen[cell_]; }

    [[nodiscard]] bool is_face() const { return grid_.state[cell_] == CellState::Face; }

    [[nodiscard]] bool is_laid() const { return filled_.laid[cell_]; }

    [[nodiscard]] double height() const { return static_cast<double>(filled_.height[cell_]); }

    [[nodiscard]] double gap_sigma() const {
        return static_cast<double>(std::max(filled_.sigma[cell_], filled_.shadow_sigma[cell_]));
    }

    [[nodiscard]] double pose_sigma() const { return static_cast<double>(grid_.pose_sigma[cell_]); }

    /// Of the height of a seen cell: its points and, on a slope, where in the cell they lie [m²].
    [[nodiscard]] double variance(double point_sigma) const {
        const double spread = std::max(point_sigma, static_cast<double>(grid_.spread[cell_]));
        const double slope = std::isnan(grid_.slope[cell_]) ? 0.0 : static_cast<double>(grid_.slope[cell_]);
        const double across = slope * grid_.frame.cell;
        return (spread * spread + across * across / 12.0) / std::max(1.0, static_cast<double>(grid_.count[cell_]));
    }

    /// Ground lies no higher where nobody saw it [m].
    [[nodiscard]] std::optional<double> line_of_sight() const {
        if (was_seen() || grid_.ceiling.empty() || std::isnan(grid_.ceiling[cell_])) return std::nullopt;
        return static_cast<double>(grid_.ceiling[cell_]);
    }

    [[nodiscard]] double top_of_face() const {
        return static_cast<double>(grid_.height[cell_] + 2.0F * grid_.spread[cell_]);
    }

  private:
    const SurfaceGrid& grid_;
    const FilledHeights& filled_;
    std::size_t cell_;
};

class Judge {
  public:
    Judge(const ClosedSurface& before, const ClosedSurface& after, const UndugRules& rules)
        : before_(before), after_(after), rules_(rules), frame_(common_frame(before.grid.frame, after.grid.frame)),
          signs_(signs()), seen_(frame_, [&](std::size_t cell) { return is_seen_on_both(cell) ? 1 : 0; }),
          still_(frame_, [&](std::size_t cell) { return signs_[cell] == Sign::Still ? 1 : 0; }),
          against_(frame_, [&](std::size_t cell) { return signs_[cell] == Sign::Against ? 1 : 0; }),
          change_(frame_, [&](std::size_t cell) { return signs_[cell] == Sign::Still ? depth(cell) : 0.0; }),
          variance_(frame_, [&](std::size_t cell) { return signs_[cell] == Sign::Still ? variance(cell) : 0.0; }),
          pose_(frame_, [&](std::size_t cell) { return signs_[cell] == Sign::Still ? pose(cell) : 0.0; }),
          side_depth_(frame_, [&](std::size_t cell) { return is_side(cell) ? depth(cell) : 0.0; }),
          side_extent_(frame_, [&](std::size_t cell) { return is_side(cell) ? extent(cell) : 0.0; }) {}

    [[nodiscard]] std::vector<bool> undug() {
        spread_doubt();
        std::vector<bool> undug(frame_.cells());
        for (std::int32_t row = 0; row < frame_.rows; ++row) {
            for (std::int32_t column = 0; column < frame_.columns; ++column)
                undug[frame_.at(row, column)] = is_undug({row, column});
        }
        return undug;
    }

  private:
    struct Place {
        std::int32_t row = 0;
        std::int32_t column = 0;
    };

    [[nodiscard]] Place place_of(std::size_t cell) const {
        return {static_cast<std::int32_t>(cell / static_cast<std::size_t>(frame_.columns)),
                static_cast<std::int32_t>(cell % static_cast<std::size_t>(frame_.columns))};
    }

    [[nodiscard]] CellOf on(const ClosedSurface& surface, std::size_t cell) const {
        const Place place = place_of(cell);
        return {surface, cell_in(surface.grid.frame, frame_, place.row, place.column)};
    }

    [[nodiscard]] CellOf was(std::size_t cell) const { return on(before_, cell); }

    [[nodiscard]] CellOf is(std::size_t cell) const { return on(after_, cell); }

    [[nodiscard]] double depth(std::size_t cell) const { return was(cell).height() - is(cell).height(); }

    [[nodiscard]] double variance(std::size_t cell) const {
        return was(cell).variance(rules_.point_sigma) + is(cell).variance(rules_.point_sigma);
    }

    [[nodiscard]] double pose(std::size_t cell) const {
        return std::hypot(was(cell).pose_sigma(), is(cell).pose_sigma());
    }

    [[nodiscard]] bool is_seen_on_both(std::size_t cell) const {
        return signs_[cell] == Sign::Still || signs_[cell] == Sign::Changed;
    }

    [[nodiscard]] bool is_side(std::size_t cell) const {
        return !is_seen_on_both(cell) && (was(cell).is_face() || is(cell).is_face()) && !std::isnan(depth(cell));
    }

    // From the ground under a side to that above it; fill_gaps() gives it as the σ of an even distribution.
    [[nodiscard]] double extent(std::size_t cell) const {
        return std::sqrt(12.0) * std::max(was(cell).gap_sigma(), is(cell).gap_sigma());
    }

    [[nodiscard]] std::vector<Sign> signs() const {
        std::vector<Sign> signs(frame_.cells(), Sign::Nothing);
        for (std::size_t cell = 0; cell < signs.size(); ++cell) {
            const CellOf a = was(cell);
            const CellOf b = is(cell);
            if (a.was_seen() && b.was_seen()) {
                const double most = rules_.sigmas * std::hypot(std::sqrt(variance(cell)), pose(cell));
                signs[cell] = std::abs(depth(cell)) <= most ? Sign::Still : Sign::Changed;
            } else if (is_other_floor(a, b) || lies_below(a, b) || lies_below(b, a)) {
                signs[cell] = Sign::Against;
            }
        }
        return signs;
    }

    /// Whether one surface lies, or must lie, clearly below the other. Where both show a side, or the other nothing,
    /// the points of a side say nothing: they lie anywhere between its foot and its edge.
    [[nodiscard]] bool lies_below(const CellOf& one, const CellOf& other) const {
        const double least = other.height() - rules_.below - 2.0 * other.gap_sigma();
        if (one.is_face() && other.was_seen() && one.top_of_face() < least) return true;
        const std::optional<double> line = one.line_of_sight();
        return line && *line < least;
    }

    // A floor that was measured on one day was dug, or filled in, unless on the other day it was seen there.
    [[nodiscard]] bool is_other_floor(const CellOf& one, const CellOf& other) const {
        if (one.is_laid() == other.is_laid()) return false;
        const bool seen = one.was_seen() || other.was_seen();
        return !seen || std::abs(one.height() - other.height()) > rules_.below;
    }

    [[nodiscard]] std::int32_t cells(double length) const {
        return static_cast<std::int32_t>(std::lround(length / frame_.cell));
    }

    [[nodiscard]] bool is_undug(const Place& place) const {
        const std::size_t cell = frame_.at(place.row, place.column);
        switch (signs_[cell]) {
        case Sign::Changed:
        case Sign::Against: return false;
        case Sign::Still: return window_is_still(place, cells(rules_.near));
        case Sign::Nothing: return !std::isnan(depth(cell)) && gap_is_undug(place, cell);
        }
        return false;
    }

    [[nodiscard]] bool window_is_still(const Place& place, std::int32_t reach) const {
        const auto seen = static_cast<double>(seen_.around(place.row, place.column, reach));
        const auto still = static_cast<double>(still_.around(place.row, place.column, reach));
        const auto against = static_cast<double>(against_.around(place.row, place.column, reach));
        if (still == 0.0 || still < rules_.share * (seen + against)) return false;
        const double mean = change_.around(place.row, place.column, reach) / still;
        const double noise = variance_.around(place.row, place.column, reach) / (still * still);
        const double pose = pose_.around(place.row, place.column, reach) / still;
        return std::abs(mean) <=
               std::min(rules_.most_mean, rules_.sigmas * std::sqrt(std::max(0.0, noise) + pose * pose));
    }

    [[nodiscard]] bool gap_is_undug(const Place& place, std::size_t cell) const {
        const double sigma = std::hypot(was(cell).gap_sigma(), is(cell).gap_sigma());
        if (std::abs(depth(cell)) > 2.0 * sigma + rules_.sigmas * std::hypot(rules_.point_sigma, pose(cell)))
            return false;
        if (doubtful_[cell] || has_change_beside(place) || (is_side(cell) && !sides_stand(place))) return false;
        return source_is_still(before_, place) && source_is_still(after_, place);
    }

    // What was seen across a side says nothing of a gap at its foot, so the ground that the gap was continued from is
    // asked.
    [[nodiscard]] bool source_is_still(const ClosedSurface& surface, const Place& place) const {
        const GridFrame& grid = surface.grid.frame;
        const std::uint32_t source = surface.filled.source[cell_in(grid, frame_, place.row, place.column)];
        const auto columns = static_cast<std::uint32_t>(grid.columns);
        const Place from{
            static_cast<std::int32_t>(source / columns) - static_cast<std::int32_t>(frame_.south - grid.south),
            static_cast<std::int32_t>(source % columns) - static_cast<std::int32_t>(frame_.west - grid.west)};
        for (double reach = rules_.near;; reach *= 2.0) {
            const std::int32_t window = cells(std::min(reach, rules_.farthest));
            if (seen_.around(from.row, from.column, window) >= rules_.fewest) return window_is_still(from, window);
            if (reach >= rules_.farthest) return false;
        }
    }

    [[nodiscard]] bool has_change_beside(const Place& place) const {
        const std::int32_t reach = cells(rules_.beside);
        const auto seen = static_cast<double>(seen_.around(place.row, place.column, reach));
        const auto still = static_cast<double>(still_.around(place.row, place.column, reach));
        const auto against = static_cast<double>(against_.around(place.row, place.column, reach));
        return still < rules_.share * (seen + against);
    }

    // Where points lie sparsely, cells without any hang together everywhere; what lies between such points is no gap.
    [[nodiscard]] bool is_hardly_seen(const Place& place) const { return seen_share(place) < rules_.hardly * usual_; }

    [[nodiscard]] double seen_share(const Place& place) const {
        const std::int32_t reach = cells(rules_.beside);
        return static_cast<double>(seen_.around(place.row, place.column, reach)) /
               seen_.cells_around(place.row, place.column, reach);
    }

    /// Of the cells around one that was seen on both surfaces, the share that was too.
    [[nodiscard]] double usual_share() const {
        double sum = 0.0;
        double number = 0.0;
        for (std::size_t cell = 0; cell < signs_.size(); ++cell) {
            if (!is_seen_on_both(cell)) continue;
            sum += seen_share(place_of(cell));
            number += 1.0;
        }
        return number > 0.0 ? sum / number : 0.0;
    }

    // Where part of a gap was dug, nobody knows how far: a pit whose floor is hidden shows no more than some of its
    // side.
    void spread_doubt() {
        usual_ = usual_share();
        doubtful_.assign(frame_.cells(), false);
        std::vector<Place> reached;
        for (std::size_t cell = 0; cell < signs_.size(); ++cell) {
            if (signs_[cell] == Sign::Against && has_change_beside(place_of(cell))) reached.push_back(place_of(cell));
        }
        grow_doubt(reached, cells(rules_.spread), [&](const Place& place) { return is_hardly_seen(place); });
        grow_doubt(reached, cells(rules_.beside), [](const Place&) { return true; }); // to the rim of the gap
    }

    template<class Admits>
    void grow_doubt(std::vector<Place>& reached, std::int32_t steps, const Admits& admits) {
        std::size_t begin = 0;
        for (std::int32_t step = 0; step < steps; ++step) {
            const std::size_t end = reached.size();
            const auto take = [&](const Place& place) {
                if (place.row < 0 || place.column < 0 || place.row >= frame_.rows || place.column >= frame_.columns)
                    return;
                const std::size_t cell = frame_.at(place.row, place.column);
                if (signs_[cell] != Sign::Nothing || doubtful_[cell] || !admits(place)) return;
                doubtful_[cell] = true;
                reached.push_back(place);
            };
            for (; begin < end; ++begin) {
                const Place place = reached[begin]; // the vector grows
                take({place.row - 1, place.column});
                take({place.row + 1, place.column});
                take({place.row, place.column - 1});
                take({place.row, place.column + 1});
            }
        }
    }

    // Cells of a side differ by half its height when a point more falls into them; the side as a whole does not move.
    [[nodiscard]] bool sides_stand(const Place& place) const {
        const std::int32_t reach = cells(rules_.near);
        return std::abs(side_depth_.around(place.row, place.column, reach)) <=
               rules_.side_shift * side_extent_.around(place.row, place.column, reach) + 1e-6;
    }

    const ClosedSurface& before_;
    const ClosedSurface& after_;
    const UndugRules& rules_;
    GridFrame frame_;
    std::vector<Sign> signs_;
    WindowSums<std::int32_t> seen_; // on both surfaces
    WindowSums<std::int32_t> still_;
    WindowSums<std::int32_t> against_;
    WindowSums<double> change_; // of what is still [m]
    WindowSums<double> variance_;
    WindowSums<double> pose_;
    WindowSums<double> side_depth_;
    WindowSums<double> side_extent_;
    double usual_ = 0.0;
    std::vector<bool> doubtful_; // gaps into which a change may reach
};

} // namespace

std::vector<bool> undug_ground(const ClosedSurface& before, const ClosedSurface& after, const UndugRules& rules) {
    return Judge(before, after, rules).undug();
}

} // namespace planum::scans
