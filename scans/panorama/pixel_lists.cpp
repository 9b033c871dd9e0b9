// SPDX-License-Identifier: MIT
#include <algorithm>

#include "scans/panorama/panorama.hpp"

namespace planum::scans {

PixelLists::PixelLists(std::size_t pixels, std::span<const std::uint32_t> pixel_of_point,
                       std::span<const ClosedPixel> closed, std::span<const float> ranges) {
    LargeVector<std::uint32_t> next(pixels + 1);
    for (const std::uint32_t pixel : pixel_of_point) ++next[pixel + 1];
    for (const ClosedPixel& c : closed) ++next[c.pixel + 1];
    counts_.resize(pixels);
    starts_.reserve(pixels / kGroup + 1);
    std::uint32_t start = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        const std::uint32_t count = next[i + 1];
        counts_[i] = static_cast<std::uint8_t>(std::min(count, 255U));
        if (count >= 255) large_.emplace_back(static_cast<std::uint32_t>(i), count);
        if (i % kGroup == 0) starts_.push_back(start);
        start += count;
        next[i + 1] = start;
    }
    entries_.resize(pixel_of_point.size() + closed.size());
    for (std::uint32_t i = 0; i < pixel_of_point.size(); ++i) entries_[next[pixel_of_point[i]]++] = i;
    for (const ClosedPixel& c : closed) entries_[next[c.pixel]++] = c.point;
    sort(next, ranges); // after filling, next[i] is where pixel i ends
}

void PixelLists::sort(std::span<const std::uint32_t> ends, std::span<const float> ranges) {
    const auto nearer = [&](std::uint32_t a, std::uint32_t b) {
        return ranges[a] != ranges[b] ? ranges[a] < ranges[b] : a < b;
    };
    for (std::size_t i = 0; i < counts_.size(); ++i) {
        if (counts_[i] < 2) continue;
        const auto last = entries_.begin() + ends[i];
        if (counts_[i] > 2) {
            std::sort(i == 0 ? entries_.begin() : entries_.begin() + ends[i - 1], last, nearer);
        } else if (nearer(last[-1], last[-2])) {
            std::swap(last[-1], last[-2]);
        }
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
