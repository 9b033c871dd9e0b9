// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "scans/cloud/store_layout.hpp"

namespace planum::scans {

/// A nameless file beside the store for points that do not fit into memory. It is gone with the object,
/// or with the process.
class SpillFile {
  public:
    explicit SpillFile(std::filesystem::path folder) : folder_(std::move(folder)) {}

    SpillFile(const SpillFile&) = delete;
    SpillFile& operator=(const SpillFile&) = delete;
    ~SpillFile();

    /// Appends; returns the index of the first point written. Throws Io (disk full).
    std::uint64_t write(std::span<const PackedPoint> points);
    void read(std::uint64_t first, std::span<PackedPoint> out) const;

  private:
    std::filesystem::path folder_;
    int descriptor_ = -1;
    std::uint64_t points_ = 0;
};

/// Points of one cube in the order they came, some of them on disk. Invariant: all on disk came before
/// all in memory.
class PointBucket {
  public:
    void add(const PackedPoint& point) {
        if (chunks_.empty() || chunks_.back().size() == chunks_.back().capacity()) grow();
        chunks_.back().push_back(point);
        ++count_;
    }

    [[nodiscard]] std::uint64_t count() const noexcept { return count_; }

    /// Bytes this bucket has reserved in memory.
    [[nodiscard]] std::uint64_t memory() const noexcept { return memory_; }

    /// Moves what is in memory to the file.
    void spill(SpillFile& file);

    /// Hands all points over in order, in pieces.
    void for_each_piece(const SpillFile& file, const std::function<void(std::span<const PackedPoint>)>& take) const;

    /// All points in one array; the bucket is empty afterwards.
    [[nodiscard]] std::vector<PackedPoint> take_all(const SpillFile& file);

    void clear();

  private:
    struct Extent {
        std::uint64_t first = 0;
        std::uint64_t count = 0;
    };

    void grow();

    std::vector<std::vector<PackedPoint>> chunks_;
    std::vector<Extent> extents_;
    std::uint64_t count_ = 0;
    std::uint64_t memory_ = 0;
};

} // namespace planum::scans
