// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "strat/layout/planum_engine.hpp"
#include "strat/layout/read_back.hpp"

namespace planum::test {

inline strat::MatrixDrawing drawing_of(const model::Record& record, const strat::DrawingOptions& options = {},
                                       const std::vector<strat::PreviousPosition>& previous = {}) {
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

} // namespace planum::test
