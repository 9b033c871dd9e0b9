// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/demo/random.hpp"
#include "app/demo/trench_history.hpp"

namespace planum::app {

/// How a trench was dug: by unit of its history.
struct Digging {
    std::vector<std::size_t> number; ///< given when the unit was noticed
    std::vector<std::int64_t> day;   ///< working day on which it was finished, from 0
    std::size_t next_number = 0;     ///< the first that is free
};

/// Digs a trench from above, nothing before what lies on it, near the last spot two times in three. Numbers
/// follow the digging but for `blur` places (σ).
[[nodiscard]] Digging dig(Random& random, const TrenchHistory& history, std::size_t first_number, double blur);

/// Working day `n` (Monday to Friday) of a season that began on 3 June 2024, as ISO date.
[[nodiscard]] std::string iso_day(std::int64_t n);

/// The contacts that made it onto sheets: immediate ones but for one in twenty, and implied ones up to the
/// share asked for; where `per_unit` asks for more, also pairs that never touched, stated as covers.
[[nodiscard]] std::vector<TrenchContact> recorded_contacts(Random& random, const TrenchHistory& history,
                                                           double per_unit, double redundant);

} // namespace planum::app
