// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.hpp"
#include "core/model/record.hpp"
#include "strat/layout/drawing.hpp"
#include "strat/layout/drawing_words.hpp"
#include "strat/layout/text_measure.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::strat {

/// Strips across the drawing. Automatic: phases, else periods, if four of five drawn units have one, there
/// are at most sixteen with three units or so each, each has a rank or years, and no more than one order in
/// twenty runs against them.
enum class Bands { Automatic, None, Phases, Periods };

/// What is drawn as one box in place of its units.
enum class Fold { None, Phases, Periods, Groups };

/// Frames around the units of top-level groups; units of one group then stand together.
enum class Frames { None, Groups };

enum class Labels { Numbers, NumbersAndTitles };

struct UnitMark {
    model::UnitId unit;
    Mark mark = Mark::None;
};

struct OrderMark {
    model::UnitId later;
    model::UnitId earlier;
    Mark mark = Mark::None;
};

/// What shall be drawn of a matrix, and how. Choices of units (area, around, only) narrow each other.
struct DrawingOptions {
    std::string title;               ///< empty: the project's name
    std::string subtitle;            ///< day, area, interpretation, as the caller says; empty: none
    std::string area;                ///< name of an area; empty: the whole site
    model::UnitId around;            ///< nil: no neighbourhood
    int around_steps = 2;            ///< immediate orders up and down from `around`
    std::vector<model::UnitId> only; ///< these units (those with problems, those that changed); empty: all
    Bands bands = Bands::Automatic;
    Fold fold = Fold::None;
    Frames frames = Frames::None;
    Labels labels = Labels::Numbers;
    std::vector<UnitMark> marks;
    std::vector<OrderMark> order_marks;
    DrawingWords words;
    std::string unit_link; ///< where a unit leads to, as `units/{unit}.html`, see unit_link_of(); empty: no links
};

/// Where a unit stood in an earlier drawing.
struct PreviousPosition {
    model::UnitId unit;
    DrawPoint centre;
};

/// How an order ran in it, named by one unit of either box.
struct PreviousLine {
    model::UnitId later;
    model::UnitId earlier;
    std::vector<DrawPoint> points; ///< from the later to the earlier
};

/// An earlier drawing, as far as a new one holds to it; engines move as little as they can.
struct PreviousDrawing {
    std::vector<PreviousPosition> units;
    std::vector<PreviousLine> lines;
};

/// Record and matrix belong together; all three must outlive the call.
struct LayoutRequest {
    const model::Record& record;
    const HarrisMatrix& matrix;
    const TextMeasure& text;
    DrawingOptions options;
    PreviousDrawing previous;
};

/// Turns a matrix into geometry. Same request, same drawing.
class LayoutEngine {
  public:
    virtual ~LayoutEngine() = default;

    [[nodiscard]] virtual std::string_view name() const noexcept = 0;

    /// Throws NotFound for an area or unit that the record lacks, Cancelled when asked to stop, and
    /// whatever the engine's own limits call for (see there).
    [[nodiscard]] virtual MatrixDrawing draw(const LayoutRequest& request, Progress& progress) const = 0;
};

/// The places of an earlier drawing, for LayoutRequest::previous; isolated boxes are left out.
[[nodiscard]] PreviousDrawing places_of(const MatrixDrawing& drawing);

} // namespace planum::strat
