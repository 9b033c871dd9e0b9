// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/diagnostic.hpp"
#include "core/model/ids.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::strat {

/// A point of a drawing: x to the right, y downwards [pt].
struct DrawPoint {
    double x = 0.0;
    double y = 0.0;

    friend bool operator==(const DrawPoint&, const DrawPoint&) = default;
};

/// A rectangle of a drawing [pt]; (x, y) is its upper left corner.
struct DrawRect {
    double x = 0.0;
    double y = 0.0;
    double width = 0.0;
    double height = 0.0;

    [[nodiscard]] double right() const noexcept { return x + width; }

    [[nodiscard]] double bottom() const noexcept { return y + height; }

    [[nodiscard]] DrawPoint centre() const noexcept { return {x + width / 2.0, y + height / 2.0}; }

    friend bool operator==(const DrawRect&, const DrawRect&) = default;
};

/// What outline a box has. Outlines differ without colour, so that a copy in black and white still says
/// what each unit is.
enum class BoxShape { Deposit, Cut, Structure, Interface, Feature, Skeleton, Natural, Void, Unknown, Folded };

/// What a drawing points out.
enum class Mark { None, Added, Removed, Changed, Problem };

/// One box: a unit, several merged by same_as, or (folded) a whole phase.
struct DrawnBox {
    std::string id; ///< valid as an XML id, unique in the drawing: `unit-1042`, of its first unit
    std::vector<model::UnitId> units;
    std::vector<std::string> names;    ///< of the units, as texts call them
    std::vector<std::string> unit_ids; ///< of the units, likewise XML ids; a folded box has one of its own beside them
    std::vector<std::string> links;    ///< of the units; empty: none
    std::vector<std::string> lines;    ///< the label, line by line, drawn centred
    std::vector<double> line_widths;   ///< of each line [pt], as measured
    std::string title;                 ///< a sentence for tool tips and screen readers
    BoxShape shape = BoxShape::Unknown;
    DrawRect rect;
    double text_size = 9.0; ///< [pt]
    Mark mark = Mark::None;
    bool in_cycle = false;
    bool inner_cycle = false; ///< a contradiction inside the box, which no line can show: gets a mark
    bool has_finds = false;
    bool mentioned_only = false; ///< named in relations, no sheet of its own
    bool isolated = false;       ///< in no order, and contemporary with none
};

/// One order, drawn from the lower edge of the later box to the upper edge of the earlier one. Lines of
/// different orders may share segments only where all boxes that the shared net touches from above are
/// later than all that it touches from below (see read_back).
struct DrawnLine {
    std::string id;        ///< `order-1042-1017`
    std::size_t later = 0; ///< position in MatrixDrawing::boxes
    std::size_t earlier = 0;
    std::vector<DrawPoint> points;
    std::string title; ///< `1042 cuts 1017`
    std::string kind;  ///< words of the relations that justify it: `cuts`, `covers fills`
    Mark mark = Mark::None;
    bool in_cycle = false;
    bool uncertain = false; ///< only uncertain relations say so: dashed
    bool through = false;   ///< holds by way of units that are not drawn: dotted
    bool upwards = false;   ///< the later box stands below: gets an arrow head
    DrawPoint arrow;        ///< middle of that head, see place_arrows(); without meaning on other lines
    model::EvidenceVerdict verdict =
        model::EvidenceVerdict::None; ///< other than None: drawn as that says, see show_evidence()
};

/// A phase or period as a strip across the drawing, with its heading at the left.
struct DrawnBand {
    std::string id;
    std::string heading;
    DrawRect rect;
    bool shaded = false; ///< every second one
};

/// A frame around the units of a group.
struct DrawnFrame {
    std::string id;
    std::string heading;
    DrawRect rect;
};

enum class TextAnchor { Start, Middle, End };

/// Free text: the title, headings, legend entries. `at` is on the base line.
struct DrawnText {
    std::string role; ///< title, subtitle, heading, legend, note
    std::string text;
    DrawPoint at;
    double size = 9.0;  ///< [pt]
    double width = 0.0; ///< [pt], as measured
    TextAnchor anchor = TextAnchor::Start;
    bool bold = false;
    bool upright = false; ///< read from below: turned by −90° around `at`
};

/// A sample of a box or a line in the legend, beside a DrawnText of role `legend`.
struct LegendSample {
    enum class Kind { Box, Line };
    Kind kind = Kind::Box;
    DrawnBox box;
    DrawnLine line;
};

/// Everything that is drawn, as geometry: SVG, PDF, PNG and the desktop's view all show this and only
/// this. All lengths in points (1/72 inch), y down, the page from (0, 0) to (width, height).
struct MatrixDrawing {
    std::string title;
    std::string description; ///< a sentence for screen readers
    std::string engine;
    double width = 0.0;
    double height = 0.0;
    std::vector<DrawnBox> boxes;
    std::vector<DrawnLine> lines;
    std::vector<DrawPoint> junctions; ///< where four segments of one net meet: a dot, to tell it from a crossing
    std::vector<DrawnBand> bands;
    std::vector<DrawnFrame> frames;
    std::vector<DrawnText> texts;
    std::vector<LegendSample> legend;
};

/// Outline of a box's shape as a closed polygon, last point not repeated, and strokes inside it that
/// belong to the shape (double sides, the bar of a cut).
struct BoxOutline {
    std::vector<DrawPoint> polygon;
    std::vector<std::vector<DrawPoint>> strokes;
    double stroke_width = 0.8; ///< [pt]
    bool dashed = false;
};

[[nodiscard]] BoxOutline outline_of(const DrawnBox& box);

/// A stroke along one axis: `at` across it, from `low` to `high` along it [pt].
struct AxisStroke {
    double at = 0.0;
    double low = 0.0;
    double high = 0.0;

    friend auto operator<=>(const AxisStroke&, const AxisStroke&) = default;
};

/// Strokes of one axis, sorted, those made one that lie within `tolerance` of each other across and overlap
/// or touch along.
[[nodiscard]] std::vector<AxisStroke> joined_strokes(std::vector<AxisStroke> strokes, double tolerance);

/// Words of the enumerators, as SVG classes: `deposit`, `cut`, …; `added`, …; empty for Mark::None.
[[nodiscard]] std::string_view to_word(BoxShape shape) noexcept;
[[nodiscard]] std::string_view to_word(Mark mark) noexcept;
[[nodiscard]] std::string_view to_word(model::EvidenceVerdict verdict) noexcept; ///< `confirmed`, …; empty for None

} // namespace planum::strat
