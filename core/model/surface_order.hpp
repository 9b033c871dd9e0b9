// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/model/record.hpp"

namespace planum::model {

/// Two surfaces of an area whose order says the opposite of their days.
struct OrderClash {
    const Surface* earlier = nullptr; ///< by order
    const Surface* later = nullptr;   ///< by order; began and ended before the other
};

/// Every surface that stands in the order of its area before one whose days all begin and end earlier, with the
/// first such one. Surfaces without a day, and those whose days overlap otherwise, are passed over. In the order of
/// the record; pointers into it.
[[nodiscard]] std::vector<OrderClash> clashes_of_order(const Record& record);

/// Whether a surface is one of the two of any clash: its day or its place in the order is wrong, so nothing can be
/// concluded from what came before or after it.
[[nodiscard]] bool is_in_clash(const std::vector<OrderClash>& clashes, SurfaceId surface);

} // namespace planum::model
