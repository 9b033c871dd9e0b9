// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace planum::strat {

/// Lists of numbers per row, stored in one piece (compressed sparse rows).
struct Adjacency {
    std::vector<std::uint32_t> begin; ///< rows + 1 entries
    std::vector<std::uint32_t> values;

    [[nodiscard]] std::size_t rows() const noexcept { return begin.empty() ? 0 : begin.size() - 1; }

    [[nodiscard]] std::span<const std::uint32_t> row(std::size_t r) const {
        return std::span(values).subspan(begin[r], begin[r + 1] - begin[r]);
    }

    /// Rows from (row, value) given by two functions of an item's position; order within a row is kept.
    template<class RowOf, class ValueOf>
    [[nodiscard]] static Adjacency make(std::size_t rows, std::size_t items, RowOf row_of, ValueOf value_of) {
        Adjacency a;
        a.begin.assign(rows + 1, 0);
        for (std::size_t i = 0; i < items; ++i) ++a.begin[static_cast<std::size_t>(row_of(i)) + 1];
        for (std::size_t r = 0; r < rows; ++r) a.begin[r + 1] += a.begin[r];
        a.values.resize(items);
        std::vector<std::uint32_t> next(a.begin.begin(), a.begin.end() - 1);
        for (std::size_t i = 0; i < items; ++i) {
            a.values[next[static_cast<std::size_t>(row_of(i))]++] = static_cast<std::uint32_t>(value_of(i));
        }
        return a;
    }
};

} // namespace planum::strat
