// SPDX-License-Identifier: MIT
#include "scans/surface/passing_things.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace planum::scans {

namespace {

constexpr double kSteepest = 1.75;       // tangent of what still hangs together; just over 60°
constexpr double kRough = 0.015;         // and that much besides [m]
constexpr std::size_t kSpeckCells = 4;   // fewer cells and
constexpr std::size_t kSpeckPoints = 12; // fewer points: a speck
constexpr double kFarthestStep = 0.1;    // and no more however far off [m]
constexpr std::int32_t kRings = 10;      // so many cells away at most
constexpr std::size_t kEnough = 8;       // neighbours
constexpr double kBeneath = 0.04;        // what is lower by so much is beneath [m]
constexpr double kJoinedShare = 0.3;     // of its cells next to higher ground: a side of something

class Pieces {
  public:
    explicit Pieces(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

    std::uint32_t of(std::uint32_t i) {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }

    void join(std::uint32_t a, std::uint32_t b) {
        a = of(a);
        b = of(b);
        if (a != b) parent_[std::max(a, b)] = std::min(a, b); // the smallest number names the piece
    }

  private:
    std::vector<std::uint32_t> parent_;
};

struct Piece {
    std::size_t cells = 0;
    std::size_t points = 0;
    std::size_t seen_beneath = 0;
    std::size_t next_to_higher = 0;
    std::int32_t low_row = 1 << 30;
    std::int32_t high_row = -1;
    std::int32_t low_column = 1 << 30;
    std::int32_t high_column = -1;
    float top = -1e30F;
    float ground_around = -1e30F; // highest ground nearby [m]
    bool has_ground_around = false;
};

template<class Visit>
void for_layers(const LayerField& field, const Visit& visit) {
    for (std::int32_t row = 0; row < field.frame.rows; ++row) {
        for (std::int32_t column = 0; column < field.frame.columns; ++column) {
            const std::size_t cell = field.frame.at(row, column);
            const std::span<const HeightLayer> layers = field.at(cell);
            for (std::size_t k = 0; k < layers.size(); ++k)
                visit(row, column, field.first(cell) + static_cast<std::uint32_t>(k), layers[k]);
        }
    }
}

template<class Visit>
void for_neighbours(const LayerField& field, std::int32_t row, std::int32_t column, std::int32_t radius,
                    std::int32_t step, const Visit& visit) {
    for (std::int32_t r = row - radius; r <= row + radius; r += step) {
        if (r < 0 || r >= field.frame.rows) continue;
        for (std::int32_t c = column - radius; c <= column + radius; c += step) {
            if (c < 0 || c >= field.frame.columns || (r == row && c == column)) continue;
            visit(r, c, field.frame.at(r, c));
        }
    }
}

template<class Visit>
void for_ring(const LayerField& field, std::int32_t row, std::int32_t column, std::int32_t ring, const Visit& visit) {
    for (std::int32_t r = row - ring; r <= row + ring; ++r) {
        if (r < 0 || r >= field.frame.rows) continue;
        const std::int32_t step = std::abs(r - row) == ring ? 1 : 2 * ring;
        for (std::int32_t c = column - ring; c <= column + ring; c += step) {
            if (c >= 0 && c < field.frame.columns) visit(r, c, field.frame.at(r, c));
        }
    }
}

void join_layers(const LayerField& field, std::uint32_t number, const HeightLayer& layer, std::size_t there,
                 double distance, Pieces& pieces) {
    const double most = std::min(kSteepest * distance, kFarthestStep) + kRough;
    const std::span<const HeightLayer> others = field.at(there);
    for (std::size_t k = 0; k < others.size(); ++k) {
        if (std::abs(static_cast<double>(others[k].height) - static_cast<double>(layer.height)) <= most)
            pieces.join(number, field.first(there) + static_cast<std::uint32_t>(k));
    }
}

/// Joins what hangs together: with all cells up to two away and, where points lie sparsely, ring by ring with those
/// farther off until some have been met.
Pieces find_pieces(const LayerField& field) {
    Pieces pieces(field.layers());
    const double cell = field.frame.cell;
    for_layers(field, [&](std::int32_t row, std::int32_t column, std::uint32_t number, const HeightLayer& layer) {
        std::size_t met = 0;
        for (std::int32_t ring = 1; ring <= kRings && (ring <= 2 || met < kEnough); ++ring) {
            for_ring(field, row, column, ring, [&](std::int32_t r, std::int32_t c, std::size_t there) {
                if (field.at(there).empty()) return;
                ++met;
                join_layers(field, number, layer, there, cell * std::hypot(r - row, c - column), pieces);
            });
        }
    });
    return pieces;
}

class Judge {
  public:
    Judge(const LayerField& field, const PassingRules& rules)
        : field_(field), rules_(rules), pieces_(find_pieces(field)), piece_(field.layers()) {
        measure();
        look_around();
    }

    PassingReport mark(std::vector<bool>& marked) {
        PassingReport report;
        for_layers(field_, [&](std::int32_t, std::int32_t, std::uint32_t number, const HeightLayer&) {
            const std::uint32_t name = pieces_.of(number);
            const Piece& piece = piece_[name];
            if (is_speck(piece)) {
                ++report.specks;
            } else if (is_thing(piece)) {
                report.things += number == name ? 1 : 0;
                report.area += field_.frame.cell * field_.frame.cell;
            } else {
                return;
            }
            marked[number] = true;
        });
        return report;
    }

  private:
    [[nodiscard]] bool is_ground(const Piece& piece) const {
        return static_cast<double>(piece.cells) * field_.frame.cell * field_.frame.cell >= rules_.ground;
    }

    static bool is_speck(const Piece& piece) { return piece.cells < kSpeckCells && piece.points < kSpeckPoints; }

    [[nodiscard]] bool is_small(const Piece& piece) const {
        const auto cells = [&](std::int32_t from, std::int32_t to) {
            return static_cast<double>(to - from + 1) * field_.frame.cell;
        };
        return std::hypot(cells(piece.low_row, piece.high_row), cells(piece.low_column, piece.high_column)) <=
               rules_.largest;
    }

    [[nodiscard]] bool is_thing(const Piece& piece) const {
        const auto all = static_cast<double>(piece.cells);
        if (!is_small(piece)) return false;
        if (static_cast<double>(piece.next_to_higher) > kJoinedShare * all) return false;
        if (static_cast<double>(piece.seen_beneath) >= rules_.seen_beneath * all) return true;
        return all * field_.frame.cell * field_.frame.cell < rules_.smallest && piece.has_ground_around &&
               static_cast<double>(piece.top) > static_cast<double>(piece.ground_around) + rules_.rises;
    }

    void measure() {
        for_layers(field_, [&](std::int32_t row, std::int32_t column, std::uint32_t number, const HeightLayer& layer) {
            Piece& piece = piece_[pieces_.of(number)];
            ++piece.cells;
            piece.points += layer.count;
            piece.low_row = std::min(piece.low_row, row);
            piece.high_row = std::max(piece.high_row, row);
            piece.low_column = std::min(piece.low_column, column);
            piece.high_column = std::max(piece.high_column, column);
            piece.top = std::max(piece.top, layer.height);
            for (const HeightLayer& other : field_.at(field_.frame.at(row, column))) {
                // A scan that sees the ground here and nothing above it.
                if (static_cast<double>(other.height) < static_cast<double>(layer.height) - kBeneath &&
                    (other.scans & ~layer.scans) != 0) {
                    ++piece.seen_beneath;
                    break;
                }
            }
        });
    }

    void look_around() {
        const auto reach = static_cast<std::int32_t>(std::lround(rules_.rises / field_.frame.cell));
        for_layers(field_, [&](std::int32_t row, std::int32_t column, std::uint32_t number, const HeightLayer& layer) {
            Piece& piece = piece_[pieces_.of(number)];
            if (is_ground(piece) || !is_small(piece)) return;
            bool higher = false;
            for_neighbours(field_, row, column, 3, 1, [&](std::int32_t, std::int32_t, std::size_t there) {
                higher = higher || has_ground(there, layer.height - 0.02F);
            });
            piece.next_to_higher += higher ? 1 : 0;
            for_neighbours(field_, row, column, reach, std::max(reach / 3, 1),
                           [&](std::int32_t, std::int32_t, std::size_t there) { add_ground(there, piece); });
        });
    }

    bool has_ground(std::size_t cell, float at_least) {
        const std::span<const HeightLayer> layers = field_.at(cell);
        for (std::size_t k = 0; k < layers.size(); ++k) {
            if (layers[k].height >= at_least && is_ground(piece_of(cell, k))) return true;
        }
        return false;
    }

    void add_ground(std::size_t cell, Piece& piece) {
        const std::span<const HeightLayer> layers = field_.at(cell);
        for (std::size_t k = 0; k < layers.size(); ++k) {
            if (!is_ground(piece_of(cell, k))) continue;
            piece.ground_around = std::max(piece.ground_around, layers[k].height);
            piece.has_ground_around = true;
        }
    }

    const Piece& piece_of(std::size_t cell, std::size_t k) {
        return piece_[pieces_.of(field_.first(cell) + static_cast<std::uint32_t>(k))];
    }

    const LayerField& field_;
    const PassingRules& rules_;
    Pieces pieces_;
    std::vector<Piece> piece_; // by the number of its first layer
};

} // namespace

PassingReport mark_passing(const LayerField& field, const PassingRules& rules, std::vector<bool>& marked) {
    marked.assign(field.layers(), false);
    return Judge(field, rules).mark(marked);
}

} // namespace planum::scans
