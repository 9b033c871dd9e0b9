// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/ids.hpp"

namespace planum::model {

/// How ground is taken down: along the units, in artificial levels, or both.
enum class DigMethod { Stratigraphic, Planum, Mixed };

/// A trench, with its own number series where the project says so.
struct Area {
    AreaId id;
    std::string name;
    std::string title;
    DigMethod method = DigMethod::Stratigraphic;
    std::string first_number; ///< block of unit numbers issued to this area; empty: none
    std::string last_number;

    friend bool operator==(const Area&, const Area&) = default;
};

/// One recorded state of one area. A day may hold several, one may span days.
struct Surface {
    SurfaceId id;
    AreaId area;
    std::string name; ///< `Planum 3`; empty: the day is its name
    DigMethod method = DigMethod::Stratigraphic;
    std::string first_day; ///< ISO date
    std::string last_day;
    std::int64_t order = 0; ///< among the surfaces of the area, ascending in time

    friend bool operator==(const Surface&, const Surface&) = default;
};

/// The last day of a surface; its only one where none is given.
[[nodiscard]] const std::string& last_day_of(const Surface& surface) noexcept;

/// A vertical plane through two surveyed points of the site grid [m].
struct Section {
    SectionId id;
    AreaId area;
    std::string name;
    std::array<double, 2> from_in_site{};
    std::array<double, 2> to_in_site{};
    std::string day;

    friend bool operator==(const Section&, const Section&) = default;
};

/// What a region shows of its unit; decides what its heights may prove.
enum class RegionShows { Top, Level, Cut, Overdug, Machine, Face, Nothing };

/// What an outline encloses. Only Unit has a stratigraphic meaning.
enum class RegionCategory { Unit, Spoil, Slump, Backfill, Water, Equipment, Baulk, Unexcavated };

/// One closed ring of points (x, y, z) in site coordinates [m]; the last point is not repeated.
using Ring = std::vector<std::array<double, 3>>;

/// A polygon with holes.
struct Polygon {
    Ring outer;
    std::vector<Ring> holes;

    friend bool operator==(const Polygon&, const Polygon&) = default;
};

/// A labelled outline on a surface or on a section.
struct Region {
    RegionId id;
    SurfaceId surface; ///< nil when it lies on a section
    SectionId section;
    UnitId unit;               ///< nil: not named yet, or no unit
    std::string unit_as_drawn; ///< the number as written when no such unit exists
    std::int64_t part = 1;     ///< `SURFACE/UNIT#n`
    RegionCategory category = RegionCategory::Unit;
    RegionShows shows = RegionShows::Top;
    double sigma = 0.03;  ///< of the outline's position [m]
    std::string drawn_on; ///< panorama, plan, section, typed, imported
    std::vector<Polygon> outline;
    bool has_heights = true; ///< false: nobody knows them, and every z of the outline is 0
    UnitId seen_in;          ///< the cut whose side shows this region
    std::string notes;

    friend bool operator==(const Region&, const Region&) = default;
};

[[nodiscard]] std::string_view to_word(DigMethod method) noexcept;
[[nodiscard]] std::string_view to_word(RegionShows shows) noexcept;
[[nodiscard]] std::string_view to_word(RegionCategory category) noexcept;
[[nodiscard]] std::optional<DigMethod> dig_method_from_word(std::string_view word) noexcept;
[[nodiscard]] std::optional<RegionShows> region_shows_from_word(std::string_view word) noexcept;
[[nodiscard]] std::optional<RegionCategory> region_category_from_word(std::string_view word) noexcept;

} // namespace planum::model
