// SPDX-License-Identifier: MIT
// Drawings: our engine beside Graphviz's dot (polylines and orthogonal lines) on the same records, in one run.
// Sparse series: trenches with about 1.3 reduced orders a unit; dense: about 3. Orders against dot's own: our
// second phase on dot's levels, each line on its own, as dot counts.
// Usage: bench_drawing [LARGEST [DOT_SECONDS]]: units up to LARGEST (1000), dot ended after DOT_SECONDS (600).
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>

#include "bench/bench_support.hpp"
#include "core/base/error.hpp"
#include "strat/layout/graphviz_engine.hpp"
#include "strat/layout/order_phase.hpp"
#include "strat/layout/planum_engine.hpp"
#include "strat/layout/read_back.hpp"
#include "tests/support/layout_records.hpp"

using namespace planum;
using namespace planum::strat;

namespace {

struct Row {
    double seconds = 0.0;
    std::int64_t crossings = 0;
    std::int64_t bends = 0;
    double length = 0.0; // [m] on paper, shared strokes once
    double area = 0.0;   // [m²]
    double width = 0.0;  // [m]
};

constexpr double kMetresPerPoint = 0.0254 / 72.0;

bool square(const MatrixDrawing& drawing) {
    for (const DrawnLine& line : drawing.lines) {
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            const double dx = std::abs(line.points[i].x - line.points[i - 1].x);
            const double dy = std::abs(line.points[i].y - line.points[i - 1].y);
            if (std::min(dx, dy) > 0.5) return false;
        }
    }
    return true;
}

// Uprights and levels of all lines as ink, shared strokes once.
struct Ink {
    std::vector<AxisStroke> uprights;
    std::vector<AxisStroke> levels;
};

Ink ink_of(const MatrixDrawing& drawing) {
    Ink ink;
    for (const DrawnLine& line : drawing.lines) {
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            const DrawPoint& a = line.points[i - 1];
            const DrawPoint& b = line.points[i];
            if (std::abs(a.x - b.x) < std::abs(a.y - b.y)) {
                ink.uprights.push_back({a.x, std::min(a.y, b.y), std::max(a.y, b.y)});
            } else {
                ink.levels.push_back({a.y, std::min(a.x, b.x), std::max(a.x, b.x)});
            }
        }
    }
    ink.uprights = joined_strokes(std::move(ink.uprights), 0.3);
    ink.levels = joined_strokes(std::move(ink.levels), 0.3);
    return ink;
}

std::int64_t crossings_of(const Ink& ink) {
    std::int64_t count = 0;
    for (const AxisStroke& h : ink.levels) {
        auto v = std::lower_bound(ink.uprights.begin(), ink.uprights.end(), AxisStroke{h.low + 0.5, -1e300, -1e300});
        for (; v != ink.uprights.end() && v->at < h.high - 0.5; ++v) {
            if (v->low < h.at - 0.5 && v->high > h.at + 0.5) ++count;
        }
    }
    return count;
}

Row judge(const MatrixDrawing& drawing, double seconds) {
    Row row;
    row.seconds = seconds;
    for (const DrawnLine& line : drawing.lines) row.bends += std::ssize(line.points) - 2;
    row.width = drawing.width * kMetresPerPoint;
    row.area = row.width * drawing.height * kMetresPerPoint;
    if (square(drawing)) {
        const Ink ink = ink_of(drawing);
        row.crossings = crossings_of(ink) - std::ssize(drawing.junctions);
        for (const auto* strokes : {&ink.uprights, &ink.levels}) {
            for (const AxisStroke& s : *strokes) row.length += (s.high - s.low) * kMetresPerPoint;
        }
        return row;
    }
    row.crossings = -1; // slanting lines: see the orders below
    for (const DrawnLine& line : drawing.lines) {
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            row.length += std::hypot(line.points[i].x - line.points[i - 1].x, line.points[i].y - line.points[i - 1].y) *
                          kMetresPerPoint;
        }
    }
    return row;
}

void print(const char* engine, const std::optional<Row>& row) {
    if (!row) {
        fmt::print("  {:<14} did not finish\n", engine);
        return;
    }
    const std::string crossings = row->crossings < 0 ? "-" : fmt::format("{}", row->crossings);
    fmt::print("  {:<14} {:>9.3f} {:>10} {:>8} {:>9.2f} {:>8.3f} {:>8.2f}\n", engine, row->seconds, crossings,
               row->bends, row->length, row->area, row->width);
}

std::optional<MatrixDrawing> timed(const LayoutEngine& engine, const LayoutRequest& request, double& seconds) {
    const auto start = std::chrono::steady_clock::now();
    try {
        MatrixDrawing drawing = engine.draw(request, Progress::none());
        seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return drawing;
    } catch (const Error&) {
        return std::nullopt;
    }
}

double x_at(const DrawnLine& line, double y) {
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const DrawPoint& a = line.points[i - 1];
        const DrawPoint& b = line.points[i];
        if (std::min(a.y, b.y) > y || std::max(a.y, b.y) < y || a.y == b.y) continue;
        return a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
    }
    return line.points.back().x;
}

// dot's levels and its order on them, lines included, as they run through the levels in its drawing.
LayeredGraph levels_of(const MatrixDrawing& drawing) {
    std::map<long, std::size_t> level_of_y;
    for (const DrawnBox& box : drawing.boxes) {
        if (!box.isolated) level_of_y.emplace(std::lround(box.rect.centre().y), 0);
    }
    std::vector<double> y_of;
    for (auto& [y, level] : level_of_y) {
        level = y_of.size();
        y_of.push_back(static_cast<double>(y));
    }
    LayeredGraph g;
    std::vector<std::vector<std::pair<double, std::uint32_t>>> placed(y_of.size());
    g.nodes = static_cast<std::uint32_t>(drawing.boxes.size());
    const auto level = [&](std::size_t box) { return level_of_y.at(std::lround(drawing.boxes[box].rect.centre().y)); };
    for (std::uint32_t b = 0; b < drawing.boxes.size(); ++b) {
        if (!drawing.boxes[b].isolated) placed[level(b)].push_back({drawing.boxes[b].rect.centre().x, b});
    }
    for (const DrawnLine& line : drawing.lines) {
        auto upper = static_cast<std::uint32_t>(line.later);
        for (std::size_t l = level(line.later) + 1; l < level(line.earlier); ++l) {
            placed[l].push_back({x_at(line, y_of[l]), g.nodes});
            g.edges.push_back({upper, g.nodes});
            upper = g.nodes++;
        }
        g.edges.push_back({upper, static_cast<std::uint32_t>(line.earlier)});
    }
    for (auto& nodes : placed) {
        std::stable_sort(nodes.begin(), nodes.end());
        g.layers.emplace_back();
        for (const auto& [x, node] : nodes) g.layers.back().push_back(node);
    }
    return g;
}

void compare_orders(const MatrixDrawing& drawn_by_dot) {
    LayeredGraph dot = levels_of(drawn_by_dot);
    LayeredGraph ours = dot;
    for (auto& layer : ours.layers) std::sort(layer.begin(), layer.end()); // nothing of dot's order is kept
    const auto start = std::chrono::steady_clock::now();
    order_layers(ours, {}, Progress::none());
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const std::int64_t a = count_crossings(ours);
    const std::int64_t b = count_crossings(dot);
    fmt::print("  orders on dot's levels: ours {} crossings in {:.3f} s, dot's {}: ratio {:.3f}\n", a, seconds, b,
               b > 0 ? static_cast<double>(a) / static_cast<double>(b) : 1.0);
}

void compare(const std::string& name, const model::Record& record, int dot_seconds) {
    const HarrisMatrix matrix = HarrisMatrix::build(record);
    const TableTextMeasure text;
    DrawingOptions drawing_options;
    drawing_options.bands = Bands::None;
    const LayoutRequest request{record, matrix, text, drawing_options, {}};
    fmt::print("{}: {} units, {} reduced orders\n", name, record.units.size(), matrix.reduced().size());
    fmt::print("  {:<14} {:>9} {:>10} {:>8} {:>9} {:>8} {:>8}\n", "engine", "s", "crossings", "bends", "lines m",
               "area m²", "width m");
    double seconds = 0.0;
    const double planum_seconds =
        bench::median_seconds(3, [&] { static_cast<void>(PlanumEngine().draw(request, Progress::none())); });
    const MatrixDrawing ours = PlanumEngine().draw(request, Progress::none());
    print("planum", judge(ours, planum_seconds));
    GraphvizOptions options;
    options.limits.seconds = dot_seconds;
    options.limits.megabytes = 8000;
    options.lines = GraphvizLines::Polyline;
    const auto polyline = timed(GraphvizEngine(options), request, seconds);
    print("dot polyline", polyline ? std::optional(judge(*polyline, seconds)) : std::nullopt);
    if (polyline) compare_orders(*polyline);
    options.lines = GraphvizLines::Orthogonal;
    double ortho_seconds = 0.0;
    const auto ortho = timed(GraphvizEngine(options), request, ortho_seconds);
    print("dot ortho", ortho ? std::optional(judge(*ortho, ortho_seconds)) : std::nullopt);
    const std::string faster = ortho ? fmt::format("{:.0f}", ortho_seconds / planum_seconds)
                                     : fmt::format("over {:.0f}", dot_seconds / planum_seconds);
    fmt::print("  {} times as fast as dot with orthogonal lines\n", faster);
    const ReadBack read = read_back(ours);
    fmt::print("  read back: {} orders, {} faults\n", read.orders.size(), read.faults.size());
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    if (const auto status = run_layout_worker_if_asked(argc, argv)) return *status;
    const std::size_t largest = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000;
    const int dot_seconds = argc > 2 ? std::atoi(argv[2]) : 600;
    fmt::print("{}\n", bench::machine());
    for (const std::size_t units : {100U, 300U, 500U, 700U, 1000U, 2000U, 4000U, 20000U}) {
        if (units > largest) break;
        compare("sparse", test::a_trench({.units = units, .seed = 3, .width = 20 + units / 12, .layer_reach = 8}),
                dot_seconds);
        compare(
            "dense",
            test::a_dense_record({.units = units, .orders_each = 4, .seed = 3, .depth = 20 + units / 60, .reach = 6}),
            dot_seconds);
    }
    return 0;
}
