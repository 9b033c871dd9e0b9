// SPDX-License-Identifier: MIT
#include "strat/layout/graphviz_engine.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/layout/dot_writer.hpp"
#include "strat/layout/drawing_page.hpp"

namespace planum::strat {

namespace {

[[noreturn]] void refuse(std::string_view line) {
    throw Error(ErrorCode::Internal,
                fmt::format("graphviz answered with a line that is no position: {}", line.substr(0, 80)));
}

std::vector<double> numbers_of(std::span<const std::string_view> words, std::string_view line) {
    std::vector<double> numbers;
    for (const std::string_view word : words) {
        if (word.empty() || word == "s" || word == "e") continue;
        const auto value = text::parse_double(word);
        if (!value || !std::isfinite(*value)) refuse(line);
        numbers.push_back(*value);
    }
    return numbers;
}

std::size_t index_of(std::string_view word, std::size_t count, std::string_view line) {
    const auto value = text::parse_integer(word);
    if (!value || *value < 0 || static_cast<std::size_t>(*value) >= count) refuse(line);
    return static_cast<std::size_t>(*value);
}

// Graphviz's curves are Bézier pieces of three points each; with straight pieces every third is a corner.
std::vector<DrawPoint> corners(const std::vector<double>& xy) {
    std::vector<DrawPoint> points;
    for (std::size_t i = 0; i + 1 < xy.size(); i += 6) {
        const DrawPoint p{xy[i], -xy[i + 1]};
        if (points.empty() || points.back() != p) points.push_back(p);
    }
    return points;
}

void take_positions(MatrixDrawing& drawing, std::string_view answer) {
    for (const std::string_view line : text::split(answer, '\n')) {
        const std::vector<std::string_view> words = text::split(line, ' ');
        if (words.size() < 3) continue;
        const std::span<const std::string_view> rest = std::span(words).subspan(2);
        if (words[0] == "n") {
            if (words[1].size() < 2) refuse(line);
            DrawnBox& box = drawing.boxes[index_of(words[1].substr(1), drawing.boxes.size(), line)];
            const std::vector<double> xy = numbers_of(rest, line);
            if (xy.size() < 2) refuse(line);
            box.rect.x = xy[0] - box.rect.width / 2.0;
            box.rect.y = -xy[1] - box.rect.height / 2.0;
        } else if (words[0] == "e") {
            drawing.lines[index_of(words[1], drawing.lines.size(), line)].points = corners(numbers_of(rest, line));
        }
    }
}

} // namespace

MatrixDrawing GraphvizEngine::draw(const LayoutRequest& request, Progress& progress) const {
    constexpr std::size_t kManyOrders = 400;
    const DrawnGraph graph = make_drawn_graph(request);
    MatrixDrawing drawing = drawing_without_places(graph);
    drawing.engine = name();
    const bool orthogonal = options_.lines == GraphvizLines::Orthogonal ||
                            (options_.lines == GraphvizLines::Automatic && graph.orders.size() <= kManyOrders);
    if (!graph.orders.empty()) {
        progress.step("laying the matrix out with graphviz");
        take_positions(drawing, run_layout_worker(options_.executable,
                                                  write_layout_dot(graph, orthogonal ? "ortho" : "polyline"),
                                                  options_.limits, progress));
    }
    for (DrawnLine& line : drawing.lines) {
        if (line.points.size() < 2) {
            throw Error(ErrorCode::Internal, "graphviz drew no line for " + line.id);
        }
        line.upwards = drawing.boxes[line.later].rect.y > drawing.boxes[line.earlier].rect.y;
    }
    finish_page(drawing, graph, request.text);
    return drawing;
}

} // namespace planum::strat
