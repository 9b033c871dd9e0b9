// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/model/place.hpp"
#include "core/model/unit.hpp"
#include "scans/surface/label_grid.hpp"
#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

/// Position of a unit in the list of units that evidence is gathered for.
using UnitNumber = std::int32_t;
inline constexpr UnitNumber kNobody = -1;

/// What the rules know of a unit besides where it lay.
struct KnownUnit {
    model::UnitId id;
    model::UnitKind kind = model::UnitKind::Unknown;
    model::UnitForm form = model::UnitForm::None;

    friend bool operator==(const KnownUnit&, const KnownUnit&) = default;
};

/// One surface ready to be compared: heights and whose they are. Vectors have frame.cells() values.
struct LabelledSurface {
    GridFrame frame;
    std::vector<std::int16_t> unit;        ///< UnitNumber; kNobody: not labelled, no unit, or not seen
    std::vector<model::RegionShows> shows; ///< of the region there
    std::vector<float> from_outline;       ///< to the nearest outline, in σ of the region there; at most 0.3 m
    std::vector<float> height;             ///< [m, site]; NaN where not seen
    std::vector<float> variance;           ///< of the height, from spread, noise and outline σ on the slope [m²]
    std::vector<float> common_variance;    ///< from the registration; shared by neighbours [m²]
};

struct HeightTolerance {
    double project = 0.02;       ///< the project's own, a 95 % bound [m]
    double sensor_sigma = 0.002; ///< of one point [m]
};

/// Puts outlines on a surface. `units[i]` is the unit of `regions[i]`, kNobody for those that are none. Throws
/// BadInput when the grids do not lie on the same cells.
[[nodiscard]] LabelledSurface label_surface(const SurfaceGrid& grid, const LabelGrid& labels,
                                            std::span<const model::Region> regions, std::span<const UnitNumber> units,
                                            const HeightTolerance& tolerance);

/// Whether a cell has both its units for sure: it lies 1σ and more from every outline, and 4σ from those of both
/// surfaces together. A line drawn astray makes a strip of one unit over the other where none was; each cell of it lies
/// no farther from the two lines together than the lines do from each other.
[[nodiscard]] bool is_clear_of_outlines(const LabelledSurface& upper, const LabelledSurface& lower,
                                        std::size_t cell) noexcept;

/// A unit on one surface.
struct Showing {
    UnitNumber unit = kNobody;
    std::int64_t cells = 0;
    std::int64_t level_cells = 0; ///< of these in regions that show a level
    std::int64_t cut_cells = 0;   ///< a bare cut
    std::int64_t overdug_cells = 0;
    double height = 0.0;    ///< median [m, site]
    double perimeter = 0.0; ///< [m]
    double open_edge = 0.0; ///< of its perimeter against nothing labelled [m]
};

/// Two units side by side on one surface; `a < b`.
struct SharedEdge {
    UnitNumber a = kNobody;
    UnitNumber b = kNobody;
    double length = 0.0; ///< [m]
};

struct SurfaceSummary {
    std::vector<Showing> showings; ///< by unit
    std::vector<SharedEdge> edges; ///< by a, b
};

[[nodiscard]] SurfaceSummary summarise(const LabelledSurface& surface);

/// What became of unit `first` where `then` lay on the next surface.
struct Succession {
    UnitNumber first = kNobody;
    UnitNumber then = kNobody;
    std::int64_t cells = 0;     ///< all, also near outlines
    std::int64_t lower = 0;     ///< away from outlines and lower than the tolerance
    std::int64_t thin = 0;      ///< away from outlines, no higher and no lower than the tolerance
    double drop = 0.0;          ///< median over `lower`, or over `thin` where there is none [m]
    double tolerance = 0.0;     ///< median bound that was applied [m]
    std::int64_t level = 0;     ///< of `lower`: either region shows a level
    std::int64_t cut_first = 0; ///< of `lower`: `first` was a bare cut
    std::int64_t cut_then = 0;  ///< `then` is a bare cut
    std::int64_t overdug = 0;   ///< either was dug too deep
    std::int64_t hidden = 0;    ///< cells in which a unit was opened and removed in between
};

/// The line between two units on one surface, followed to the next: how far it moved into either. Only what is
/// one of the two below as well is followed.
struct EdgeMigration {
    UnitNumber a = kNobody;
    UnitNumber b = kNobody;
    double length = 0.0;   ///< on the upper surface [m]
    double followed = 0.0; ///< of it, where the ground went down and is one of the two again [m]
    double into_a = 0.0;   ///< of `followed`: `b` came out below `a`, dipping no steeper than kFlatContact [m]
    double into_b = 0.0;
    double spit = 0.0; ///< median drop along it [m]
};

/// Contacts that dip less are layers one upon the other; steeper ones may be sides of cuts [rad].
inline constexpr double kFlatContact = 50.0 * 3.14159265358979323846 / 180.0;

/// All that two successive surfaces of one area say together.
struct SurfaceStep {
    double cell = 0.02;                  ///< side of a cell [m]
    std::vector<Succession> successions; ///< by first, then; same unit included
    std::vector<EdgeMigration> edges;    ///< by a, b
};

/// Walks every cell from one surface to the next. `floor` holds the lowest height of each cell so far (NaN:
/// none) and is brought up to date: a cell that rose proves nothing until it is below its former height.
/// `hidden` are cells in which something is known of units that were opened and removed in between.
[[nodiscard]] SurfaceStep step_between(const LabelledSurface& upper, const LabelledSurface& lower,
                                       const HeightTolerance& tolerance, std::span<const std::size_t> hidden,
                                       std::vector<float>& floor);

} // namespace planum::scans
