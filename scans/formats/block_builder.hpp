// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>

#include "core/base/progress.hpp"
#include "scans/formats/cloud_header.hpp"
#include "scans/formats/point_block.hpp"
#include "scans/formats/scan_reader.hpp"

namespace planum::scans {

/// Tells Progress where a reader is, at most ten times a second, and notices a wish to stop.
class Meter {
  public:
    Meter(Progress& progress, std::uint64_t total) : progress_(&progress), total_(total) {}

    void at(std::uint64_t done) {
        progress_->check();
        const auto now = std::chrono::steady_clock::now();
        if (now - told_ < std::chrono::milliseconds(100)) return;
        told_ = now;
        if (total_ > 0) progress_->fraction(std::min(1.0, static_cast<double>(done) / static_cast<double>(total_)));
    }

  private:
    Progress* progress_;
    std::uint64_t total_;
    std::chrono::steady_clock::time_point told_;
};

/// Collects points into blocks for the sink and keeps the summary. A reader fills the columns of
/// `block` at `slot()`, then says `commit` or, for what has no place, `miss`.
class BlockBuilder {
  public:
    BlockBuilder(const CloudHeader& header, const PointSink& sink, const ReadOptions& options)
        : sink_(&sink), columns_(header.has), capacity_(std::clamp<std::size_t>(options.block_points, 1, 1U << 22U)),
          keep_misses_(options.misses == Misses::Keep) {
        // A small cloud, or a lie about its size, shall not cost a big block.
        const std::uint64_t stated = std::max<std::uint64_t>(header.records, 1);
        capacity_ = static_cast<std::size_t>(std::min<std::uint64_t>(capacity_, stated));
        block.resize(capacity_, columns_);
    }

    PointBlock block;

    [[nodiscard]] std::size_t slot() const noexcept { return used_; }

    [[nodiscard]] bool keeps_misses() const noexcept { return keep_misses_; }

    /// The point at slot() is complete; one whose coordinates are no finite numbers becomes a miss.
    void commit() {
        const bool finite = std::isfinite(block.x[used_] + block.y[used_] + block.z[used_]);
        if (!finite) {
            set_place(0.0, 0.0, 0.0);
            miss(Validity::Invalid);
            return;
        }
        block.validity[used_] = Validity::Valid;
        ++summary_.records;
        advance();
    }

    /// The record at slot() has no place in space. Its coordinates are kept only with Misses::Keep.
    void miss(Validity why) {
        ++summary_.records;
        ++summary_.misses;
        if (!keep_misses_) return;
        if (!std::isfinite(block.x[used_] + block.y[used_] + block.z[used_])) set_place(0.0, 0.0, 0.0);
        block.validity[used_] = why;
        advance();
    }

    void set_place(double x, double y, double z) {
        block.x[used_] = x;
        block.y[used_] = y;
        block.z[used_] = z;
    }

    void set_grid(std::uint64_t row, std::uint64_t column) {
        block.row[used_] = static_cast<std::uint32_t>(row);
        block.column[used_] = static_cast<std::uint32_t>(column);
    }

    /// Value in the file's own unit; outside of what the coding can say it is clamped and counted.
    void set_intensity(double value, const IntensityCoding& coding) {
        block.intensity[used_] = static_cast<std::uint16_t>(rounded((value - coding.offset) / coding.scale, 65535));
    }

    void set_colour(double red, double green, double blue) {
        block.colour[used_] = {byte(red), byte(green), byte(blue)};
    }

    [[nodiscard]] std::uint64_t records() const noexcept { return summary_.records; }

    [[nodiscard]] ReadSummary finish() {
        flush();
        return summary_;
    }

  private:
    // Half up. Without std::floor, which is a call where the processor is not known to have it.
    [[nodiscard]] std::int32_t rounded(double value, std::int32_t most) {
        const double shifted = value + 0.5;
        if (shifted >= 0.0 && shifted < static_cast<double>(most) + 1.0) return static_cast<std::int32_t>(shifted);
        ++summary_.clamped;
        return shifted >= 0.0 ? most : 0; // NaN ends at 0
    }

    [[nodiscard]] std::uint8_t byte(double value) { return static_cast<std::uint8_t>(rounded(value, 255)); }

    void advance() {
        if (++used_ == capacity_) flush();
    }

    void flush() {
        if (used_ == 0) return;
        if (used_ < capacity_) block.resize(used_, columns_);
        for (std::size_t i = 0; i < used_; ++i) {
            if (block.validity[i] != Validity::Valid) continue;
            ++summary_.valid;
            widen(0, block.x[i]);
            widen(1, block.y[i]);
            widen(2, block.z[i]);
        }
        (*sink_)(block);
        used_ = 0;
        block.resize(capacity_, columns_);
    }

    void widen(std::size_t axis, double value) {
        summary_.bounds.minimum[axis] = std::min(summary_.bounds.minimum[axis], value);
        summary_.bounds.maximum[axis] = std::max(summary_.bounds.maximum[axis], value);
    }

    const PointSink* sink_;
    Columns columns_;
    std::size_t capacity_;
    std::size_t used_ = 0;
    bool keep_misses_;
    ReadSummary summary_;
};

} // namespace planum::scans
