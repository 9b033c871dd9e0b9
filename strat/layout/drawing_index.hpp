// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "strat/layout/drawing.hpp"

namespace planum::strat {

/// Answers what of a drawing is where, and where a unit is: the mouse asks the one, a selection made elsewhere
/// the other. Positions are those in MatrixDrawing::boxes and ::lines. Holds no reference to the drawing; make
/// it anew when the drawing changes. Answers in microseconds for tens of thousands of boxes.
class DrawingIndex {
  public:
    explicit DrawingIndex(const MatrixDrawing& drawing);

    /// The box under a point of the drawing [pt].
    [[nodiscard]] std::optional<std::size_t> box_at(DrawPoint at) const;

    /// All lines within `reach` [pt] of the point, nearest first, then in the drawing's order. Orders that share
    /// a stroke are all meant where it is shared, so this can be several.
    [[nodiscard]] std::vector<std::size_t> lines_at(DrawPoint at, double reach) const;

    /// The box that shows a unit, alone, merged by same_as, or folded; none if it is not drawn.
    [[nodiscard]] std::optional<std::size_t> box_of(model::UnitId unit) const;

    /// Lines below (`later` is the box) and above (`earlier` is the box) a box, ascending.
    [[nodiscard]] const std::vector<std::size_t>& lines_below(std::size_t box) const { return below_.at(box); }

    [[nodiscard]] const std::vector<std::size_t>& lines_above(std::size_t box) const { return above_.at(box); }

  private:
    struct Segment {
        DrawPoint from;
        DrawPoint to;
        std::size_t line = 0;
    };

    [[nodiscard]] std::int64_t cell_of(double x, double y) const noexcept;

    template<class Each>
    void for_cells(const DrawRect& rect, Each each) const;

    std::vector<DrawRect> rects_;
    std::vector<Segment> segments_;
    std::unordered_map<std::int64_t, std::vector<std::uint32_t>> box_cells_;
    std::unordered_map<std::int64_t, std::vector<std::uint32_t>> segment_cells_;
    std::unordered_map<model::UnitId, std::size_t> box_of_unit_;
    std::vector<std::vector<std::size_t>> below_;
    std::vector<std::vector<std::size_t>> above_;
};

} // namespace planum::strat
