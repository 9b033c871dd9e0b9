// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <optional>
#include <vector>

#include "app/project/snapshot.hpp"
#include "core/model/place.hpp"
#include "core/model/unit.hpp"

namespace planum::gui {

/// Corners one after the other; a ring does not repeat the first.
using PointList = QList<QPointF>;

/// A region as a flat drawing shows it.
struct RegionShape {
    model::RegionId region;
    model::UnitId unit;
    QString label; ///< unit, number as drawn, or category
    model::RegionCategory category = model::RegionCategory::Unit;
    model::RegionShows shows = model::RegionShows::Top;
    model::UnitKind kind = model::UnitKind::Unknown;
    model::UnitForm form = model::UnitForm::None;
    std::vector<PointList> rings; ///< outer rings and holes; filled even-odd
    QPointF middle;               ///< inside the largest outer ring: where its label stands
    double area = 0.0;            ///< of the rings
};

/// Regions of a surface in site coordinates (x, y) [m], largest first, so that small ones are painted over.
[[nodiscard]] std::vector<RegionShape> regions_in_plan(const app::Snapshot& snapshot, model::SurfaceId surface);

/// Regions of a section as (metres along it, height) [m], largest first.
[[nodiscard]] std::vector<RegionShape> regions_in_section(const app::Snapshot& snapshot, const model::Section& section);

/// The region under a place: the last painted; nullptr where there is none.
[[nodiscard]] const RegionShape* region_under(const std::vector<RegionShape>& shapes, QPointF place);

[[nodiscard]] QRectF bounds_of(const PointList& points);
/// Bounds of all; null where there is nothing.
[[nodiscard]] QRectF bounds_of(const std::vector<RegionShape>& shapes);

/// The corner within `reach` of a place, else the nearest place on a line within reach: what a new outline snaps to.
[[nodiscard]] std::optional<QPointF> snap(const std::vector<RegionShape>& shapes, QPointF place, double reach);

} // namespace planum::gui
