// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace planum::bench {

/// A trench of 20 × 20 m with 60 plots that go down layer by layer: `surfaces` days of history with one scan each, then
/// a day with five scans of `points` each. Prints what the day's surface and evidence take, and what an outline that
/// was redrawn takes.
void bench_history(int surfaces, std::int64_t points);

} // namespace planum::bench
