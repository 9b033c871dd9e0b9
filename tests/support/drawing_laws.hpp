// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "strat/layout/planum_engine.hpp"
#include "strat/layout/read_back.hpp"

namespace planum::test {

inline strat::MatrixDrawing drawing_of(const model::Record& record, const strat::DrawingOptions& options = {},
                                       const strat::PreviousDrawing& previous = {}) {
    const strat::HarrisMatrix matrix = strat::HarrisMatrix::build(record);
    const strat::TableTextMeasure text;
    return strat::PlanumEngine().draw({record, matrix, text, options, previous}, Progress::none());
}

/// What breaks the laws of a drawing of the whole matrix, in words; empty if nothing. The orders are taken
/// from the matrix, not from the drawing.
inline std::string broken_law(const model::Record& record, const strat::MatrixDrawing& drawing) {
    using namespace strat;
    const HarrisMatrix matrix = HarrisMatrix::build(record);
    std::vector<ReadBack::Pair> wanted;
    for (const std::uint32_t i : matrix.reduced()) {
        wanted.push_back({matrix.orders()[i].later, matrix.orders()[i].earlier});
    }
    std::sort(wanted.begin(), wanted.end());
    const ReadBack read = read_back(drawing);
    if (!read.faults.empty()) return read.faults.front();
    if (read.orders != wanted) {
        return "drawn " + std::to_string(read.orders.size()) + " orders, in the matrix are " +
               std::to_string(wanted.size());
    }
    for (const DrawnLine& line : drawing.lines) {
        const bool above = drawing.boxes[line.later].rect.bottom() < drawing.boxes[line.earlier].rect.y;
        if (!above && !line.upwards) return line.id + " runs upwards without saying so";
    }
    return {};
}

/// What breaks the laws of frames, in words; empty if nothing: a frame holds all boxes of its group but the
/// isolated ones, and nobody else's; frames do not overlap.
inline std::string broken_frame(const model::Record& record, const strat::MatrixDrawing& drawing) {
    using namespace strat;
    const auto overlap = [](const DrawRect& a, const DrawRect& b) {
        return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
    };
    for (const DrawnFrame& frame : drawing.frames) {
        const auto group = std::find_if(record.groups.begin(), record.groups.end(),
                                        [&](const model::UnitGroup& g) { return g.number == frame.heading; });
        if (group == record.groups.end()) return frame.heading + " is no group";
        std::size_t held = 0;
        for (const DrawnBox& box : drawing.boxes) {
            // Merged units stand in the frame that all of them share that are in any.
            const auto any_in = [&](const model::UnitGroup& g) {
                return std::any_of(box.units.begin(), box.units.end(), [&](model::UnitId unit) {
                    return std::find(g.members.begin(), g.members.end(), unit) != g.members.end();
                });
            };
            const bool member =
                any_in(*group) && std::none_of(record.groups.begin(), record.groups.end(),
                                               [&](const auto& g) { return &g != &*group && any_in(g); });
            if (member && !box.isolated) {
                const DrawRect& r = box.rect;
                const bool inside = r.x >= frame.rect.x && r.right() <= frame.rect.right() && r.y >= frame.rect.y &&
                                    r.bottom() <= frame.rect.bottom();
                if (!inside) return frame.heading + " does not hold " + box.id;
                ++held;
            } else if (overlap(box.rect, frame.rect)) {
                return frame.heading + " holds " + box.id + ", which is not its own";
            }
        }
        if (held == 0) return frame.heading + " holds nothing";
        for (const DrawnFrame& other : drawing.frames) {
            if (&other != &frame && overlap(other.rect, frame.rect))
                return frame.heading + " overlaps " + other.heading;
        }
        if (frame.rect.x < 0.0 || frame.rect.right() > drawing.width || frame.rect.bottom() > drawing.height)
            return frame.heading + " leaves the page";
    }
    for (const DrawnText& text : drawing.texts) {
        if (text.role != "frame") continue;
        const DrawRect rect{text.at.x, text.at.y - text.size * 0.8, text.width, text.size};
        for (const DrawnBox& box : drawing.boxes) {
            if (overlap(box.rect, rect)) return "the heading " + text.text + " runs into " + box.id;
        }
        for (const DrawnLine& line : drawing.lines) {
            for (std::size_t i = 1; i < line.points.size(); ++i) {
                const DrawPoint& a = line.points[i - 1];
                const DrawPoint& b = line.points[i];
                const DrawRect stroke{std::min(a.x, b.x), std::min(a.y, b.y), std::abs(a.x - b.x), std::abs(a.y - b.y)};
                if (overlap(stroke, rect)) return "the heading " + text.text + " is struck through by " + line.id;
            }
        }
    }
    return {};
}

} // namespace planum::test
