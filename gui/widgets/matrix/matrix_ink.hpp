// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QLineF>
#include <QRectF>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <vector>

#include "gui/viewmodels/matrix_model.hpp"
#include "strat/layout/drawing.hpp"
#include "strat/layout/drawing_colours.hpp"

class QPainter;

namespace planum::gui {

/// A drawing made ready for painting on a screen: strokes that several orders share joined once, bounds of
/// everything, so that a frame costs what is seen of it. Making one takes a while for a large drawing and may happen in
/// any thread; painting then reads it only.
class MatrixInk {
  public:
    /// `verdicts`: what the evidence says about each line; empty: lines look as on paper.
    explicit MatrixInk(std::shared_ptr<const strat::MatrixDrawing> drawing, LineVerdicts verdicts = {});

    /// A picture of the whole, for scales at which the drawing is smaller than it; null where the drawing is small
    /// enough to be painted each time.
    [[nodiscard]] const QImage& overview() const noexcept { return overview_; }

    /// Pixels a point of overview().
    [[nodiscard]] double overview_scale() const noexcept { return overview_scale_; }

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

    [[nodiscard]] strat::StrokeStyle look(std::size_t line) const;
    void make_overview();
    void paint_ground(QPainter& painter, const QRectF& seen) const;
    void paint_lines(QPainter& painter, const QRectF& seen, double scale) const;
    void paint_box(QPainter& painter, const strat::DrawnBox& box, double scale) const;
    void paint_words(QPainter& painter, const QRectF& seen, double scale) const;
    static void paint_line(QPainter& painter, const strat::DrawnLine& line, const strat::StrokeStyle& style,
                           double scale);

    std::shared_ptr<const strat::MatrixDrawing> drawing_;
    LineVerdicts verdicts_;
    QImage overview_;
    double overview_scale_ = 0.0;
    std::vector<Stroke> strokes_;          ///< solid, upright or level, sorted by look
    std::vector<std::size_t> other_lines_; ///< dashed, dotted, slanting
    std::vector<QRectF> other_bounds_;
    std::vector<std::size_t> arrows_;
};

} // namespace planum::gui
