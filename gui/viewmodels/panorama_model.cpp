// SPDX-License-Identifier: MIT
#include "gui/viewmodels/panorama_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/regions/pixel_outlines.hpp"
#include "app/regions/region_layout.hpp"
#include "app/scans/list_scans.hpp"
#include "app/scans/scan_stores.hpp"
#include "core/base/error.hpp"
#include "gui/viewmodels/time_model.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

namespace {

std::optional<geometry::Rigid3> pose_of(const model::Record& record, model::ScanId scan) {
    const model::ScanPose* pose = model::pose_in_force(record, scan);
    if (pose == nullptr) return std::nullopt;
    geometry::Rigid3 site_from_scan;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
            site_from_scan.rotation(r, c) = pose->site_from_scan[static_cast<std::size_t>(4 * r + c)];
        }
        site_from_scan.translation(r) = pose->site_from_scan[static_cast<std::size_t>(4 * r + 3)];
    }
    return site_from_scan;
}

} // namespace

PanoramaModel::PanoramaModel(Workspace& workspace, TimeModel& time, QObject* parent)
    : QObject(parent), workspace_(workspace), time_(time) {
    connect(&time_, &TimeModel::moved, this, &PanoramaModel::take_surface);
    connect(&workspace_, &Workspace::snapshotChanged, this, &PanoramaModel::take_surface);
    connect(&workspace_, &Workspace::closed, this, [this] {
        loaded_.reset();
        scan_.clear();
        trouble_.clear();
        stale_ = true;
        emit changed();
    });
}

void PanoramaModel::set_watched(bool watched) {
    watched_ = watched;
    if (watched_ && stale_) load();
}

QStringList PanoramaModel::scans() const {
    QStringList names;
    if (!workspace_.is_open()) return names;
    for (const model::Scan& scan : workspace_.snapshot()->record().scans) {
        if (scan.surface == time_.surface()) names << qt(scan.name);
    }
    return names;
}

void PanoramaModel::take_surface() {
    const QStringList there = scans();
    if (!trouble_.isEmpty() && watched_) load(); // the record was read again: perhaps the scan can be, too
    if (!there.contains(qt(scan_))) {
        scan_ = there.isEmpty() ? std::string{} : there.front().toStdString();
        loaded_.reset();
        stale_ = true;
        if (watched_) load();
    }
    emit changed();
}

void PanoramaModel::set_scan(const QString& name) {
    if (name.toStdString() == scan_) return;
    scan_ = name.toStdString();
    load();
}

void PanoramaModel::set_projection(const QString& projection) {
    request_.projection = projection.toStdString();
    load();
}

void PanoramaModel::set_channel(const QString& channel) {
    request_.channel = channel.toStdString();
    load();
}

void PanoramaModel::load() {
    stale_ = true;
    trouble_.clear();
    if (!watched_ || scan_.empty() || !workspace_.is_open()) return;
    stale_ = false;
    loading_ = true;
    emit changed();
    workspace_.read(
        QStringLiteral("panorama"), tr("Unrolling %1").arg(qt(scan_)),
        [this, name = scan_, request = request_, prepare = preparation_](app::Project& project,
                                                                         Progress& progress) -> JobRunner::Done {
            const model::Scan scan = app::scan_named(project, name);
            const auto store = app::open_store(project.path(), scan, progress);
            const scans::ScanExtent extent = app::scan_extent(*store, progress);
            scans::Panorama panorama = app::scan_panorama(*store, extent, request, progress);
            scans::Picture picture = panorama.picture(app::panorama_channel(*store, request.channel));
            progress.check();
            auto prepared = prepare ? prepare(picture) : nullptr;
            auto loaded = std::make_shared<const LoadedPanorama>(
                LoadedPanorama{scan, std::move(panorama), std::move(picture), pose_of(project.record(), scan.id),
                               std::move(prepared)});
            return [this, loaded] {
                loaded_ = loaded;
                loading_ = false;
                emit changed();
            };
        },
        [this](const QString& sentence) {
            loaded_.reset();
            loading_ = false;
            trouble_ = sentence;
            emit changed();
        });
}

namespace {

// The pixel of a place; for one below or above the picture, the border nearest to it in its direction, so that an
// outline which leaves the picture at the scanner's feet runs along the border. Unset: the picture does not go there.
std::optional<Eigen::Vector2d> pixel_or_border(const scans::Projection& projection, const Eigen::Vector3d& x_in_scan) {
    constexpr int kHalvings = 10; // to a thousandth of the way
    const auto at = [&](double share) {
        return projection.pixel_of(Eigen::Vector3d(x_in_scan.x(), x_in_scan.y(), share * x_in_scan.z()));
    };
    if (const auto pixel = at(1.0)) return Eigen::Vector2d(pixel->x(), pixel->y());
    if (!at(0.0)) return std::nullopt;
    double inside = 0.0;
    double outside = 1.0;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (inside + outside);
        (at(middle) ? inside : outside) = middle;
    }
    const auto pixel = at(inside);
    return Eigen::Vector2d(pixel->x(), pixel->y());
}

} // namespace

std::vector<PointList> ring_in_picture(const scans::Projection& projection, const geometry::Rigid3& scan_from_site,
                                       const model::Ring& ring) {
    constexpr double kPiece = 0.05; // [m]: between corners lines are straight on the ground, not in the picture
    constexpr int kMostPieces = 200;
    std::vector<PointList> pieces(1);
    QPointF last;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Eigen::Vector3d a = scan_from_site * Eigen::Vector3d(ring[i].data());
        const Eigen::Vector3d b = scan_from_site * Eigen::Vector3d(ring[(i + 1) % ring.size()].data());
        const int steps = std::clamp(static_cast<int>((b - a).norm() / kPiece), 1, kMostPieces);
        for (int s = 0; s < steps; ++s) {
            const auto pixel = pixel_or_border(projection, a + (b - a) * (static_cast<double>(s) / steps));
            const QPointF at = pixel ? QPointF(pixel->x(), pixel->y()) : QPointF();
            const bool jumps =
                pixel && !pieces.back().isEmpty() && std::abs(at.x() - last.x()) > projection.options().width / 2.0;
            if ((!pixel || jumps) && !pieces.back().isEmpty()) pieces.emplace_back();
            if (!pixel) continue;
            pieces.back() << at;
            last = at;
        }
    }
    std::erase_if(pieces, [](const PointList& piece) { return piece.size() < 3; });
    return pieces;
}

std::vector<RegionShape> PanoramaModel::shapes() const {
    if (!loaded_ || !loaded_->site_from_scan || !workspace_.is_open()) return {};
    const app::Snapshot& snapshot = *workspace_.snapshot();
    const geometry::Rigid3 scan_from_site = loaded_->site_from_scan->inverse();
    std::vector<RegionShape> shapes = regions_in_plan(snapshot, loaded_->scan.surface);
    for (RegionShape& shape : shapes) {
        shape.rings.clear();
        for (const model::Region& region : snapshot.record().regions) {
            if (region.id != shape.region) continue;
            if (!region.has_heights) continue; // nobody knows where it is seen
            for (const model::Polygon& polygon : region.outline) {
                for (PointList& ring : ring_in_picture(loaded_->panorama.projection(), scan_from_site, polygon.outer)) {
                    shape.rings.push_back(std::move(ring));
                }
            }
        }
        if (!shape.rings.empty()) shape.middle = bounds_of(shape.rings.front()).center();
    }
    std::erase_if(shapes, [](const RegionShape& shape) { return shape.rings.empty(); });
    return shapes;
}

std::vector<RegionShape> PanoramaModel::in_picture(const std::vector<app::ReadyPatch>& patches,
                                                   std::vector<RegionShape> shapes) const {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        shapes[i].rings.clear();
        if (!loaded_ || !loaded_->site_from_scan || patches[i].on_surface != loaded_->scan.surface) continue;
        const geometry::Rigid3 scan_from_site = loaded_->site_from_scan->inverse();
        for (const geometry::Rings& polygon : patches[i].shape) {
            for (const geometry::Line3& ring : polygon) {
                for (PointList& piece : ring_in_picture(loaded_->panorama.projection(), scan_from_site, ring))
                    shapes[i].rings.push_back(std::move(piece));
            }
        }
        if (!shapes[i].rings.empty()) shapes[i].middle = bounds_of(shapes[i].rings.front()).center();
    }
    return shapes;
}

QString PanoramaModel::place_text(QPointF pixel) const {
    if (!loaded_ || pixel.x() < 0 || pixel.y() < 0) return {};
    const auto place = loaded_->panorama.surface_at({pixel.x(), pixel.y()});
    if (!place) return tr("nothing was measured here");
    if (!loaded_->site_from_scan) return tr("%1 m from the scanner").arg(number_word(place->norm(), 2));
    const Eigen::Vector3d site = *loaded_->site_from_scan * *place;
    return tr("x %1  y %2  height %3 m")
        .arg(number_word(site.x(), 2))
        .arg(number_word(site.y(), 2))
        .arg(number_word(site.z(), 2));
}

QString PanoramaModel::why_no_ground() const {
    if (!loaded_) return {};
    return loaded_->site_from_scan
               ? QString()
               : tr("This scan is not on the site grid yet: register it, then outlines can be drawn.");
}

EditGround PanoramaModel::edit_ground() const {
    if (!loaded_ || !loaded_->site_from_scan) return {};
    EditGround ground;
    ground.straight = 3.0;
    ground.period = loaded_->panorama.width();
    ground.to_view = [loaded = loaded_](const geometry::Point3& x_in_site) -> std::optional<QPointF> {
        if (std::isnan(x_in_site[2])) return std::nullopt; // without height nobody knows where it is seen
        const Eigen::Vector3d x_in_scan = loaded->site_from_scan->inverse() * Eigen::Vector3d(x_in_site.data());
        const auto pixel = loaded->panorama.projection().pixel_of(x_in_scan);
        return pixel ? std::optional(QPointF(pixel->x(), pixel->y())) : std::nullopt;
    };
    ground.to_site = [loaded = loaded_](QPointF from, QPointF to) {
        const geometry::Point3 a = {from.x(), from.y(), 0.0};
        const geometry::Point3 b = {to.x(), to.y(), 0.0};
        const auto follow = [&](const geometry::Point3& start, const geometry::Point3& end) {
            return app::line_under_pixels(loaded->panorama, *loaded->site_from_scan, start, end);
        };
        // Over the border of the picture, where a line would run around the horizon the other way.
        if (std::abs(a[0] - b[0]) > loaded->panorama.width() / 2.0)
            return geometry::Line3{follow(a, a).front(), follow(b, b).front()};
        return follow(a, b);
    };
    return ground;
}

OutlineTool::ToOutlines PanoramaModel::ground() const {
    if (!loaded_ || !loaded_->site_from_scan) return {};
    return [loaded = loaded_](app::Project&, const app::DrawnOutline& labels, const PointList& corners, Progress&) {
        app::DrawnOutline outline = labels;
        outline.on_surface = loaded->scan.surface;
        outline.drawn_on = "panorama";
        geometry::Line3 ring;
        for (const QPointF& p : corners) ring.push_back({p.x(), p.y(), 0.0});
        outline.shape = app::outline_under_pixels(loaded->panorama, *loaded->site_from_scan, {{ring}});
        return app::OutlineFile{{outline}, {}};
    };
}

} // namespace planum::gui
