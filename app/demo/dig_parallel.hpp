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

namespace planum::app::demo {

/// Runs work(i) for i in 0…count-1 on up to two threads; what work does may depend on i only. Progress is
/// reported from the calling thread; the first exception is passed on.
template<class Work>
void for_each_index(std::size_t count, Progress& progress, Work work) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> stop{false};
    std::exception_ptr failure;
    std::mutex failure_lock;
    const auto run = [&](bool reports) {
        try {
            for (std::size_t i = next++; i < count && !stop; i = next++) {
                work(i);
                if (!reports) continue;
                progress.check();
                if (count < 64 || i % (count / 64) == 0)
                    progress.fraction(static_cast<double>(i) / static_cast<double>(count));
            }
        } catch (...) { // thread boundary: handed to the caller below
            const std::lock_guard lock(failure_lock);
            if (!failure) failure = std::current_exception();
            stop = true;
        }
    };
    {
        std::jthread helper;
        if (std::thread::hardware_concurrency() > 1) helper = std::jthread([&] { run(false); });
        run(true);
    }
    if (failure) std::rethrow_exception(failure);
}

} // namespace planum::app::demo
