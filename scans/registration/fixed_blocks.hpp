// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace planum::scans {

/// Length of the blocks in which loops over points are cut. Sums are made per block and added in the order
/// of the blocks, so that results are the same bits whatever the number of threads.
inline constexpr std::size_t kBlock = 2048;

[[nodiscard]] inline std::size_t block_count(std::size_t size) { return (size + kBlock - 1) / kBlock; }

/// Calls `work(block, begin, end)` once for every block of 0…size on up to `threads` threads, in any order.
/// An exception of the work is rethrown here.
template<class Work>
void for_blocks(std::size_t size, int threads, const Work& work) {
    const std::size_t blocks = block_count(size);
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex failure_mutex;
    const auto run = [&] {
        try {
            for (std::size_t block = next++; block < blocks; block = next++) {
                work(block, block * kBlock, std::min(size, (block + 1) * kBlock));
            }
        } catch (...) { // carried to the calling thread
            const std::lock_guard lock(failure_mutex);
            if (!failure) failure = std::current_exception();
            next = blocks;
        }
    };
    const std::size_t helpers = std::min(blocks, static_cast<std::size_t>(std::max(threads, 1)));
    {
        std::vector<std::jthread> pool;
        for (std::size_t i = 1; i < helpers; ++i) pool.emplace_back(run);
        run();
    }
    if (failure) std::rethrow_exception(failure);
}

} // namespace planum::scans
