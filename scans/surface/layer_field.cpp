// SPDX-License-Identifier: MIT
#include "scans/surface/layer_field.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.hpp"
#include "scans/surface/parallel.hpp"

namespace planum::scans {

namespace {

constexpr std::int32_t kTile = 256;   // cells along an edge; a cell of a tile fits 16 bits
constexpr std::int32_t kSmallest = 8; // tiles are not cut further: what they hold is thinned instead

struct Tile {
    std::int32_t row = 0;
    std::int32_t column = 0;
    std::int32_t rows = 0;
    std::int32_t columns = 0;
};

/// Layers of one tile, cell by cell in the order of its rows.
struct TileLayers {
    std::vector<HeightLayer> layers;
    std::vector<std::uint8_t> size;
    std::vector<std::uint32_t> count;
    std::vector<SidePlace> side;
    std::uint64_t points = 0;
};

struct Reading {
    std::span<const SurfaceScan> scans;
    const GridFrame& frame;
    const LayerRules& rules;
    std::size_t most = 0; // points of a tile that fit in memory
};

PlanBox box_of(const GridFrame& frame, const Tile& tile) {
    const auto edge = [&](std::int64_t cells) { return static_cast<double>(cells) * frame.cell; };
    // A hair wider: whether a point is inside is decided by its cell.
    constexpr double kHair = 1e-6;
    return {edge(frame.west + tile.column) - kHair, edge(frame.south + tile.row) - kHair,
            edge(frame.west + tile.column + tile.columns) + kHair, edge(frame.south + tile.row + tile.rows) + kHair};
}

/// Heights of a tile with 16 bits for the cell in place of the scan's; thrown together from all scans.
class Gatherer {
  public:
    Gatherer(const Reading& reading, const Tile& tile, bool may_thin)
        : reading_(reading), tile_(tile), may_thin_(may_thin), inverse_(1.0 / reading.frame.cell) {}

    /// False when there are more than fit.
    bool gather() {
        const PlanBox box = box_of(reading_.frame, tile_);
        for (std::size_t scan = 0; scan < reading_.scans.size() && !full_; ++scan) {
            reading_.scans[scan].points->over(
                box, [&](const PointBlock& block) { add(block, static_cast<std::uint16_t>(scan)); });
        }
        return !full_;
    }

    /// Grouped by cell: `begin` gets one more entry than there are cells.
    std::vector<PackedHeight> grouped(std::vector<std::uint32_t>& begin) {
        const std::size_t cells = static_cast<std::size_t>(tile_.rows) * static_cast<std::size_t>(tile_.columns);
        begin.assign(cells + 1, 0);
        for (const std::uint16_t cell : cells_) ++begin[cell + 1U];
        for (std::size_t i = 1; i <= cells; ++i) begin[i] += begin[i - 1];
        std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
        std::vector<PackedHeight> grouped(heights_.size());
        for (std::size_t i = 0; i < heights_.size(); ++i) grouped[next[cells_[i]]++] = heights_[i];
        return grouped;
    }

  private:
    static std::uint8_t part_of_cell(double cells) {
        return static_cast<std::uint8_t>(std::min(255.0, 256.0 * (cells - std::floor(cells))));
    }

    void add(const PointBlock& block, std::uint16_t scan) {
        if (full_) return;
        for (std::size_t i = 0; i < block.size(); ++i) {
            if (block.validity[i] != Validity::Valid) continue;
            const double x = block.x[i] * inverse_;
            const double y = block.y[i] * inverse_;
            const std::int64_t column = static_cast<std::int64_t>(std::floor(x)) - reading_.frame.west - tile_.column;
            const std::int64_t row = static_cast<std::int64_t>(std::floor(y)) - reading_.frame.south - tile_.row;
            if (column < 0 || row < 0 || column >= tile_.columns || row >= tile_.rows) continue;
            if (!(block.z[i] > kHeightOrigin && block.z[i] < kHeightCeiling)) continue;
            if (heights_.size() >= reading_.most) {
                full_ = !may_thin_;
                return;
            }
            cells_.push_back(static_cast<std::uint16_t>(row * tile_.columns + column));
            heights_.push_back(pack_height(block.z[i], scan, part_of_cell(x), part_of_cell(y)));
        }
    }

    const Reading& reading_;
    const Tile tile_;
    const bool may_thin_;
    const double inverse_;
    std::vector<std::uint16_t> cells_;
    std::vector<PackedHeight> heights_;
    bool full_ = false;
};

void put(const Tile& whole, const Tile& part, const TileLayers& from, TileLayers& to,
         std::vector<std::vector<HeightLayer>>& by_cell) {
    std::size_t at = 0;
    for (std::int32_t r = 0; r < part.rows; ++r) {
        for (std::int32_t c = 0; c < part.columns; ++c) {
            const auto cell =
                static_cast<std::size_t>((part.row - whole.row + r) * whole.columns + (part.column - whole.column + c));
            const auto source = static_cast<std::size_t>(r * part.columns + c);
            to.size[cell] = from.size[source];
            to.count[cell] = from.count[source];
            to.side[cell] = from.side[source];
            by_cell[cell].assign(from.layers.begin() + static_cast<std::ptrdiff_t>(at),
                                 from.layers.begin() + static_cast<std::ptrdiff_t>(at + from.size[source]));
            at += from.size[source];
        }
    }
    to.points += from.points;
}

TileLayers read_tile(const Reading& reading, const Tile& tile);

TileLayers read_in_four(const Reading& reading, const Tile& tile) {
    const std::size_t cells = static_cast<std::size_t>(tile.rows) * static_cast<std::size_t>(tile.columns);
    TileLayers whole;
    whole.size.resize(cells);
    whole.count.resize(cells);
    whole.side.resize(cells);
    std::vector<std::vector<HeightLayer>> by_cell(cells);
    const std::int32_t half_rows = (tile.rows + 1) / 2;
    const std::int32_t half_columns = (tile.columns + 1) / 2;
    for (const bool north : {false, true}) {
        for (const bool east : {false, true}) {
            const Tile part{tile.row + (north ? half_rows : 0), tile.column + (east ? half_columns : 0),
                            north ? tile.rows - half_rows : half_rows,
                            east ? tile.columns - half_columns : half_columns};
            if (part.rows > 0 && part.columns > 0) put(tile, part, read_tile(reading, part), whole, by_cell);
        }
    }
    for (const std::vector<HeightLayer>& layers : by_cell)
        whole.layers.insert(whole.layers.end(), layers.begin(), layers.end());
    return whole;
}

std::optional<TileLayers> try_tile(const Reading& reading, const Tile& tile, bool may_thin) {
    std::vector<std::uint32_t> begin;
    std::vector<PackedHeight> heights;
    {
        Gatherer gatherer(reading, tile, may_thin);
        if (!gatherer.gather()) return std::nullopt;
        heights = gatherer.grouped(begin);
    }
    TileLayers result;
    result.points = heights.size();
    const std::size_t cells = begin.size() - 1;
    result.size.resize(cells);
    result.count.resize(cells);
    result.side.resize(cells);
    for (std::size_t cell = 0; cell < cells; ++cell) {
        const std::span<PackedHeight> there(heights.data() + begin[cell], begin[cell + 1] - begin[cell]);
        std::sort(there.begin(), there.end());
        const std::size_t before = result.layers.size();
        find_layers(there, reading.rules, result.layers);
        result.size[cell] = static_cast<std::uint8_t>(result.layers.size() - before);
        result.count[cell] = static_cast<std::uint32_t>(there.size());
        result.side[cell] = side_place(there, reading.rules);
    }
    return result;
}

TileLayers read_tile(const Reading& reading, const Tile& tile) {
    const bool smallest = std::max(tile.rows, tile.columns) <= kSmallest;
    if (std::optional<TileLayers> result = try_tile(reading, tile, smallest)) return std::move(*result);
    return read_in_four(reading, tile);
}

std::vector<Tile> tiles_of(const GridFrame& frame) {
    std::vector<Tile> tiles;
    for (std::int32_t row = 0; row < frame.rows; row += kTile) {
        for (std::int32_t column = 0; column < frame.columns; column += kTile) {
            tiles.push_back({row, column, std::min(kTile, frame.rows - row), std::min(kTile, frame.columns - column)});
        }
    }
    return tiles;
}

} // namespace

void LayerField::remove(const std::vector<bool>& marked) {
    std::vector<HeightLayer> kept;
    kept.reserve(layers_.size());
    // Layers lie tile by tile, so the cells are walked in the order of their first layers.
    std::vector<std::uint32_t> place(layers_.size() + 1, 0);
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        place[i] = static_cast<std::uint32_t>(kept.size());
        if (!marked[i]) kept.push_back(layers_[i]);
    }
    place[layers_.size()] = static_cast<std::uint32_t>(kept.size());
    for (std::size_t cell = 0; cell < first_.size(); ++cell) {
        const std::uint32_t begin = first_[cell];
        const std::uint32_t end = begin + size_[cell];
        first_[cell] = place[begin];
        size_[cell] = static_cast<std::uint8_t>(place[end] - place[begin]);
    }
    layers_ = std::move(kept);
}

LayerField collect_layers(std::span<const SurfaceScan> scans, const GridFrame& frame, const LayerRules& rules,
                          std::uint64_t memory, int threads, Progress& progress) {
    if (scans.size() > 65535) throw Error(ErrorCode::BadInput, "a surface of more than 65,535 scans");
    constexpr std::uint64_t kBytesAPoint = 2 * sizeof(PackedHeight) + sizeof(std::uint16_t);
    const auto share = memory / static_cast<std::uint64_t>(std::max(threads, 1)) / kBytesAPoint;
    const Reading reading{scans, frame, rules, std::max<std::size_t>(share, 1000)};
    const std::vector<Tile> tiles = tiles_of(frame);
    std::vector<TileLayers> done(tiles.size());
    for_each_part(tiles.size(), threads, progress, [&](std::size_t i) { done[i] = read_tile(reading, tiles[i]); });

    LayerField field;
    field.frame = frame;
    field.count.resize(frame.cells());
    field.side.resize(frame.cells());
    field.first_.resize(frame.cells());
    field.size_.resize(frame.cells());
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        const Tile& tile = tiles[t];
        auto at = static_cast<std::uint32_t>(field.layers_.size());
        for (std::int32_t r = 0; r < tile.rows; ++r) {
            for (std::int32_t c = 0; c < tile.columns; ++c) {
                const std::size_t cell = frame.at(tile.row + r, tile.column + c);
                const auto source = static_cast<std::size_t>(r * tile.columns + c);
                field.first_[cell] = at;
                field.size_[cell] = done[t].size[source];
                field.count[cell] = done[t].count[source];
                field.side[cell] = done[t].side[source];
                at += done[t].size[source];
            }
        }
        field.layers_.insert(field.layers_.end(), done[t].layers.begin(), done[t].layers.end());
        field.points += done[t].points;
        done[t] = {};
    }
    return field;
}

} // namespace planum::scans
