// SPDX-License-Identifier: MIT
#include "scans/surface/cell_patches.hpp"

#include <algorithm>

namespace planum::scans {

CellSet opened(const GridFrame& frame, const CellSet& set) {
    const auto all_around = [&](const CellSet& from, std::int32_t row, std::int32_t column, std::uint8_t wanted) {
        for (std::int32_t r = row - 1; r <= row + 1; ++r) {
            for (std::int32_t c = column - 1; c <= column + 1; ++c) {
                const bool inside = r >= 0 && c >= 0 && r < frame.rows && c < frame.columns;
                if ((inside ? from[frame.at(r, c)] : 0) != wanted) return false;
            }
        }
        return true;
    };
    CellSet core(set.size());
    CellSet result(set.size());
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column) {
            const std::size_t cell = frame.at(row, column);
            core[cell] = set[cell] != 0 && all_around(set, row, column, 1) ? 1 : 0;
        }
    }
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column)
            result[frame.at(row, column)] = all_around(core, row, column, 0) ? 0 : 1;
    }
    return result;
}

std::vector<std::size_t> take_patch(const GridFrame& frame, CellSet& set, std::size_t start) {
    std::vector<std::size_t> patch{start};
    set[start] = 0;
    for (std::size_t i = 0; i < patch.size(); ++i) {
        const auto row = static_cast<std::int32_t>(patch[i] / static_cast<std::size_t>(frame.columns));
        const auto column = static_cast<std::int32_t>(patch[i] % static_cast<std::size_t>(frame.columns));
        for (std::int32_t r = std::max(0, row - 1); r <= std::min(frame.rows - 1, row + 1); ++r) {
            for (std::int32_t c = std::max(0, column - 1); c <= std::min(frame.columns - 1, column + 1); ++c) {
                const std::size_t cell = frame.at(r, c);
                if (set[cell] == 0) continue;
                set[cell] = 0;
                patch.push_back(cell);
            }
        }
    }
    std::sort(patch.begin(), patch.end());
    return patch;
}

} // namespace planum::scans
