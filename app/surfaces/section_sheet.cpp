// SPDX-License-Identifier: MIT
#include "app/surfaces/section_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "app/regions/region_layout.hpp"
#include "app/regions/region_names.hpp"
#include "app/regions/region_points.hpp"
#include "app/scans/days_surface.hpp"
#include "app/scans/surface_scans.hpp"
#include "app/surfaces/recorded_surface.hpp"
#include "app/surfaces/sheet_looks.hpp"
#include "app/surfaces/surface_picture.hpp"
#include "core/base/error.hpp"
#include "core/geometry/polygon_overlay.hpp"
#include "scans/surface/label_grid.hpp"

namespace planum::app {

namespace {

constexpr double kInPlane = 0.1; // outlines farther off belong to another section [m]
constexpr double kSpare = 0.2;   // above and below [m]

struct SeenPoint {
    float along = 0.0F; // [m]
    float height = 0.0F;
    scans::Rgb colour;
    std::uint16_t intensity = 0;
    bool has_colour = false;
    std::size_t surface = 0; // place among those of the section
};

// A surface whose scans may lie in the plane; nullptr for scans of none.
struct SeenSurface {
    const model::Surface* surface = nullptr;
    std::size_t points = 0;
};

// In time, so that later ones are painted over earlier ones.
std::vector<SeenSurface> surfaces_of(const model::Record& record, const model::Surface* only) {
    if (only != nullptr) return {{only}};
    std::vector<SeenSurface> all;
    for (const model::Surface& surface : record.surfaces) all.push_back({&surface});
    std::stable_sort(all.begin(), all.end(), [](const SeenSurface& a, const SeenSurface& b) {
        return std::tie(a.surface->first_day, a.surface->order) < std::tie(b.surface->first_day, b.surface->order);
    });
    all.insert(all.begin(), SeenSurface{});
    return all;
}

RegionGround slab_of(const SectionRequest& request, double length) {
    const double ax = (request.to[0] - request.from[0]) / length;
    const double ay = (request.to[1] - request.from[1]) / length;
    RegionGround slab;
    slab.frame_from_site.rotation << ax, ay, 0.0, 0.0, 0.0, 1.0, ay, -ax, 0.0;
    slab.frame_from_site.translation =
        -(slab.frame_from_site.rotation * Eigen::Vector3d(request.from[0], request.from[1], 0.0));
    constexpr double kEndless = 1e4;
    slab.shape = {{{{0.0, -kEndless, 0.0}, {length, -kEndless, 0.0}, {length, kEndless, 0.0}, {0.0, kEndless, 0.0}}}};
    slab.low = -request.depth;
    slab.high = request.depth;
    return slab;
}

void paint(const std::vector<SeenPoint>& points, double cell, geometry::MapSheet& sheet) {
    const double low = sheet.extent.low[1];
    const double high = sheet.extent.high[1];
    const double length = sheet.extent.high[0];
    geometry::SheetPicture picture;
    picture.pixel = cell;
    picture.top = high;
    picture.width = static_cast<std::int32_t>(std::ceil(length / cell));
    picture.height = static_cast<std::int32_t>(std::ceil((high - low) / cell));
    const auto cells = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    std::vector<std::array<float, 4>> sums(cells, {0.0F, 0.0F, 0.0F, 0.0F});
    const bool coloured = std::any_of(points.begin(), points.end(), [](const SeenPoint& p) { return p.has_colour; });
    for (const SeenPoint& p : points) {
        if (coloured && !p.has_colour) continue;
        const auto column = static_cast<std::int64_t>(static_cast<double>(p.along) / cell);
        const auto row = static_cast<std::int64_t>((high - static_cast<double>(p.height)) / cell);
        if (column < 0 || row < 0 || column >= picture.width || row >= picture.height) continue;
        auto& sum = sums[static_cast<std::size_t>(row * picture.width + column)];
        const float grey = static_cast<float>(p.intensity) / 257.0F;
        sum[0] += coloured ? static_cast<float>(p.colour.red) : grey;
        sum[1] += coloured ? static_cast<float>(p.colour.green) : grey;
        sum[2] += coloured ? static_cast<float>(p.colour.blue) : grey;
        sum[3] += 1.0F;
    }
    picture.rgba.assign(4 * cells, 0);
    for (std::size_t i = 0; i < cells; ++i) {
        if (sums[i][3] == 0.0F) continue;
        for (std::size_t k = 0; k < 3; ++k)
            picture.rgba[4 * i + k] = static_cast<std::uint8_t>(std::clamp(sums[i][k] / sums[i][3], 0.0F, 255.0F));
        picture.rgba[4 * i + 3] = 255;
    }
    close_holes(picture, 2);
    sheet.pictures.push_back(std::move(picture));
}

// How the surface at `place` of `count` is drawn, as broad as cells are at 1:20.
geometry::SheetLook tone_of(std::size_t place, std::size_t count) {
    geometry::SheetLook look;
    look.line = look.fill = colour_in_time(place, count);
    look.width = 1.0;
    return look;
}

void paint_apart(const std::vector<SeenPoint>& points, const std::vector<SeenSurface>& surfaces,
                 const SectionRequest& request, geometry::MapSheet& sheet, const model::Record& record) {
    std::vector<std::size_t> seen;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (surfaces[i].points > 0) seen.push_back(i);
    }
    for (std::size_t place = 0; place < seen.size(); ++place) {
        const geometry::SheetLook look = tone_of(place, seen.size());
        std::vector<SeenPoint> own;
        for (const SeenPoint& p : points) {
            if (p.surface != seen[place]) continue;
            own.push_back(p);
            own.back().has_colour = true;
            own.back().colour = {static_cast<std::uint8_t>(look.fill >> 16U),
                                 static_cast<std::uint8_t>(look.fill >> 8U), static_cast<std::uint8_t>(look.fill)};
        }
        paint(own, request.cell, sheet);
        // Clear pixels too: PDF readers smooth colour and clearness apart, and black would run into the tone.
        auto& rgba = sheet.pictures.back().rgba;
        for (std::size_t i = 0; i < rgba.size(); i += 4) {
            rgba[i] = own.front().colour.red;
            rgba[i + 1] = own.front().colour.green;
            rgba[i + 2] = own.front().colour.blue;
        }
        const model::Surface* surface = surfaces[seen[place]].surface;
        sheet.keys.push_back({surface == nullptr ? "scans of no surface" : surface_name(record, *surface), look,
                              geometry::SheetSign::None});
    }
}

void add_outlines(Project& project, const model::Section& plane, double length, SectionSheet& made) {
    const model::Record& record = project.record();
    for (const model::Region& region : record.regions) {
        if (region.section.is_nil()) continue;
        const geometry::MultiPolygon shape = onto_plane(scans::shape_of(region), plane);
        bool inside = !shape.empty();
        for (const geometry::Rings& rings : shape) {
            for (const geometry::Point3& p : rings.front())
                inside = inside && std::abs(p[2]) <= kInPlane && p[0] > -kInPlane && p[0] < length + kInPlane;
        }
        if (!inside) continue;
        const auto unit = project.index().find(region.unit);
        const bool known = unit != model::kNoUnit;
        add_outline(made.sheet, shape,
                    known ? unit_look(record.units[unit].kind, record.units[unit].form)
                          : unit_look(model::UnitKind::Unknown, model::UnitForm::None));
        ++made.outlines;
        const std::string label = region_label(record, project.index(), region);
        const auto [x, y] = geometry::inner_place(shape);
        made.sheet.labels.push_back({x, y, label, {}});
        if (known) made.units.push_back(label);
    }
}

} // namespace

SectionSheet section_sheet(Project& project, const SectionRequest& request, Progress& progress) {
    const model::Record& record = project.record();
    const double length = std::hypot(request.to[0] - request.from[0], request.to[1] - request.from[1]);
    if (!(length > 0.01)) throw Error(ErrorCode::Usage, "both ends of the section are one place");
    const model::Surface* surface = request.surface.empty() ? nullptr : &known_surface(record, request.surface);
    // Of all surfaces together each scan counts for its own.
    const std::vector<const model::Scan*> named =
        surface == nullptr ? std::vector<const model::Scan*>{} : scans_of(record, *surface);
    std::vector<SeenSurface> surfaces = surfaces_of(record, surface);
    std::vector<SeenPoint> points;
    const RegionGround slab = slab_of(request, length);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const model::SurfaceId own = surfaces[i].surface == nullptr ? model::SurfaceId{} : surfaces[i].surface->id;
        const auto is_wanted = [&](const model::Scan& scan) {
            return surface == nullptr ? scan.surface == own
                                      : std::find(named.begin(), named.end(), &scan) != named.end();
        };
        const std::vector<PlacedScan> scans = placed_scans(project, is_wanted, progress);
        for_points_on(slab, scans, [&](const RegionPoint& p) {
            const Eigen::Vector3d x = slab.frame_from_site * p.x_in_site;
            points.push_back(
                {static_cast<float>(x.x()), static_cast<float>(x.y()), p.colour, p.intensity, p.has_colour, i});
            ++surfaces[i].points;
        });
    }
    const auto several =
        std::count_if(surfaces.begin(), surfaces.end(), [](const SeenSurface& s) { return s.points > 0; }) > 1;
    SectionSheet made;
    made.points = points.size();
    model::Section plane;
    plane.from_in_site = request.from;
    plane.to_in_site = request.to;
    add_outlines(project, plane, length, made);
    geometry::Extent extent;
    for (const geometry::SheetShape& shape : made.sheet.shapes) extent.add(geometry::extent(shape.shape));
    if (!points.empty()) { // what stands high above the ground, a tree or a person, is cut off
        std::vector<float> heights;
        for (const SeenPoint& p : points) heights.push_back(p.height);
        std::sort(heights.begin(), heights.end());
        extent.add(0.0, static_cast<double>(heights[heights.size() / 100]));
        extent.add(length, static_cast<double>(heights[heights.size() - 1 - heights.size() / 50]));
    }
    if (extent.is_empty()) throw Error(ErrorCode::BadInput, "neither registered scans nor outlines lie in this plane");
    made.sheet.extent = {{0.0, std::floor((extent.low[1] - kSpare) * 10.0) / 10.0},
                         {length, std::ceil((extent.high[1] + kSpare) * 10.0) / 10.0}};
    if (several && request.surfaces_apart) {
        paint_apart(points, surfaces, request, made.sheet, record);
    } else if (!points.empty()) {
        paint(points, request.cell, made.sheet);
    }
    made.sheet.is_section = true;
    made.sheet.site = record.settings.name;
    made.sheet.title = surface == nullptr ? "Section" : "Section, " + surface_name(record, *surface);
    made.sheet.subtitle =
        fmt::format("from {:.2f} {:.2f} to {:.2f} {:.2f}, seen within {:.0f} cm of the plane", request.from[0],
                    request.from[1], request.to[0], request.to[1], 100.0 * request.depth);
    return made;
}

} // namespace planum::app
