// SPDX-License-Identifier: MIT
#include "gui/widgets/plan/plan_view.hpp"

#include <QPainter>

#include <cmath>

#include "app/scans/scan_stores.hpp"
#include "gui/viewmodels/models.hpp"
#include "gui/viewmodels/plan_ground.hpp"
#include "gui/viewmodels/words.hpp"
#include "gui/widgets/flat/outline_bar.hpp"
#include "gui/widgets/theme.hpp"

namespace planum::gui {

namespace {

const QString kPlan = QStringLiteral("plan");

// 1, 2 or 5 times a power of ten, about `wanted`.
double round_step(double wanted) {
    const double power = std::pow(10.0, std::floor(std::log10(wanted)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= wanted) return factor * power;
    }
    return 10.0 * power;
}

QString metres(double value) { return QString::number(value, 'f', value == std::floor(value) ? 0 : 1); }

} // namespace

PlanCanvas::PlanCanvas(Models& models_in) : FlatCanvas(models_in, kPlan, Up::Upwards) { setAccessibleName(tr("Plan")); }

QString PlanCanvas::empty_text() const {
    return tr("No outlines, finds or stations yet. Add scans, draw outlines on a panorama, or import outlines and "
              "measured points.");
}

void PlanCanvas::refresh() {
    marks_.clear();
    sections_ = models().sections.lines_in_plan();
    extent_ = {};
    std::vector<RegionShape> shapes;
    if (models().workspace.is_open()) {
        const app::Snapshot& snapshot = *models().workspace.snapshot();
        const model::Record& record = snapshot.record();
        const model::SurfaceId surface = models().time.surface();
        if (!surface.is_nil()) shapes = regions_in_plan(snapshot, surface);
        for (const model::Scan& scan : record.scans) {
            const model::ScanPose* pose = model::pose_in_force(record, scan.id);
            if (pose == nullptr || scan.surface != surface) continue;
            const QString stem = qt(scan.name).section(QLatin1Char('/'), -1);
            marks_.push_back({Mark::Kind::Station, {pose->site_from_scan[3], pose->site_from_scan[7]}, stem, {}});
        }
        for (const model::Find& find : record.finds) {
            if (find.x && find.y) marks_.push_back({Mark::Kind::Find, {*find.x, *find.y}, qt(find.number), find.unit});
        }
        for (const model::Level& level : record.levels) {
            if (level.x && level.y && level.unit == models().workspace.selected()) {
                marks_.push_back({Mark::Kind::Level, {*level.x, *level.y}, number_word(level.z, 2), level.unit});
            }
        }
        // The whole site, so that the plan does not jump when the time line moves.
        for (const model::Region& region : record.regions) {
            for (const model::Polygon& polygon : region.outline) {
                PointList ring;
                for (const auto& p : polygon.outer) ring << QPointF(p[0], p[1]);
                if (!region.surface.is_nil()) extent_ = extent_.united(bounds_of(ring));
            }
        }
        for (const Mark& mark : marks_)
            extent_ = extent_.united(QRectF(mark.place - QPointF(0.5, 0.5), QSizeF(1.0, 1.0)));
    }
    set_shapes(std::move(shapes));
}

void PlanCanvas::show_sections(std::vector<SectionModel::Line> sections) {
    if (sections == sections_) return;
    sections_ = std::move(sections);
    update();
}

void PlanCanvas::paint_ground(QPainter& painter, const QRectF& seen) {
    const double step = round_step(90.0 / scale());
    painter.setPen(QPen(theme().edge, 0));
    for (double x = std::ceil(seen.left() / step) * step; x <= seen.right(); x += step) {
        painter.drawLine(QPointF(x, seen.top()), QPointF(x, seen.bottom()));
    }
    for (double y = std::ceil(seen.top() / step) * step; y <= seen.bottom(); y += step) {
        painter.drawLine(QPointF(seen.left(), y), QPointF(seen.right(), y));
    }
}

QList<QRectF> PlanCanvas::kept_free() const {
    constexpr qsizetype kMany = 400; // then the plan is full whatever the numbers do
    QList<QRectF> taken;
    if (static_cast<qsizetype>(marks_.size()) > kMany) return taken;
    const QFontMetricsF metrics(font());
    for (const Mark& mark : marks_) {
        const QPointF at = to_screen(mark.place);
        taken << QRectF(at.x() - 7.0, at.y() - 8.0, 18.0 + metrics.horizontalAdvance(mark.label), 16.0);
    }
    return taken;
}

// Where names would lie over each other the first one stands; the others come when one looks nearer.
void PlanCanvas::paint_marks(QPainter& painter) {
    const QFontMetricsF metrics(painter.font());
    QList<QRectF> written;
    const auto write = [&](QPointF at, const QString& name, bool always) {
        const QRectF box = metrics.boundingRect(name).translated(at);
        const bool over =
            std::any_of(written.begin(), written.end(), [&](const QRectF& b) { return b.intersects(box); });
        if (over && !always) return;
        written << box;
        painter.drawText(at, name);
    };
    for (const Mark& mark : marks_) {
        const QPointF at = to_screen(mark.place);
        if (!rect().adjusted(-100, -20, 20, 20).contains(at.toPoint())) continue;
        const bool selected = !mark.unit.is_nil() && mark.unit == models().workspace.selected();
        const QColor ink = selected ? theme().accent : theme().ink;
        painter.setPen(QPen(ink, selected ? 2.0 : 1.3));
        painter.setBrush(theme().paper);
        switch (mark.kind) {
        case Mark::Kind::Find:
            painter.drawPolygon(
                QPolygonF({at + QPointF(0, -5), at + QPointF(5, 0), at + QPointF(0, 5), at + QPointF(-5, 0)}));
            break;
        case Mark::Kind::Level: painter.drawPolygon(QPolygonF({at, at + QPointF(-5, -8), at + QPointF(5, -8)})); break;
        case Mark::Kind::Station:
            painter.drawEllipse(at, 7.0, 7.0);
            painter.drawLine(at - QPointF(7, 0), at + QPointF(7, 0));
            painter.drawLine(at - QPointF(0, 7), at + QPointF(0, 7));
            break;
        }
        if (mark.kind != Mark::Kind::Find || selected || marks_.size() < 40) {
            write(at + QPointF(9, 4), mark.label, selected);
        }
    }
}

void PlanCanvas::paint_scale_bar(QPainter& painter) {
    const double metres_long = round_step(110.0 / scale());
    const double pixels = metres_long * scale();
    const QPointF foot(24.0, height() - 24.0);
    painter.setPen(QPen(theme().ink, 1.2));
    painter.setBrush(theme().ink);
    painter.drawRect(QRectF(foot.x(), foot.y() - 5.0, pixels / 2.0, 5.0));
    painter.setBrush(theme().paper);
    painter.drawRect(QRectF(foot.x() + pixels / 2.0, foot.y() - 5.0, pixels / 2.0, 5.0));
    painter.drawText(foot + QPointF(pixels + 8.0, 1.0), metres(metres_long) + QStringLiteral(" m"));
    // North is up: the site grid is not turned on the screen.
    const QPointF north(width() - 34.0, 26.0);
    painter.setBrush(theme().ink);
    painter.drawPolygon(
        QPolygonF({north + QPointF(0, -14), north + QPointF(6, 10), north + QPointF(0, 5), north + QPointF(-6, 10)}));
    painter.drawText(QRectF(north.x() - 12.0, north.y() + 11.0, 24.0, 16.0), Qt::AlignCenter, QStringLiteral("N"));
}

void PlanCanvas::paint_over(QPainter& painter) {
    const double step = round_step(90.0 / scale());
    const QPointF low = to_place(QPointF(0.0, height()));
    const QPointF high = to_place(QPointF(width(), 0.0));
    painter.setPen(theme().faint);
    for (double x = std::ceil(low.x() / step) * step; x <= high.x(); x += step) {
        painter.drawText(QPointF(to_screen({x, 0.0}).x() + 3.0, height() - 6.0), metres(x));
    }
    for (double y = std::ceil(low.y() / step) * step; y <= high.y(); y += step) {
        painter.drawText(QPointF(4.0, to_screen({0.0, y}).y() - 3.0), metres(y));
    }
    for (const SectionModel::Line& section : sections_) {
        painter.setPen(QPen(theme().accent, section.chosen ? 2.2 : 1.4, Qt::DashDotLine));
        painter.drawLine(to_screen(section.from), to_screen(section.to));
        painter.drawText(to_screen(section.from) + QPointF(4, -4), section.name);
    }
    paint_marks(painter);
    paint_scale_bar(painter);
}

PlanView::PlanView(Models& models)
    : models_(models), canvas_(new PlanCanvas(models)),
      bar_(new OutlineBar(models, kPlan, OutlineBar::Offers::Patches)) {
    lay_out(kPlan, canvas_, bar_);
    connect(&models_.time, &TimeModel::moved, this, &PlanView::refresh);
    connect(&models_.time, &TimeModel::changed, this, &PlanView::refresh);
    connect(&models_.workspace, &Workspace::selectionChanged, canvas_, &PlanCanvas::refresh);
    connect(&models_.sections, &SectionModel::changed, canvas_,
            [this] { canvas_->show_sections(models_.sections.lines_in_plan()); });
    connect(&models_.patches, &PatchModel::changed, canvas_,
            [this] { canvas_->set_patches(models_.patches.shapes()); });
    refresh();
}

QString PlanView::words_for(QPointF place) const {
    return QStringLiteral("x %1  y %2").arg(number_word(place.x(), 2)).arg(number_word(place.y(), 2));
}

void PlanView::refresh() {
    const model::SurfaceId surface = models_.time.surface();
    // Made again after every change of the record, which must not take the tool out of somebody's hand.
    if (surface != ground_of_ || surface.is_nil()) {
        ground_of_ = surface;
        if (surface.is_nil()) {
            bar_->set_ground({}, tr("There is no surface to draw on yet."));
        } else {
            bar_->set_ground(plan_ground(surface), {}, plan_edit_ground(surface));
        }
    }
    canvas_->refresh();
}

} // namespace planum::gui
