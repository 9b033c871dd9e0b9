// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "core/base/large_pages.hpp"
#include "core/base/progress.hpp"
#include "scans/formats/cloud_header.hpp"
#include "scans/formats/point_block.hpp"
#include "scans/panorama/gap_closing.hpp"
#include "scans/panorama/projection.hpp"

namespace planum::scans {

struct PanoramaOptions {
    ProjectionOptions projection;
    /// Holes that are closed; with most_pixels 0 none. Where the points come with the scanner's grid, what lies between
    /// neighbours in it is closed too.
    ClosingOptions gaps;
};

enum class Channel : std::uint8_t { Reflectance, Range, Colour, Normals };

/// 8-bit picture, row by row, 1 (grey) or 3 (red, green, blue) values a pixel; 0 where there is nothing.
struct Picture {
    int width = 0;
    int height = 0;
    int channels = 1;
    std::vector<std::uint8_t> values;
};

/// The list of points of every pixel, nearest first, in compressed rows: a byte for most pixels, four
/// for a point.
class PixelLists {
  public:
    PixelLists() = default;

    /// Sorts points into the lists of their pixels, and into those of the closed ones that show them too. `ranges` [m]
    /// of the points decides the order within a list.
    PixelLists(std::size_t pixels, std::span<const std::uint32_t> pixel_of_point, std::span<const ClosedPixel> closed,
               std::span<const float> ranges);

    [[nodiscard]] std::span<const std::uint32_t> at(std::size_t pixel) const noexcept;
    [[nodiscard]] std::uint64_t bytes() const noexcept;

  private:
    static constexpr std::size_t kGroup = 64; ///< pixels that share a start

    std::vector<std::uint32_t> starts_;                          ///< of each group, into entries_
    LargeVector<std::uint8_t> counts_;                           ///< 255: look into large_
    std::vector<std::pair<std::uint32_t, std::uint32_t>> large_; ///< (pixel, count), sorted
    LargeVector<std::uint32_t> entries_;

    [[nodiscard]] std::uint32_t count_of(std::size_t pixel) const noexcept;
    void sort(std::span<const std::uint32_t> ends, std::span<const float> ranges);
};

/// A scan unrolled around its scanner.
///
/// Invariant: every pixel that shows something has at least one point; in a closed gap these are the
/// points of its nearer neighbour.
class Panorama {
  public:
    [[nodiscard]] const Projection& projection() const noexcept { return projection_; }

    [[nodiscard]] int width() const noexcept { return projection_.options().width; }

    [[nodiscard]] int height() const noexcept { return projection_.options().height; }

    [[nodiscard]] std::uint64_t points() const noexcept { return ranges_.size(); } ///< that fell into the picture

    /// Points of a pixel, nearest first, by the order in which they came into the picture.
    [[nodiscard]] std::span<const std::uint32_t> points_at(int column, int row) const noexcept;

    /// Where a point is, in the scan's frame [m].
    [[nodiscard]] Eigen::Vector3d place(std::uint32_t point) const noexcept;

    /// The number of the point among all valid points that were added.
    [[nodiscard]] std::uint64_t source(std::uint32_t point) const noexcept { return sources_[point]; }

    /// The place on the surface that a sub-pixel shows [m, scan's frame]: a plane through the points around
    /// it where they agree, else along the ray as far as the nearest point; nullopt where there is nothing.
    [[nodiscard]] std::optional<Eigen::Vector3d> surface_at(const Eigen::Vector2d& pixel) const;

    [[nodiscard]] Picture picture(Channel channel) const;

    /// How many pixels show something.
    [[nodiscard]] std::uint64_t filled() const noexcept;

    /// Bytes of the pixel → points lists.
    [[nodiscard]] std::uint64_t list_bytes() const noexcept { return lists_.bytes(); }

  private:
    friend class PanoramaBuilder;

    explicit Panorama(const PanoramaOptions& options) : projection_(options.projection), options_(options) {}

    [[nodiscard]] float front_range(int column, int row) const noexcept; ///< 0: nothing there
    [[nodiscard]] std::uint8_t shade(int column, int row) const noexcept;

    Projection projection_;
    PanoramaOptions options_;
    Columns has_;
    PixelLists lists_;
    LargeVector<std::array<float, 3>> places_;
    LargeVector<float> ranges_;
    LargeVector<std::uint32_t> sources_;
    LargeVector<std::uint16_t> intensities_;
    LargeVector<Rgb> colours_;
};

/// Makes a panorama from a stream of points, in any order.
class PanoramaBuilder {
  public:
    PanoramaBuilder(const PanoramaOptions& options, Columns has);

    /// Room for so many points at once, where their number is known before; only a matter of speed.
    void expect(std::uint64_t points);

    /// Takes the valid points of a block. Throws BadInput over 4 thousand million points.
    void add(const PointBlock& block);

    [[nodiscard]] Panorama finish(Progress& progress);

  private:
    [[nodiscard]] bool keep_grid() const noexcept;
    void resize(std::size_t size);
    /// Points `from` to `until` of the block, into the columns from place `to`; says where the next ones go.
    std::size_t add_portion(const PointBlock& block, std::size_t from, std::size_t until, std::size_t to);

    Panorama panorama_;
    LargeVector<std::uint32_t> pixels_; ///< of each point
    LargeVector<std::uint32_t> rows_;   ///< of the scanner's grid, where gaps are closed along it
    LargeVector<std::uint32_t> columns_;
    std::uint64_t added_ = 0;
};

/// Writes a picture as PNG and beside it (same name, .json) what it shows: projection, extent, channel, the
/// name of the scan and, where it is known, its pose as 16 numbers, row-major. Throws Io.
void write_panorama(const Panorama& panorama, Channel channel, const std::filesystem::path& png,
                    const std::string& scan, const std::optional<Eigen::Isometry3d>& site_from_scan);

/// The bytes of a PNG file.
[[nodiscard]] std::string encode_png(const Picture& picture);

[[nodiscard]] std::string_view channel_name(Channel channel) noexcept;

} // namespace planum::scans
