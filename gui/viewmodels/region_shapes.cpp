// SPDX-License-Identifier: MIT
#include "gui/viewmodels/region_shapes.hpp"

#include <algorithm>
#include <cmath>

#include "app/regions/outline.hpp"
#include "app/regions/region_layout.hpp"
#include "app/regions/region_names.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

namespace {

double area_of(const PointList& ring) {
    double twice = 0.0;
    for (qsizetype i = 0; i < ring.size(); ++i) {
        const QPointF& a = ring[i];
        const QPointF& b = ring[(i + 1) % ring.size()];
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return twice / 2.0;
}

bool is_inside(const std::vector<PointList>& rings, QPointF place) {
    bool inside = false;
    for (const PointList& ring : rings) {
        for (qsizetype i = 0; i < ring.size(); ++i) {
            const QPointF& a = ring[i];
            const QPointF& b = ring[(i + 1) % ring.size()];
            if ((a.y() > place.y()) == (b.y() > place.y())) continue;
            if (place.x() < a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
        }
    }
    return inside;
}

// The middle of the widest stretch on a level line through the ring: always inside, unlike a centroid.
QPointF label_place(const std::vector<PointList>& rings) {
    const auto largest = std::max_element(rings.begin(), rings.end(), [](const auto& a, const auto& b) {
        return std::abs(area_of(a)) < std::abs(area_of(b));
    });
    if (largest == rings.end()) return {};
    const QRectF box = bounds_of(*largest);
    QPointF best = box.center();
    double widest = 0.0;
    for (int step = 3; step <= 7; ++step) {
        const double y = box.top() + box.height() * step / 10.0;
        std::vector<double> crossings;
        for (const PointList& ring : rings) {
            for (qsizetype i = 0; i < ring.size(); ++i) {
                const QPointF& a = ring[i];
                const QPointF& b = ring[(i + 1) % ring.size()];
                if ((a.y() > y) == (b.y() > y)) continue;
                crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
            }
        }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            const double width = (crossings[i + 1] - crossings[i]) * (step == 5 ? 1.15 : 1.0);
            if (width <= widest) continue;
            widest = width;
            best = {(crossings[i] + crossings[i + 1]) / 2.0, y};
        }
    }
    return best;
}

RegionShape shape_of_region(const app::Snapshot& snapshot, const model::Region& region,
                            const geometry::MultiPolygon& flat) {
    RegionShape shape;
    shape.region = region.id;
    shape.unit = region.unit;
    shape.category = region.category;
    shape.shows = region.shows;
    shape.label = outline_word(snapshot.index(), region);
    const model::UnitIndex at = snapshot.index().find(region.unit);
    if (at != model::kNoUnit) {
        shape.kind = snapshot.record().units[at].kind;
        shape.form = snapshot.record().units[at].form;
    }
    for (const auto& polygon : flat) {
        bool outer = true;
        for (const auto& line : polygon) {
            PointList ring;
            for (const auto& p : line) ring << QPointF(p[0], p[1]);
            shape.area += (outer ? 1.0 : -1.0) * std::abs(area_of(ring));
            shape.rings.push_back(std::move(ring));
            outer = false;
        }
    }
    shape.middle = label_place(shape.rings);
    return shape;
}

void largest_first(std::vector<RegionShape>& shapes) {
    std::stable_sort(shapes.begin(), shapes.end(), [](const auto& a, const auto& b) { return a.area > b.area; });
}

} // namespace

std::vector<RegionShape> regions_in_plan(const app::Snapshot& snapshot, model::SurfaceId surface) {
    std::vector<RegionShape> shapes;
    for (const model::Region* region : app::regions_on(snapshot.record(), surface)) {
        shapes.push_back(shape_of_region(snapshot, *region, app::shape_of(region->outline)));
    }
    largest_first(shapes);
    return shapes;
}

std::vector<RegionShape> regions_in_section(const app::Snapshot& snapshot, const model::Section& section) {
    std::vector<RegionShape> shapes;
    for (const model::Region* region : app::regions_on(snapshot.record(), section.id)) {
        shapes.push_back(shape_of_region(snapshot, *region, app::onto_plane(app::shape_of(region->outline), section)));
    }
    largest_first(shapes);
    return shapes;
}

const RegionShape* region_under(const std::vector<RegionShape>& shapes, QPointF place) {
    for (auto it = shapes.rbegin(); it != shapes.rend(); ++it) {
        if (is_inside(it->rings, place)) return &*it;
    }
    return nullptr;
}

QRectF bounds_of(const PointList& points) {
    if (points.isEmpty()) return {};
    QPointF low = points.front();
    QPointF high = low;
    for (const QPointF& p : points) {
        low = {std::min(low.x(), p.x()), std::min(low.y(), p.y())};
        high = {std::max(high.x(), p.x()), std::max(high.y(), p.y())};
    }
    return {low, high};
}

QRectF bounds_of(const std::vector<RegionShape>& shapes) {
    QRectF all;
    for (const RegionShape& shape : shapes) {
        for (const PointList& ring : shape.rings) all = all.united(bounds_of(ring));
    }
    return all;
}

std::optional<QPointF> snap(const std::vector<RegionShape>& shapes, QPointF place, double reach) {
    std::optional<QPointF> corner;
    std::optional<QPointF> on_line;
    double corner_away = reach;
    double line_away = reach;
    const auto distance = [&](QPointF p) { return std::hypot(p.x() - place.x(), p.y() - place.y()); };
    for (const RegionShape& shape : shapes) {
        for (const PointList& ring : shape.rings) {
            for (qsizetype i = 0; i < ring.size(); ++i) {
                const QPointF a = ring[i];
                const QPointF d = ring[(i + 1) % ring.size()] - a;
                if (distance(a) <= corner_away) {
                    corner = a;
                    corner_away = distance(a);
                }
                const double length2 = QPointF::dotProduct(d, d);
                const double t =
                    length2 > 0.0 ? std::clamp(QPointF::dotProduct(place - a, d) / length2, 0.0, 1.0) : 0.0;
                if (distance(a + t * d) > line_away) continue;
                on_line = a + t * d;
                line_away = distance(*on_line);
            }
        }
    }
    return corner ? corner : on_line;
}

} // namespace planum::gui
