// SPDX-License-Identifier: MIT
#include "gui/viewmodels/plan_ground.hpp"

#include <limits>

#include "app/regions/surface_heights.hpp"

namespace planum::gui {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

void lay_on(model::SurfaceId id, app::Project& project, geometry::MultiPolygon& shape, Progress& progress) {
    for (const model::Surface& surface : project.record().surfaces) {
        if (surface.id == id) app::take_surface_heights(project, surface, shape, progress);
    }
}

} // namespace

OutlineTool::ToOutlines plan_ground(model::SurfaceId surface) {
    return [surface](app::Project& project, const app::DrawnOutline& labels, const PointList& corners,
                     Progress& progress) {
        app::DrawnOutline outline = labels;
        outline.on_surface = surface;
        outline.drawn_on = "plan";
        geometry::Line3 ring;
        for (const QPointF& p : corners) ring.push_back({p.x(), p.y(), kUnknown});
        outline.shape = {{ring}};
        lay_on(surface, project, outline.shape, progress);
        return app::OutlineFile{{outline}, {}};
    };
}

EditGround plan_edit_ground(model::SurfaceId surface) {
    EditGround edit;
    edit.to_view = [](const geometry::Point3& x_in_site) { return QPointF(x_in_site[0], x_in_site[1]); };
    edit.to_site = [](QPointF from, QPointF to) {
        return geometry::Line3{{from.x(), from.y(), kUnknown}, {to.x(), to.y(), kUnknown}};
    };
    edit.heights = [surface](app::Project& project, geometry::MultiPolygon& shape, Progress& progress) {
        lay_on(surface, project, shape, progress);
    };
    return edit;
}

} // namespace planum::gui
