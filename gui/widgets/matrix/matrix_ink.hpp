// SPDX-License-Identifier: MIT
#pragma once

#include <QLineF>
#include <QRectF>

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "strat/layout/drawing.hpp"

class QPainter;

namespace planum::gui {

/// A drawing made ready for painting on a screen: strokes that several orders share joined once, bounds of
/// everything, so that a frame costs what is seen of it. Holds a reference to the drawing.
class MatrixInk {
  public:
    explicit MatrixInk(const strat::MatrixDrawing& drawing);

    /// What is pointed out: positions in the drawing's boxes and lines.
    struct Pointed {
        std::size_t selected = kNone; ///< box
        std::size_t hovered = kNone;  ///< box
        const std::set<std::size_t>* proof_boxes = nullptr;
        const std::set<std::size_t>* proof_lines = nullptr;
    };

    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    /// Paints the part `seen` [pt]; the painter is scaled to points, `scale` pixels each. Labels, outlines and
    /// antialiasing are left out where they would be too small to see.
    void paint(QPainter& painter, const QRectF& seen, double scale) const;
    /// Paints what is pointed out over it; a proof dims the rest.
    void paint_pointed(QPainter& painter, const QRectF& seen, double scale, const Pointed& pointed) const;

  private:
    struct Stroke {
        std::uint32_t colour = 0;
        double width = 0.0;
        QLineF line;
    };

    void paint_ground(QPainter& painter, const QRectF& seen) const;
    void paint_lines(QPainter& painter, const QRectF& seen, double scale) const;
    void paint_box(QPainter& painter, const strat::DrawnBox& box, double scale) const;
    void paint_words(QPainter& painter, const QRectF& seen, double scale) const;
    void paint_line(QPainter& painter, const strat::DrawnLine& line, double scale, double stronger) const;

    const strat::MatrixDrawing* drawing_;
    std::vector<Stroke> strokes_;          ///< solid, upright or level, sorted by look
    std::vector<std::size_t> other_lines_; ///< dashed, dotted, slanting
    std::vector<QRectF> other_bounds_;
    std::vector<std::size_t> arrows_;
};

} // namespace planum::gui
