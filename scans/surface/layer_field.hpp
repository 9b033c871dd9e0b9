// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.hpp"
#include "scans/surface/cell_layers.hpp"
#include "scans/surface/point_source.hpp"
#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

/// The layers of all cells of a frame, and how many points each cell holds.
class LayerField {
  public:
    GridFrame frame;
    std::vector<std::uint32_t> count; ///< points of a cell, those of no layer included
    std::vector<SidePlace> side;      ///< of a cell; see side_place()
    std::uint64_t points = 0;         ///< within the frame

    [[nodiscard]] std::span<HeightLayer> at(std::size_t cell) noexcept {
        return {layers_.data() + first_[cell], size_[cell]};
    }

    [[nodiscard]] std::span<const HeightLayer> at(std::size_t cell) const noexcept {
        return {layers_.data() + first_[cell], size_[cell]};
    }

    /// Number of the first layer of a cell among those of all cells, so that layers can be counted with.
    [[nodiscard]] std::uint32_t first(std::size_t cell) const noexcept { return first_[cell]; }

    [[nodiscard]] std::size_t layers() const noexcept { return layers_.size(); }

    /// Leaves out the layers that are marked, by their numbers of before.
    void remove(const std::vector<bool>& marked);

  private:
    friend LayerField collect_layers(std::span<const SurfaceScan>, const GridFrame&, const LayerRules&, std::uint64_t,
                                     int, Progress&);
    std::vector<HeightLayer> layers_; // of a cell one after the other, from low to high
    std::vector<std::uint32_t> first_;
    std::vector<std::uint8_t> size_;
};

/// Reads the points tile by tile; a tile that holds more than fits in its share of `memory` [bytes] is cut in four.
/// The result does not depend on memory or threads.
[[nodiscard]] LayerField collect_layers(std::span<const SurfaceScan> scans, const GridFrame& frame,
                                        const LayerRules& rules, std::uint64_t memory, int threads, Progress& progress);

} // namespace planum::scans
