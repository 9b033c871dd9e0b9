// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/project/project.hpp"

namespace planum::app {

struct IncompleteSheet {
    std::string unit;
    std::vector<std::string> missing; ///< `level`, `description`, `relation below`
};

/// What to do next, by unit names in natural order.
struct TodayList {
    std::vector<std::string> open;
    std::vector<std::string> may_be_dug_next;
    std::vector<IncompleteSheet> incomplete_sheets;
};

[[nodiscard]] TodayList today_of(Project& project);

} // namespace planum::app
