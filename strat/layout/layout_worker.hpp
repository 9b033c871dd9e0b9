// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/progress.hpp"

namespace planum::strat {

/// Graphviz is not thread-safe, cannot be cancelled and may crash, so it never runs in our process: we
/// start our own executable again with this first argument, and it reads DOT from its standard input and
/// writes positions to its standard output.
inline constexpr std::string_view kLayoutWorkerArgument = "--layout-worker";

/// To be called first of all in main. If the arguments ask for the layout worker, does its work and
/// returns the exit status; nullopt otherwise.
[[nodiscard]] std::optional<int> run_layout_worker_if_asked(int argc, const char* const* argv);

struct WorkerLimits {
    int seconds = 120; ///< of wall time, and of computing
    std::int64_t megabytes = 2000;
};

/// Lays a DOT graph out in a child process made from `executable` and returns what it wrote: lines
/// `n NAME x y` (centre) and `e COMMENT x y x y …` in points, y upwards, then `end`. Throws Error with a
/// sentence when the child cannot be started, crashes, runs out of time or memory, or says nothing
/// sensible; Cancelled when asked to stop, after ending the child.
[[nodiscard]] std::string run_layout_worker(const std::filesystem::path& executable, std::string_view dot,
                                            const WorkerLimits& limits, Progress& progress);

} // namespace planum::strat
