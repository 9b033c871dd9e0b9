// SPDX-License-Identifier: MIT
#include "scans/panorama/gap_closing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/large_pages.hpp"

namespace planum::scans {

namespace {

constexpr std::uint32_t kNothing = 0xFFFFFFFF;
constexpr double kLongestSide = 64.0; // [px]; longer ones reach around the picture

class Closing {
  public:
    Closing(const Projection& projection, const PicturePoints& points, const ClosingOptions& options)
        : projection_(projection), points_(points), options_(options),
          width_(static_cast<std::size_t>(projection.options().width)),
          height_(static_cast<std::size_t>(projection.options().height)), front_(width_ * height_, kNothing) {
        for (std::uint32_t i = 0; i < points.pixel.size(); ++i) {
            std::uint32_t& best = front_[points.pixel[i]];
            if (best == kNothing || points.range[i] < points.range[best]) best = i;
        }
    }

    /// Between neighbours in the scanner's grid.
    void along_grid();
    /// Along the rows and the columns of the picture.
    void along_picture();

    [[nodiscard]] std::vector<ClosedPixel> take() { return std::move(closed_); }

  private:
    [[nodiscard]] bool agree(std::uint32_t a, std::uint32_t b) const noexcept {
        if (a == kNothing || b == kNothing) return false;
        const auto nearer = static_cast<double>(std::min(points_.range[a], points_.range[b]));
        return static_cast<double>(std::abs(points_.range[a] - points_.range[b])) <= options_.agreement * nearer;
    }

    void close(std::size_t pixel, std::uint32_t point) {
        closed_.push_back({static_cast<std::uint32_t>(pixel), point});
    }

    [[nodiscard]] bool goes_on(const std::array<std::uint32_t, 4>& rows) const noexcept;
    [[nodiscard]] bool touch(const std::array<std::uint32_t, 3>& corners) const noexcept;
    [[nodiscard]] std::optional<std::array<Eigen::Vector2d, 3>>
    in_picture(const std::array<std::uint32_t, 3>& corners) const;
    void fill(const std::array<std::uint32_t, 3>& corners);
    void close_line(std::size_t start, std::size_t count, std::size_t stride);

    const Projection& projection_;
    const PicturePoints& points_;
    const ClosingOptions& options_;
    std::size_t width_;
    std::size_t height_;
    LargeVector<std::uint32_t> front_; ///< nearest point of each pixel
    std::vector<ClosedPixel> closed_;
};

// Seen at a grazing angle, one and the same ground is much further away in the next row of the grid. On a plane the
// inverse range grows by even steps with the angle, so ground goes on from the second to the third of four points one
// above the other where the steps are alike; at the edge of a thing the middle one stands out. Of the outer points one
// may be missing, as in the first and the last row.
bool Closing::goes_on(const std::array<std::uint32_t, 4>& rows) const noexcept {
    const auto step = [&](std::size_t i) { // of the inverse range, from one row to the next
        return 1.0 / static_cast<double>(points_.range[rows[i + 1]]) -
               1.0 / static_cast<double>(points_.range[rows[i]]);
    };
    const auto alike = [&](double a, double b) {
        return a * b > 0.0 &&
               std::min(std::abs(a), std::abs(b)) >= options_.alike_steps * std::max(std::abs(a), std::abs(b));
    };
    if (rows[1] == kNothing || rows[2] == kNothing || (rows[0] == kNothing && rows[3] == kNothing)) return false;
    return (rows[0] == kNothing || alike(step(0), step(1))) && (rows[3] == kNothing || alike(step(1), step(2)));
}

// No pixel lies between corners in the same or in touching pixels.
bool Closing::touch(const std::array<std::uint32_t, 3>& corners) const noexcept {
    const auto far = [](std::size_t a, std::size_t b) { return a > b ? a - b > 1 : b - a > 1; };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = points_.pixel[corners[i]];
        const std::size_t b = points_.pixel[corners[(i + 1) % 3]];
        if (far(a % width_, b % width_) || far(a / width_, b / width_)) return false;
    }
    return true;
}

std::optional<std::array<Eigen::Vector2d, 3>> Closing::in_picture(const std::array<std::uint32_t, 3>& corners) const {
    std::array<Eigen::Vector2d, 3> at;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::array<float, 3>& p = points_.place[corners[i]];
        const auto pixel = projection_.pixel_of(Eigen::Vector3f(p[0], p[1], p[2]).cast<double>());
        if (!pixel) return std::nullopt;
        at[i] = *pixel;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        if ((at[i] - at[(i + 1) % 3]).cwiseAbs().maxCoeff() > kLongestSide) return std::nullopt;
        if (projection_.view_at(at[i].x()) != projection_.view_at(at[(i + 1) % 3].x())) return std::nullopt;
    }
    return at;
}

// Every empty pixel whose middle lies in the triangle shows the corner next to it.
void Closing::fill(const std::array<std::uint32_t, 3>& corners) {
    if (touch(corners)) return;
    const auto at = in_picture(corners);
    if (!at) return;
    const auto side = [&](std::size_t i, const Eigen::Vector2d& p) {
        const Eigen::Vector2d along = (*at)[(i + 1) % 3] - (*at)[i];
        return along.x() * (p.y() - (*at)[i].y()) - along.y() * (p.x() - (*at)[i].x());
    };
    const double turn = side(0, (*at)[2]) < 0.0 ? -1.0 : 1.0;
    const Eigen::Vector2d low = (*at)[0].cwiseMin((*at)[1]).cwiseMin((*at)[2]);
    const Eigen::Vector2d high = (*at)[0].cwiseMax((*at)[1]).cwiseMax((*at)[2]);
    const auto right = std::min(static_cast<std::size_t>(high.x()), width_ - 1);
    const auto bottom = std::min(static_cast<std::size_t>(high.y()), height_ - 1);
    for (auto row = static_cast<std::size_t>(low.y()); row <= bottom; ++row) {
        for (auto column = static_cast<std::size_t>(low.x()); column <= right; ++column) {
            if (front_[row * width_ + column] != kNothing) continue;
            const Eigen::Vector2d middle(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
            if (turn * side(0, middle) < 0.0 || turn * side(1, middle) < 0.0 || turn * side(2, middle) < 0.0) continue;
            std::size_t nearest = 0;
            for (std::size_t i = 1; i < 3; ++i) {
                if (((*at)[i] - middle).squaredNorm() < ((*at)[nearest] - middle).squaredNorm()) nearest = i;
            }
            front_[row * width_ + column] = corners[nearest];
            close(row * width_ + column, corners[nearest]);
        }
    }
}

void Closing::along_grid() {
    if (points_.row.empty()) return;
    const std::size_t rows = *std::max_element(points_.row.begin(), points_.row.end()) + std::size_t{1};
    const std::size_t columns = *std::max_element(points_.column.begin(), points_.column.end()) + std::size_t{1};
    // A grid that is nearly empty is not worth a table.
    if (columns > (8 * points_.row.size() + (1U << 20U)) / rows) return;
    LargeVector<std::uint32_t> at(rows * columns, kNothing);
    for (std::uint32_t i = 0; i < points_.row.size(); ++i) {
        std::uint32_t& best = at[points_.row[i] * columns + points_.column[i]];
        if (best == kNothing || points_.range[i] < points_.range[best]) best = i;
    }
    const auto point = [&](std::size_t row, std::size_t column) { // row may have wrapped below 0
        return row < rows ? at[row * columns + column] : kNothing;
    };
    const auto agree_upwards = [&](std::size_t row, std::size_t column) {
        const std::array<std::uint32_t, 4> four = {point(row - 1, column), point(row, column), point(row + 1, column),
                                                   point(row + 2, column)};
        return agree(four[1], four[2]) || goes_on(four);
    };
    for (std::size_t row = 0; row + 1 < rows; ++row) {
        bool left = agree_upwards(row, 0);
        for (std::size_t column = 0; column < columns; ++column) {
            const std::size_t beside = (column + 1) % columns; // a whole turn closes
            const std::uint32_t a = point(row, column);
            const std::uint32_t b = point(row, beside);
            const std::uint32_t c = point(row + 1, column);
            const std::uint32_t d = point(row + 1, beside);
            const bool right = agree_upwards(row, beside);
            // Each half of the cell has one side along the row and one across it, which together speak for its
            // diagonal.
            if (b == kNothing || c == kNothing) {
                // The other diagonal, for cells with one corner missing.
                if (right && agree(a, b)) fill({a, b, d});
                if (left && agree(c, d)) fill({a, d, c});
            } else {
                if (left && agree(a, b)) fill({a, b, c});
                if (right && agree(c, d)) fill({b, d, c});
            }
            left = right;
        }
    }
}

// Between two pixels with points whose ranges agree.
void Closing::close_line(std::size_t start, std::size_t count, std::size_t stride) {
    const auto most = static_cast<std::size_t>(options_.most_pixels);
    std::size_t last = count; // of the last filled one; count: none yet
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t here = front_[start + i * stride];
        if (here == kNothing) continue;
        const bool small = last != count && i - last > 1 && i - last - 1 <= most;
        if (small && agree(front_[start + last * stride], here)) {
            for (std::size_t k = last + 1; k < i; ++k) {
                const std::size_t nearer = k - last <= i - k ? last : i;
                close(start + k * stride, front_[start + nearer * stride]);
            }
        }
        last = i;
    }
}

void Closing::along_picture() {
    if (options_.most_pixels <= 0) return;
    const std::size_t before = closed_.size();
    for (std::size_t row = 0; row < height_; ++row) close_line(row * width_, width_, 1);
    for (std::size_t i = before; i < closed_.size(); ++i) front_[closed_[i].pixel] = closed_[i].point;
    for (std::size_t column = 0; column < width_; ++column) close_line(column, height_, width_);
}

} // namespace

std::vector<ClosedPixel> close_gaps(const Projection& projection, const PicturePoints& points,
                                    const ClosingOptions& options) {
    Closing closing(projection, points, options);
    closing.along_grid();
    closing.along_picture();
    return closing.take();
}

} // namespace planum::scans
