// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace planum::app::demo {

/// A point or direction; in the site grid [m] unless said otherwise.
struct Vec3 {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;

    friend bool operator==(const Vec3&, const Vec3&) = default;
};

[[nodiscard]] constexpr Vec3 operator+(const Vec3& a, const Vec3& b) noexcept {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

[[nodiscard]] constexpr Vec3 operator-(const Vec3& a, const Vec3& b) noexcept {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

[[nodiscard]] constexpr Vec3 operator*(double s, const Vec3& a) noexcept { return {s * a.x, s * a.y, s * a.z}; }

[[nodiscard]] constexpr double dot(const Vec3& a, const Vec3& b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// An upright box, both ends included [m].
struct Bounds {
    Vec3 low;
    Vec3 high;

    [[nodiscard]] bool holds(double x, double y) const noexcept {
        return x >= low.x && x <= high.x && y >= low.y && y <= high.y;
    }
};

/// Heights on a square lattice, bilinear between. This *is* the surface, not an approximation of one.
class HeightTable {
  public:
    HeightTable() = default;
    /// Covers [low, high] in x and y with nodes every `step` metres.
    HeightTable(const Bounds& extent, double step);

    [[nodiscard]] double at(double x, double y) const noexcept;

    [[nodiscard]] std::size_t columns() const noexcept { return columns_; }

    [[nodiscard]] std::size_t rows() const noexcept { return rows_; }

    [[nodiscard]] double x_of(std::size_t column) const noexcept { return x0_ + static_cast<double>(column) * step_; }

    [[nodiscard]] double y_of(std::size_t row) const noexcept { return y0_ + static_cast<double>(row) * step_; }

    [[nodiscard]] float& node(std::size_t column, std::size_t row) noexcept {
        return heights_[row * columns_ + column];
    }

    [[nodiscard]] double node(std::size_t column, std::size_t row) const noexcept {
        return static_cast<double>(heights_[row * columns_ + column]);
    }

    [[nodiscard]] double highest() const noexcept;
    [[nodiscard]] Bounds extent() const noexcept;

    template<class HeightOf> // double(x, y)
    void fill(HeightOf height_of) {
        for (std::size_t row = 0; row < rows_; ++row) {
            for (std::size_t column = 0; column < columns_; ++column) {
                node(column, row) = static_cast<float>(height_of(x_of(column), y_of(row)));
            }
        }
    }

  private:
    double x0_ = 0.0;
    double y0_ = 0.0;
    double step_ = 1.0;
    double per_step_ = 1.0;
    std::size_t columns_ = 0;
    std::size_t rows_ = 0;
    std::vector<float> heights_;
};

/// How the side of a cut goes down.
enum class Profile { Vertical, Sloping, Bowl, Bell, Vee };

enum class Plan { Round, Linear };

/// The hollow of a cut as a solid: everything that was dug away in antiquity.
struct CutShape {
    Plan plan = Plan::Round;
    Profile profile = Profile::Vertical;
    double x = 0.0;
    double y = 0.0;
    double axis_x = 1.0; ///< unit vector along the long side
    double axis_y = 0.0;
    double aspect = 1.0;            ///< round: length over width
    double half_length = 0.0;       ///< linear [m]
    double radius = 0.5;            ///< widest half width [m]
    double mouth = 0.0;             ///< height of the rim in the middle [m]
    double base = 0.0;              ///< height of the bottom [m]
    std::array<double, 3> wobble{}; ///< of the outline, as shares of the radius

    [[nodiscard]] bool contains(const Vec3& p) const noexcept;
    [[nodiscard]] Bounds bounds() const noexcept;
    /// Half width at a height, before the wobble [m].
    [[nodiscard]] double half_width(double z) const noexcept;
};

/// A wall on its footing.
struct WallShape {
    double x = 0.0;
    double y = 0.0;
    double axis_x = 1.0;
    double axis_y = 0.0;
    double half_length = 1.0;  ///< [m]
    double half_width = 0.25;  ///< above the footing [m]
    double footing_half = 0.3; ///< half width of the footing [m]
    double base = 0.0;
    double footing_top = 0.0;
    double top = 0.0; ///< of the stump, without its raggedness
    std::uint64_t seed = 0;

    /// The footing is only inside its trench.
    [[nodiscard]] bool contains(const Vec3& p, bool in_trench) const noexcept;
    [[nodiscard]] Bounds bounds() const noexcept;
};

} // namespace planum::app::demo
