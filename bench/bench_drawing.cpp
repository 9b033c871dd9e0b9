// SPDX-License-Identifier: MIT
// Drawings: our engine beside Graphviz's dot (polylines and orthogonal lines) on the same records, in one run.
// Sparse series: trenches with about 1.3 reduced orders a unit; dense: about 3. Orders against dot's own: our
// second phase on dot's levels, each line on its own, as dot counts.
// Each drawing is made in a process of its own, so that its memory can be told. "bends" are those of each order's
// way, summed; "led" the same with every line led from the lower edge of a box to the upper edge of another, as Harris
// draws them: one that dot lets out at a side saves a bend there; "corners" those that are drawn, strokes that orders
// share counted once, as is the length.
// Up to 1,000 units the time is the median of 15 runs of ours and of 3 of dot's, beyond of 3 and 1.
// The real matrix of Çatalhöyük comes first where it is present.
// Usage: bench_drawing [LARGEST [DOT_SECONDS [DOT_LARGEST]]]: units up to LARGEST (20,000), dot ended after
// DOT_SECONDS (600) and left out beyond DOT_LARGEST units (20,000).
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

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
#include "tests/support/imported_records.hpp"
#include "tests/support/layout_records.hpp"
#include "tests/support/real_data.hpp"

using namespace planum;
using namespace planum::strat;

namespace {

// What is told of a drawing; plain, so that it can come through a pipe.
struct Row {
    bool drawn = false;
    double seconds = 0.0;
    double megabytes = 0.0;
    std::int64_t crossings = 0;
    std::int64_t bends = 0;
    std::int64_t led = 0;
    std::int64_t corners = 0;
    double length = 0.0; // [m] on paper, shared strokes once
    double area = 0.0;   // [m²]
    double width = 0.0;  // [m]
    // Read back: orders and faults.
    std::int64_t read = 0;
    std::int64_t faults = 0;
    // On dot's levels: crossings of our order, of dot's, and our time.
    std::int64_t our_order = -1;
    std::int64_t dot_order = -1;
    double order_seconds = 0.0;
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

// Ends of levels on ends of uprights.
std::int64_t corners_of(const Ink& ink) {
    std::int64_t count = 0;
    for (const AxisStroke& h : ink.levels) {
        for (const double x : {h.low, h.high}) {
            auto v = std::lower_bound(ink.uprights.begin(), ink.uprights.end(), AxisStroke{x - 0.5, -1e300, -1e300});
            for (; v != ink.uprights.end() && v->at < x + 0.5; ++v) {
                if (std::abs(v->low - h.at) >= 0.5 && std::abs(v->high - h.at) >= 0.5) continue;
                ++count;
                break;
            }
        }
    }
    return count;
}

// Bends of a line of uprights and levels, led from edge to edge. From an upright to an upright their number is even: a
// line out of a side counts the bend that it saves there, one out of two sides (level, upright, level) no other way
// than the one with the middle piece lying, which has as many.
std::int64_t bends_led(const DrawnLine& line) {
    const std::int64_t bends = std::ssize(line.points) - 2;
    return bends + bends % 2;
}

Row judge(const MatrixDrawing& drawing) {
    Row row;
    row.drawn = true;
    for (const DrawnLine& line : drawing.lines) {
        row.bends += std::ssize(line.points) - 2;
        row.led += bends_led(line);
    }
    row.width = drawing.width * kMetresPerPoint;
    row.area = row.width * drawing.height * kMetresPerPoint;
    if (square(drawing)) {
        const Ink ink = ink_of(drawing);
        row.crossings = crossings_of(ink) - std::ssize(drawing.junctions);
        row.corners = corners_of(ink);
        for (const auto* strokes : {&ink.uprights, &ink.levels}) {
            for (const AxisStroke& s : *strokes) row.length += (s.high - s.low) * kMetresPerPoint;
        }
        return row;
    }
    row.crossings = -1; // slanting lines: see the orders below
    row.corners = row.bends;
    row.led = row.bends;
    for (const DrawnLine& line : drawing.lines) {
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            row.length += std::hypot(line.points[i].x - line.points[i - 1].x, line.points[i].y - line.points[i - 1].y) *
                          kMetresPerPoint;
        }
    }
    return row;
}

double peak_megabytes(int who) {
    rusage usage{};
    getrusage(who, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

// Runs `work` in a forked process and returns what it told; nothing drawn if it failed.
template<class Work>
Row in_child(Work work) {
    int ends[2];
    if (pipe(ends) != 0) return {};
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        Row row;
        try {
            row = work();
        } catch (const Error&) {
            row.drawn = false;
        }
        const bool told = write(ends[1], &row, sizeof row) == static_cast<ssize_t>(sizeof row);
        _exit(told ? 0 : 1);
    }
    close(ends[1]);
    Row row;
    if (read(ends[0], &row, sizeof row) != static_cast<ssize_t>(sizeof row)) row = {};
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return row;
}

void print(const char* engine, const Row& row) {
    if (!row.drawn) {
        fmt::print("  {:<14} did not finish\n", engine);
        return;
    }
    const std::string crossings = row.crossings < 0 ? "-" : fmt::format("{}", row.crossings);
    fmt::print("  {:<14} {:>9.3f} {:>6.0f} {:>10} {:>8} {:>8} {:>8} {:>9.2f} {:>8.3f} {:>8.2f}\n", engine, row.seconds,
               row.megabytes, crossings, row.bends, row.led, row.corners, row.length, row.area, row.width);
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

void compare_orders(const MatrixDrawing& drawn_by_dot, Row& row) {
    LayeredGraph dot = levels_of(drawn_by_dot);
    LayeredGraph ours = dot;
    for (auto& layer : ours.layers) std::sort(layer.begin(), layer.end()); // nothing of dot's order is kept
    const auto start = std::chrono::steady_clock::now();
    order_layers(ours, {}, Progress::none());
    row.order_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    row.our_order = count_crossings(ours);
    row.dot_order = count_crossings(dot);
}

double ratio(double a, double b) { return b > 0.0 ? a / b : a > 0.0 ? a : 1.0; }

// What takes some milliseconds is told by the median of more runs.
int runs_for(const LayoutRequest& request) { return request.record.units.size() <= 1000 ? 15 : 3; }

Row drawn_by_planum(const LayoutRequest& request) {
    return in_child([&] {
        const double before = peak_megabytes(RUSAGE_SELF);
        const double seconds = bench::median_seconds(
            runs_for(request), [&] { static_cast<void>(PlanumEngine().draw(request, Progress::none())); });
        const double after = peak_megabytes(RUSAGE_SELF);
        const MatrixDrawing drawing = PlanumEngine().draw(request, Progress::none());
        Row row = judge(drawing);
        row.seconds = seconds;
        row.megabytes = after - before;
        const ReadBack read = read_back(drawing);
        row.read = std::ssize(read.orders);
        row.faults = std::ssize(read.faults);
        return row;
    });
}

Row drawn_by_dot(const LayoutRequest& request, GraphvizLines lines, int dot_seconds) {
    return in_child([&] {
        GraphvizOptions options;
        options.limits.seconds = dot_seconds;
        options.limits.megabytes = 8000;
        options.lines = lines;
        MatrixDrawing drawing;
        const double seconds = bench::median_seconds(
            runs_for(request) > 3 ? 3 : 1, [&] { drawing = GraphvizEngine(options).draw(request, Progress::none()); });
        Row row = judge(drawing);
        row.seconds = seconds;
        row.megabytes = peak_megabytes(RUSAGE_CHILDREN);
        if (lines == GraphvizLines::Polyline) compare_orders(drawing, row);
        return row;
    });
}

void compare(const std::string& name, const model::Record& record, int dot_seconds, bool with_dot) {
    const HarrisMatrix matrix = HarrisMatrix::build(record);
    const TableTextMeasure text;
    DrawingOptions drawing_options;
    drawing_options.bands = Bands::None;
    const LayoutRequest request{record, matrix, text, drawing_options, {}};
    fmt::print("{}: {} units, {} reduced orders\n", name, record.units.size(), matrix.reduced().size());
    fmt::print("  {:<14} {:>9} {:>6} {:>10} {:>8} {:>8} {:>8} {:>9} {:>8} {:>8}\n", "engine", "s", "MB", "crossings",
               "bends", "led", "corners", "lines m", "area m²", "width m");
    const Row planum = drawn_by_planum(request);
    print("planum", planum);
    fmt::print("  read back: {} orders, {} faults\n", planum.read, planum.faults);
    if (!with_dot) return;
    const Row polyline = drawn_by_dot(request, GraphvizLines::Polyline, dot_seconds);
    print("dot polyline", polyline);
    const Row ortho = drawn_by_dot(request, GraphvizLines::Orthogonal, dot_seconds);
    print("dot ortho", ortho);
    if (polyline.drawn) {
        fmt::print("  orders on dot's levels: ours {} crossings in {:.3f} s, dot's {}: ratio {:.3f}\n",
                   polyline.our_order, polyline.order_seconds, polyline.dot_order,
                   ratio(static_cast<double>(polyline.our_order), static_cast<double>(polyline.dot_order)));
    }
    if (!ortho.drawn) {
        fmt::print("  over {:.0f} times as fast as dot with orthogonal lines\n", dot_seconds / planum.seconds);
        return;
    }
    fmt::print("  {:.1f} times as fast as dot with orthogonal lines; crossings × {:.2f}, bends × {:.2f}, led × {:.2f}, "
               "corners × {:.2f}, length × {:.2f}, area × {:.2f}, width × {:.2f}\n",
               ortho.seconds / planum.seconds,
               ratio(static_cast<double>(planum.crossings), static_cast<double>(ortho.crossings)),
               ratio(static_cast<double>(planum.bends), static_cast<double>(ortho.bends)),
               ratio(static_cast<double>(planum.led), static_cast<double>(ortho.led)),
               ratio(static_cast<double>(planum.corners), static_cast<double>(ortho.corners)),
               ratio(planum.length, ortho.length), ratio(planum.area, ortho.area), ratio(planum.width, ortho.width));
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    if (const auto status = run_layout_worker_if_asked(argc, argv)) return *status;
    const std::size_t largest = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 20'000;
    const int dot_seconds = argc > 2 ? std::atoi(argv[2]) : 600;
    const std::size_t dot_largest = argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 20'000;
    fmt::print("{}\n", bench::machine());
    if (const auto real = test::real_data("matrix/hm/bldg-1-5"))
        compare("Çatalhöyük", test::read_record(*real), dot_seconds, dot_largest > 0);
    for (const std::size_t units : {100U, 300U, 500U, 700U, 1000U, 2000U, 4000U, 10'000U, 20'000U}) {
        if (units > largest) break;
        const bool with_dot = units <= dot_largest;
        compare("sparse", test::a_trench({.units = units, .seed = 3, .width = 20 + units / 12, .layer_reach = 8}),
                dot_seconds, with_dot);
        compare(
            "dense",
            test::a_dense_record({.units = units, .orders_each = 4, .seed = 3, .depth = 20 + units / 60, .reach = 6}),
            dot_seconds, with_dot);
    }
    return 0;
}
