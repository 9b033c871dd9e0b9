// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "core/base/progress.hpp"

namespace planum::scans {

/// Calls `work(i)` for i in 0…count-1 on up to `threads` threads, in any order; what work does may depend on i
/// only. Progress is told from the calling thread; the first exception is rethrown here.
template<class Work>
void for_each_part(std::size_t count, int threads, Progress& progress, const Work& work) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex failure_mutex;
    const auto run = [&](bool reports) {
        try {
            for (std::size_t i = next++; i < count; i = next++) {
                work(i);
                if (!reports) continue;
                progress.check();
                if (count <= 64 || i % (count / 64) == 0)
                    progress.fraction(static_cast<double>(i + 1) / static_cast<double>(count));
            }
        } catch (...) { // carried to the calling thread
            const std::lock_guard lock(failure_mutex);
            if (!failure) failure = std::current_exception();
            next = count;
        }
    };
    {
        std::vector<std::jthread> helpers;
        const std::size_t wanted = std::min(count, static_cast<std::size_t>(std::max(threads, 1)));
        for (std::size_t i = 1; i < wanted; ++i) helpers.emplace_back([&] { run(false); });
        run(true);
    }
    if (failure) std::rethrow_exception(failure);
}

} // namespace planum::scans
