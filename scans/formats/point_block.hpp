// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace planum::scans {

struct Rgb {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;

    friend bool operator==(const Rgb&, const Rgb&) = default;
};

enum class Validity : std::uint8_t {
    Valid,
    DirectionOnly, ///< the ray is known, the range is not
    Invalid,       ///< no return, or withdrawn by the producer
};

/// Which columns of a PointBlock are filled; x, y, z and validity always are.
struct Columns {
    bool intensity = false;
    bool colour = false;
    bool grid = false; ///< row and column
    bool time = false;

    friend bool operator==(const Columns&, const Columns&) = default;
};

/// Consecutive points of one cloud, column by column; columns that the cloud lacks are empty.
/// Coordinates are metres in the scan's own frame, right-handed, z up as far as the file says.
struct PointBlock {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> z;
    std::vector<std::uint16_t> intensity; ///< see CloudHeader::intensity for what a step is
    std::vector<Rgb> colour;
    std::vector<std::uint32_t> row; ///< of the scanner's grid, from 0
    std::vector<std::uint32_t> column;
    std::vector<double> time; ///< [s], from where: CloudHeader::time_zero
    std::vector<Validity> validity;

    [[nodiscard]] std::size_t size() const noexcept { return x.size(); }

    void resize(std::size_t count, const Columns& columns) {
        x.resize(count);
        y.resize(count);
        z.resize(count);
        validity.resize(count);
        intensity.resize(columns.intensity ? count : 0);
        colour.resize(columns.colour ? count : 0);
        row.resize(columns.grid ? count : 0);
        column.resize(columns.grid ? count : 0);
        time.resize(columns.time ? count : 0);
    }

    friend bool operator==(const PointBlock&, const PointBlock&) = default;
};

/// Takes the blocks of a cloud in file order. A block is only valid during the call.
using PointSink = std::function<void(const PointBlock&)>;

} // namespace planum::scans
