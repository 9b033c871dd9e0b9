// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scans/formats/point_block.hpp"
#include "scans/panorama/projection.hpp"

namespace planum::scans {

/// How a scanner's own grid lies on the sphere: azimuth by column, elevation by row, both in equal steps.
struct GridSteps {
    double first_azimuth = 0.0;    ///< of column 0 [rad]
    double azimuth_step = 0.0;     ///< from column to column, signed [rad]
    double first_elevation = 0.0;  ///< of row 0 [rad]
    double elevation_step = 0.0;   ///< signed [rad]
    std::uint32_t column_from = 0; ///< columns and rows that have points
    std::uint32_t column_to = 0;
    std::uint32_t row_from = 0;
    std::uint32_t row_to = 0;
};

/// Learns from the points of a scan, given in any order, what of the sphere it covers and how densely.
class ScanExtent {
  public:
    explicit ScanExtent(Columns has);

    void add(const PointBlock& block);

    /// The scanner's grid, where the file has one and it is regular: equal steps to a quarter of a step, seen from the
    /// place where the coordinates start, not levelled afterwards.
    [[nodiscard]] std::optional<GridSteps> grid() const;

    /// Extent and size of a panorama that shows all that the projection can of the scan: a pixel for each cell of a
    /// regular grid, else about a pixel for a point; at most `most_width` pixels across. Where nothing was added, the
    /// default extent.
    [[nodiscard]] ProjectionOptions fit(ProjectionKind kind, int most_width) const;

  private:
    struct Line { ///< what is known of a row or a column of the grid
        double x = 0.0;
        double y = 0.0;
        double flat = 0.0; ///< sum of the cosines of the elevations
        double elevation = 0.0;
        double square = 0.0;
        double count = 0.0;
    };

    [[nodiscard]] double free_step() const;
    void fit_azimuths(ProjectionOptions& options) const;
    void fit_elevations(ProjectionOptions& options) const;

    Columns has_;
    std::uint64_t points_ = 0;
    std::vector<std::uint8_t> seen_; ///< cells of a quarter of a degree
    std::vector<Line> columns_;
    std::vector<Line> rows_;
};

} // namespace planum::scans
