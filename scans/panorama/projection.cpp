// SPDX-License-Identifier: MIT
#include "scans/panorama/projection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "scans/panorama/quick_angle.hpp"

// Two doubles at once is what every x86-64 does; most do four. Multiply-and-add stays off, so that both give the same
// bits.
#if defined(__x86_64__) && defined(__GNUC__)
#define PLANUM_INTO_CALLER [[gnu::always_inline]] inline
#define PLANUM_FOUR_AT_ONCE [[gnu::target("avx2")]]
#else
#define PLANUM_INTO_CALLER
#define PLANUM_FOUR_AT_ONCE
#endif

namespace planum::scans {

namespace {

#if defined(__x86_64__) && defined(__GNUC__)
const bool kFourAtOnce = __builtin_cpu_supports("avx2") != 0;
#else
constexpr bool kFourAtOnce = false;
#endif

constexpr double kPi = std::numbers::pi;

constexpr std::array<std::string_view, 8> kNames = {"equirectangular", "cylindrical", "mercator", "miller",
                                                    "equal-area",      "rectilinear", "pannini",  "stereographic"};

} // namespace

std::string_view projection_name(ProjectionKind kind) noexcept { return kNames[static_cast<std::size_t>(kind)]; }

std::optional<ProjectionKind> projection_from_name(std::string_view name) noexcept {
    const auto* const found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return static_cast<ProjectionKind>(found - kNames.begin());
}

namespace {

constexpr bool with_views(ProjectionKind kind) noexcept {
    return kind == ProjectionKind::Rectilinear || kind == ProjectionKind::Pannini ||
           kind == ProjectionKind::Stereographic;
}

// Height in the picture's plane, for the projections around a cylinder: `up` over `flat` is the tangent of the
// elevation.
template<ProjectionKind K>
PLANUM_INTO_CALLER double height_of(double up, double flat) noexcept {
    if constexpr (K == ProjectionKind::Equirectangular) return quick_atan2(up, flat);
    if constexpr (K == ProjectionKind::Cylindrical) return up / flat;
    if constexpr (K == ProjectionKind::Mercator) {
        return std::copysign(quick_log((std::abs(up) + std::sqrt(up * up + flat * flat)) / flat), up);
    }
    if constexpr (K == ProjectionKind::Miller) {
        // asinh(tan φ) = ½ log((1 + sin φ) / (1 − sin φ)), which is quicker.
        const double sine = quick_sin(0.8 * quick_atan2(up, flat));
        return 0.625 * quick_log((1.0 + sine) / (1.0 - sine));
    }
    return up / std::sqrt(up * up + flat * flat); // equal-area
}

// Calls `work` with the kind as a constant.
template<class Work>
auto for_kind(ProjectionKind kind, Work work) {
    using enum ProjectionKind;
    switch (kind) {
    case Equirectangular: return work(std::integral_constant<ProjectionKind, Equirectangular>{});
    case Cylindrical: return work(std::integral_constant<ProjectionKind, Cylindrical>{});
    case Mercator: return work(std::integral_constant<ProjectionKind, Mercator>{});
    case Miller: return work(std::integral_constant<ProjectionKind, Miller>{});
    case EqualArea: return work(std::integral_constant<ProjectionKind, EqualArea>{});
    case Rectilinear: return work(std::integral_constant<ProjectionKind, Rectilinear>{});
    case Pannini: return work(std::integral_constant<ProjectionKind, Pannini>{});
    case Stereographic: break;
    }
    return work(std::integral_constant<ProjectionKind, Stereographic>{});
}

} // namespace

bool Projection::has_views() const noexcept { return with_views(options_.kind); }

double Projection::elevation_of(double height) const noexcept {
    switch (options_.kind) {
    case ProjectionKind::Equirectangular: return height;
    case ProjectionKind::Cylindrical: return std::atan(height);
    case ProjectionKind::Mercator: return std::atan(std::sinh(height));
    case ProjectionKind::Miller: return 1.25 * std::atan(std::sinh(0.8 * height));
    case ProjectionKind::EqualArea: return std::asin(std::clamp(height, -1.0, 1.0));
    case ProjectionKind::Rectilinear:
    case ProjectionKind::Pannini:
    case ProjectionKind::Stereographic: break;
    }
    return 0.0;
}

template<ProjectionKind K>
PLANUM_INTO_CALLER Projection::Plane Projection::forward(double a, double b, double c) const noexcept {
    if constexpr (K == ProjectionKind::Rectilinear) return {b / a, c / a};
    if constexpr (K == ProjectionKind::Pannini) {
        // Sharpless, Postle, German 2010: S = (d + 1) / (d + cos λ), x = S sin λ, y = S tan φ.
        const double flat = std::sqrt(a * a + b * b);
        const double s = (options_.distance + 1.0) / (options_.distance * flat + a);
        return {s * b, s * c};
    }
    // Snyder 1987, eq. 21-2 to 21-4 with the centre at (0, 0) and a sphere of radius 1.
    const double k = 2.0 / (std::sqrt(a * a + b * b + c * c) + a);
    return {k * b, k * c};
}

Eigen::Vector3d Projection::backward(const Plane& p) const noexcept {
    if (options_.kind == ProjectionKind::Rectilinear) return Eigen::Vector3d(1.0, p.x, p.y).normalized();
    if (options_.kind == ProjectionKind::Pannini) {
        const double d = options_.distance;
        const double k = p.x * p.x / ((d + 1.0) * (d + 1.0));
        const double root = std::sqrt(std::max(0.0, k * k * d * d - (k + 1.0) * (k * d * d - 1.0)));
        const double cosine = (-k * d + root) / (k + 1.0);
        const double s = (d + 1.0) / (d + cosine);
        return Eigen::Vector3d(cosine, p.x / s, p.y / s).normalized();
    }
    const double q = 0.25 * (p.x * p.x + p.y * p.y);
    return Eigen::Vector3d(1.0 - q, p.x, p.y) / (1.0 + q);
}

Projection::Projection(const ProjectionOptions& options) : options_(options) {
    const double span = options.azimuth_to - options.azimuth_from;
    const bool sane = options.width >= 1 && options.height >= 1 && options.width <= 100000 &&
                      options.height <= 100000 &&
                      static_cast<std::int64_t>(options.width) * options.height <= 1000000000;
    if (!sane)
        throw Error(ErrorCode::Usage, fmt::format("a panorama of {} x {} pixels", options.width, options.height));
    const double reach = std::max(std::abs(options.elevation_from), std::abs(options.elevation_to));
    const bool shows_poles = options.kind == ProjectionKind::Equirectangular ||
                             options.kind == ProjectionKind::EqualArea || options.kind == ProjectionKind::Miller ||
                             options.kind == ProjectionKind::Stereographic;
    const double limit = shows_poles ? kPi / 2.0 : kPi / 2.0 * 0.99;
    if (!(span > 0.0 && span <= 2.0 * kPi + 1e-9) || !(options.elevation_from < options.elevation_to) ||
        !(reach <= limit + 1e-9)) {
        throw Error(
            ErrorCode::Usage,
            fmt::format("a {} panorama cannot show elevations up to {:.1f} degrees or azimuths over {:.1f} degrees",
                        projection_name(options.kind), reach * 180.0 / kPi, span * 180.0 / kPi));
    }
    views_ = has_views() ? std::clamp(options.views, 1, options.width) : 1;
    view_angle_ = span / views_;
    if (has_views() && view_angle_ > 170.0 * kPi / 180.0) {
        throw Error(ErrorCode::Usage,
                    fmt::format("views of {:.0f} degrees are too wide, take at least {} of them",
                                view_angle_ * 180.0 / kPi, static_cast<int>(std::ceil(span / (170.0 * kPi / 180.0)))));
    }
    for (int view = 0; view < views_; ++view) {
        const double middle = options.azimuth_to - (view + 0.5) * view_angle_;
        middles_.push_back({std::cos(middle), std::sin(middle)});
    }
    const double bottom = for_kind(options.kind, [&](auto kind) {
        const double up = options.elevation_to;
        const double down = options.elevation_from;
        if constexpr (with_views(kind())) {
            plane_left_ = forward<kind()>(std::cos(view_angle_ / 2.0), std::sin(view_angle_ / 2.0), 0.0).x;
            plane_top_ = forward<kind()>(std::cos(up), 0.0, std::sin(up)).y;
            return forward<kind()>(std::cos(down), 0.0, std::sin(down)).y;
        } else {
            plane_left_ = span / 2.0;
            plane_top_ = height_of<kind()>(std::sin(up), std::cos(up));
            return height_of<kind()>(std::sin(down), std::cos(down));
        }
    });
    scale_x_ = static_cast<double>(options.width) / views_ / (2.0 * plane_left_);
    scale_y_ = options.height / (plane_top_ - bottom);
}

ProjectionOptions with_square_pixels(ProjectionOptions options, double step, int most_width) {
    const Projection whole(options); // only its plane is of interest, whatever its size in pixels
    const double across = 2.0 * whole.plane_left_ * whole.views_;
    const double up = options.height / whole.scale_y_;
    const double pixel = std::max(step, across / most_width);
    options.width = std::max(1, static_cast<int>(std::lround(across / pixel)));
    options.height = std::max(1, static_cast<int>(std::lround(up / pixel)));
    return options;
}

// To the right of the left border, 0 … 2π.
PLANUM_INTO_CALLER double Projection::right_of(double x, double y) const noexcept {
    double right = options_.azimuth_to - quick_atan2(y, x);
    right = right < 0.0 ? right + 2.0 * kPi : right;
    return right >= 2.0 * kPi ? right - 2.0 * kPi : right;
}

template<ProjectionKind K>
PLANUM_INTO_CALLER Projection::Pixel Projection::locate_in_view(int view, const Plane& middle, double x, double y,
                                                                double z) const noexcept {
    const Plane p = forward<K>(middle.x * x + middle.y * y, middle.x * y - middle.y * x, z);
    const double strip = static_cast<double>(options_.width) / views_;
    // A direction on the border between two views belongs to one of them whatever rounding says.
    return {view * strip + std::clamp((plane_left_ - p.x) * scale_x_, 0.0, strip), (plane_top_ - p.y) * scale_y_};
}

template<ProjectionKind K>
Projection::Pixel Projection::locate(double x, double y, double z) const noexcept {
    const double right = right_of(x, y);
    if constexpr (!with_views(K)) {
        return {right * scale_x_, (plane_top_ - height_of<K>(z, std::sqrt(x * x + y * y))) * scale_y_};
    } else {
        const double share = right / view_angle_;
        if (!(share >= 0.0 && share < views_)) return {}; // beyond the left border, or no direction at all
        const int view = static_cast<int>(share);
        return locate_in_view<K>(view, middles_[static_cast<std::size_t>(view)], x, y, z);
    }
}

/// Directions, then the pixels they fall on (u over x, v over y).
struct Projection::Portion {
    std::array<double, kPortion> x{};
    std::array<double, kPortion> y{};
    std::array<double, kPortion> z{};
    std::array<double, kPortion> share{}; ///< how many views to the right of the left border
    std::array<Plane, kPortion> middle{}; ///< of that view
};

// As locate() does one by one; where there are views, which one is looked up between two loops that compilers can
// widen.
template<ProjectionKind K>
PLANUM_INTO_CALLER void Projection::locate_each(Portion& __restrict portion) const noexcept {
    if constexpr (!with_views(K)) {
        for (std::size_t i = 0; i < kPortion; ++i) {
            const double flat = std::sqrt(portion.x[i] * portion.x[i] + portion.y[i] * portion.y[i]);
            const double u = right_of(portion.x[i], portion.y[i]) * scale_x_;
            portion.y[i] = (plane_top_ - height_of<K>(portion.z[i], flat)) * scale_y_;
            portion.x[i] = u;
        }
    } else {
        for (std::size_t i = 0; i < kPortion; ++i) {
            portion.share[i] = right_of(portion.x[i], portion.y[i]) / view_angle_;
        }
        for (std::size_t i = 0; i < kPortion; ++i) {
            const double share = portion.share[i];
            portion.middle[i] = share >= 0.0 && share < views_ ? middles_[static_cast<std::size_t>(share)] : Plane{};
        }
        for (std::size_t i = 0; i < kPortion; ++i) {
            const double share = portion.share[i];
            const bool seen = share >= 0.0 && share < views_;
            const int view = static_cast<int>(seen ? share : 0.0);
            const Pixel pixel = locate_in_view<K>(view, portion.middle[i], portion.x[i], portion.y[i], portion.z[i]);
            portion.x[i] = seen ? pixel.u : -1.0;
            portion.y[i] = seen ? pixel.v : -1.0;
        }
    }
}

template<ProjectionKind K>
void Projection::locate_portion(Portion& portion) const noexcept {
    locate_each<K>(portion);
}

template<ProjectionKind K>
PLANUM_FOUR_AT_ONCE void Projection::locate_portion_wide(Portion& portion) const noexcept {
    locate_each<K>(portion);
}

std::uint32_t Projection::index_at(const Pixel& pixel) const noexcept {
    const bool inside = holds(pixel);
    const int column = std::min(static_cast<int>(inside ? pixel.u : 0.0), options_.width - 1);
    const int row = std::min(static_cast<int>(inside ? pixel.v : 0.0), options_.height - 1);
    return inside ? static_cast<std::uint32_t>(row * options_.width + column) : kOutside;
}

bool Projection::holds(const Pixel& pixel) const noexcept {
    return pixel.u >= 0.0 && pixel.u <= options_.width && pixel.v >= 0.0 && pixel.v <= options_.height;
}

// Where the points fall, in portions of one size and without branches: compilers do several points at once then.
void Projection::indices_of(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                            std::span<std::uint32_t> out) const noexcept {
    for_kind(options_.kind, [&](auto kind) {
        Portion in;
        for (std::size_t from = 0; from < out.size(); from += kPortion) {
            const std::size_t count = std::min(kPortion, out.size() - from);
            std::copy_n(x.begin() + static_cast<std::ptrdiff_t>(from), count, in.x.begin());
            std::copy_n(y.begin() + static_cast<std::ptrdiff_t>(from), count, in.y.begin());
            std::copy_n(z.begin() + static_cast<std::ptrdiff_t>(from), count, in.z.begin());
            if (kFourAtOnce) {
                locate_portion_wide<kind()>(in);
            } else {
                locate_portion<kind()>(in);
            }
            for (std::size_t i = 0; i < count; ++i) out[from + i] = index_at({in.x[i], in.y[i]});
        }
    });
}

int Projection::view_at(double u) const noexcept {
    return std::min(static_cast<int>(u / (static_cast<double>(options_.width) / views_)), views_ - 1);
}

std::optional<Eigen::Vector2d> Projection::pixel_of(const Eigen::Vector3d& direction) const noexcept {
    const Pixel pixel =
        for_kind(options_.kind, [&](auto kind) { return locate<kind()>(direction.x(), direction.y(), direction.z()); });
    if (!holds(pixel)) return std::nullopt;
    return Eigen::Vector2d(pixel.u, pixel.v);
}

std::int64_t Projection::index_of(double x, double y, double z) const noexcept {
    const std::uint32_t index = for_kind(options_.kind, [&](auto kind) { return index_at(locate<kind()>(x, y, z)); });
    return index == kOutside ? -1 : std::int64_t{index};
}

std::optional<Eigen::Vector3d> Projection::ray_of(const Eigen::Vector2d& pixel) const noexcept {
    const bool inside =
        pixel.x() >= 0.0 && pixel.x() <= options_.width && pixel.y() >= 0.0 && pixel.y() <= options_.height;
    if (!inside) return std::nullopt;
    const double height = plane_top_ - pixel.y() / scale_y_;
    if (!has_views()) {
        const double azimuth = options_.azimuth_to - pixel.x() / scale_x_;
        const double elevation = elevation_of(height);
        return Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                               std::sin(elevation));
    }
    const double strip = static_cast<double>(options_.width) / views_;
    const int view = view_at(pixel.x());
    const Eigen::Vector3d own = backward({plane_left_ - (pixel.x() - view * strip) / scale_x_, height});
    // Corners of a stereographic or Pannini view may lie beyond its share of the horizon.
    if (std::abs(std::atan2(own.y(), own.x())) > view_angle_ / 2.0 + 1e-12) return std::nullopt;
    const Plane& middle = middles_[static_cast<std::size_t>(view)];
    return Eigen::Vector3d(middle.x * own.x() - middle.y * own.y(), middle.y * own.x() + middle.x * own.y(), own.z());
}

} // namespace planum::scans
