// SPDX-License-Identifier: MIT
#include "scans/panorama/panorama.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "core/base/error.hpp"

namespace planum::scans {

namespace {

constexpr std::uint64_t kMostPoints = 0xFFFFFFF0ULL;
constexpr std::uint64_t kMostExpected = 100'000'000;
constexpr std::size_t kFewestForPlane = 5;
constexpr std::size_t kPiece = 16384;  ///< points that the columns grow by
constexpr std::size_t kPortion = 1024; ///< points added at once: what is known of them stays in the cache

bool agree(float a, float b, double share) noexcept {
    return std::abs(a - b) <= share * static_cast<double>(std::min(a, b));
}

} // namespace

PanoramaBuilder::PanoramaBuilder(const PanoramaOptions& options, Columns has) : panorama_(options) {
    panorama_.has_ = has;
}

void PanoramaBuilder::add(const PointBlock& block) {
    const std::size_t size = block.size();
    if (size > kMostPoints - added_) throw Error(ErrorCode::BadInput, "a panorama holds at most 4,294 million points");
    // Grown by whole pieces and cut back, so that nothing is asked point by point and what is made is still in the
    // cache when it is filled.
    std::size_t to = pixels_.size();
    for (std::size_t from = 0; from < size; from += kPiece) {
        const std::size_t until = std::min(size, from + kPiece);
        resize(to + until - from);
        for (std::size_t at = from; at < until; at += kPortion) {
            to = add_portion(block, at, std::min(until, at + kPortion), to);
        }
        resize(to);
    }
}

void PanoramaBuilder::expect(std::uint64_t points) {
    // What a header claims is believed only so far; beyond that memory grows with what really comes.
    const std::size_t size = pixels_.size() + static_cast<std::size_t>(std::min(points, kMostExpected));
    Panorama& p = panorama_;
    pixels_.reserve(size);
    p.places_.reserve(size);
    p.ranges_.reserve(size);
    p.sources_.reserve(size);
    if (p.has_.intensity) p.intensities_.reserve(size);
    if (p.has_.colour) p.colours_.reserve(size);
    if (keep_grid()) rows_.reserve(size);
    if (keep_grid()) columns_.reserve(size);
}

void PanoramaBuilder::resize(std::size_t size) {
    Panorama& p = panorama_;
    pixels_.resize(size);
    p.places_.resize(size);
    p.ranges_.resize(size);
    p.sources_.resize(size);
    if (p.has_.intensity) p.intensities_.resize(size);
    if (p.has_.colour) p.colours_.resize(size);
    if (keep_grid()) rows_.resize(size);
    if (keep_grid()) columns_.resize(size);
}

std::size_t PanoramaBuilder::add_portion(const PointBlock& block, std::size_t from, std::size_t until, std::size_t to) {
    Panorama& p = panorama_;
    const std::size_t count = until - from;
    std::array<std::uint32_t, kPortion> pixels;
    p.projection_.indices_of({&block.x[from], count}, {&block.y[from], count}, {&block.z[from], count},
                             {pixels.data(), count});
    const bool grid = keep_grid();
    for (std::size_t i = from; i < until; ++i) {
        if (block.validity[i] != Validity::Valid) continue;
        const auto source = static_cast<std::uint32_t>(added_++);
        const double x = block.x[i];
        const double y = block.y[i];
        const double z = block.z[i];
        const auto range = static_cast<float>(std::sqrt(x * x + y * y + z * z));
        // The scanner's own place has no direction.
        if (pixels[i - from] == Projection::kOutside || !(range > 0.0F)) continue;
        pixels_[to] = pixels[i - from];
        p.places_[to] = {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
        p.ranges_[to] = range;
        p.sources_[to] = source;
        if (p.has_.intensity) p.intensities_[to] = block.intensity[i];
        if (p.has_.colour) p.colours_[to] = block.colour[i];
        if (grid) rows_[to] = block.row[i];
        if (grid) columns_[to] = block.column[i];
        ++to;
    }
    return to;
}

bool PanoramaBuilder::keep_grid() const noexcept {
    return panorama_.has_.grid && panorama_.options_.gaps.most_pixels > 0;
}

Panorama PanoramaBuilder::finish(Progress& progress) {
    progress.check();
    Panorama& p = panorama_;
    const std::size_t pixels = static_cast<std::size_t>(p.width()) * static_cast<std::size_t>(p.height());
    std::vector<ClosedPixel> closed;
    if (p.options_.gaps.most_pixels > 0) {
        closed = close_gaps(p.projection_, {pixels_, p.places_, p.ranges_, rows_, columns_}, p.options_.gaps);
    }
    progress.check();
    p.lists_ = PixelLists(pixels, pixels_, closed, p.ranges_);
    pixels_ = {};
    return std::move(panorama_);
}

std::span<const std::uint32_t> Panorama::points_at(int column, int row) const noexcept {
    if (column < 0 || row < 0 || column >= width() || row >= height()) return {};
    return lists_.at(static_cast<std::size_t>(row) * static_cast<std::size_t>(width()) +
                     static_cast<std::size_t>(column));
}

Eigen::Vector3d Panorama::place(std::uint32_t point) const noexcept {
    const std::array<float, 3>& at = places_[point];
    return {static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])};
}

float Panorama::front_range(int column, int row) const noexcept {
    const std::span<const std::uint32_t> points = points_at(column, row);
    return points.empty() ? 0.0F : ranges_[points.front()];
}

std::uint64_t Panorama::filled() const noexcept {
    std::uint64_t count = 0;
    for (int row = 0; row < height(); ++row) {
        for (int column = 0; column < width(); ++column) count += points_at(column, row).empty() ? 0U : 1U;
    }
    return count;
}

std::optional<Eigen::Vector3d> Panorama::surface_at(const Eigen::Vector2d& pixel) const {
    const std::optional<Eigen::Vector3d> ray = projection_.ray_of(pixel);
    if (!ray) return std::nullopt;
    const int column = std::min(static_cast<int>(pixel.x()), width() - 1);
    const int row = std::min(static_cast<int>(pixel.y()), height() - 1);
    if (points_at(column, row).empty()) return std::nullopt;
    // The point nearest to the ray says which surface is meant; closed gaps lend their neighbours' points.
    std::vector<std::uint32_t> around;
    for (int r = row - 1; r <= row + 1; ++r) {
        for (int c = column - 1; c <= column + 1; ++c) {
            const auto points = points_at(c, r);
            around.insert(around.end(), points.begin(), points.end());
        }
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    const auto off = [&](std::uint32_t i) { return (place(i) / static_cast<double>(ranges_[i]) - *ray).squaredNorm(); };
    const std::uint32_t nearest = *std::min_element(around.begin(), around.end(),
                                                    [&](std::uint32_t a, std::uint32_t b) { return off(a) < off(b); });
    std::erase_if(around,
                  [&](std::uint32_t i) { return !agree(ranges_[i], ranges_[nearest], options_.gaps.agreement); });
    const Eigen::Vector3d along = *ray * static_cast<double>(ranges_[nearest]);
    if (around.size() < kFewestForPlane) return along;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const std::uint32_t i : around) centre += place(i);
    centre /= static_cast<double>(around.size());
    // How far along the ray's direction the surface lies, as a linear function of the two others.
    const Eigen::Vector3d side = ray->unitOrthogonal();
    const Eigen::Vector3d up = ray->cross(side);
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right_side = Eigen::Vector2d::Zero();
    for (const std::uint32_t i : around) {
        const Eigen::Vector3d d = place(i) - centre;
        const Eigen::Vector2d across(d.dot(side), d.dot(up));
        normal += across * across.transpose();
        right_side += across * d.dot(*ray);
    }
    if (normal.determinant() < 1e-4 * normal.trace() * normal.trace()) return along; // they stand in a line
    const Eigen::Vector2d slope = normal.ldlt().solve(right_side);
    const Eigen::Vector2d to_axis(-centre.dot(side), -centre.dot(up));
    const double range = centre.dot(*ray) + slope.dot(to_axis);
    return agree(static_cast<float>(range), ranges_[nearest], options_.gaps.agreement) ? *ray * range : along;
}

} // namespace planum::scans
