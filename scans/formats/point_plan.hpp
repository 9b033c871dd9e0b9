// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "scans/formats/block_builder.hpp"
#include "scans/formats/cloud_header.hpp"

namespace planum::scans {

/// What a column of a table of points means.
enum class Role : std::uint8_t { Other, X, Y, Z, Intensity, Red, Green, Blue, PackedRgb, Row, Column, Time };

inline constexpr std::size_t kRoleCount = 12;

/// The meaning of a property by the names that programs give it, any case; Other when unknown.
[[nodiscard]] Role role_of_name(std::string_view name);

/// The word we use for a role in messages: "x", "intensity", …
[[nodiscard]] std::string_view role_name(Role role) noexcept;

/// Collects values of intensity or colour and guesses their range from them.
class ValueSampler {
  public:
    void add(double value) noexcept;

    [[nodiscard]] bool empty() const noexcept { return count_ == 0; }

    /// [0, 1] is spread over 16 bits; whole numbers are kept as they are; other ranges are spread from
    /// or around zero up to the next power of two.
    [[nodiscard]] IntensityCoding intensity_coding() const noexcept;

    /// Factor that makes 0 … 255 of it: 255 for fractions, 1 for bytes, 1/257 for 16 bits.
    [[nodiscard]] double colour_scale() const noexcept;

  private:
    double minimum_ = 0.0;
    double maximum_ = 0.0;
    std::uint64_t count_ = 0;
    bool whole_ = true;
};

/// Where in a record each role stands, and how its values become ours.
struct PointPlan {
    std::array<int, kRoleCount> at{}; ///< index among the record's values; -1: absent
    IntensityCoding intensity;
    double colour_scale = 1.0;

    [[nodiscard]] int index(Role role) const noexcept { return at[static_cast<std::size_t>(role)]; }

    [[nodiscard]] bool has(Role role) const noexcept { return index(role) >= 0; }

    [[nodiscard]] bool has_place() const noexcept { return has(Role::X) && has(Role::Y) && has(Role::Z); }

    [[nodiscard]] bool has_colour() const noexcept;
    [[nodiscard]] Columns columns() const noexcept;

    /// Puts one record at the builder's slot, without committing it.
    void place(std::span<const double> values, BlockBuilder& builder) const;

    /// Looks at one record to guess ranges.
    void sample(std::span<const double> values, ValueSampler& intensities, ValueSampler& colours) const noexcept;
};

/// The first column of each role counts.
[[nodiscard]] PointPlan plan_of(std::span<const Role> roles) noexcept;

} // namespace planum::scans
