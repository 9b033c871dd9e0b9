// SPDX-License-Identifier: MIT
#include <algorithm>

#include "scans/panorama/panorama.hpp"

namespace planum::scans {

PixelLists::PixelLists(std::size_t pixels, std::span<const std::uint32_t> pixel_of_entry,
                       std::span<const std::uint32_t> point_of_entry, std::span<const float> ranges) {
    std::vector<std::uint32_t> next(pixels + 1);
    for (const std::uint32_t pixel : pixel_of_entry) ++next[pixel + 1];
    counts_.resize(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const std::uint32_t count = next[i + 1];
        counts_[i] = static_cast<std::uint8_t>(std::min(count, 255U));
        if (count >= 255) large_.emplace_back(static_cast<std::uint32_t>(i), count);
        next[i + 1] += next[i];
        if (i % kGroup == 0) starts_.push_back(next[i]);
    }
    entries_.resize(pixel_of_entry.size());
    for (std::size_t i = 0; i < pixel_of_entry.size(); ++i) entries_[next[pixel_of_entry[i]]++] = point_of_entry[i];
    // After filling, next[i] is where pixel i ends.
    for (std::size_t i = 0; i < pixels; ++i) {
        if (counts_[i] < 2) continue;
        const auto first = entries_.begin() + (i == 0 ? 0 : next[i - 1]);
        std::sort(first, entries_.begin() + next[i], [&](std::uint32_t a, std::uint32_t b) {
            return ranges[a] != ranges[b] ? ranges[a] < ranges[b] : a < b;
        });
    }
}

std::uint32_t PixelLists::count_of(std::size_t pixel) const noexcept {
    if (counts_[pixel] < 255) return counts_[pixel];
    const auto found = std::lower_bound(large_.begin(), large_.end(), std::pair{static_cast<std::uint32_t>(pixel), 0U});
    return found->second;
}

std::span<const std::uint32_t> PixelLists::at(std::size_t pixel) const noexcept {
    if (counts_[pixel] == 0) return {};
    std::size_t start = starts_[pixel / kGroup];
    for (std::size_t i = pixel / kGroup * kGroup; i < pixel; ++i) start += count_of(i);
    return {entries_.data() + start, count_of(pixel)};
}

std::uint64_t PixelLists::bytes() const noexcept {
    return starts_.size() * sizeof(std::uint32_t) + counts_.size() + large_.size() * sizeof(large_[0]) +
           entries_.size() * sizeof(std::uint32_t);
}

} // namespace planum::scans
