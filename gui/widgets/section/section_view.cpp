// SPDX-License-Identifier: MIT
#include "gui/widgets/section/section_view.hpp"

#include <QComboBox>
#include <QPainter>

#include <cmath>

#include "app/regions/region_layout.hpp"
#include "gui/viewmodels/models.hpp"
#include "gui/viewmodels/words.hpp"
#include "gui/widgets/flat/outline_bar.hpp"
#include "gui/widgets/theme.hpp"

namespace planum::gui {

namespace {

const QString kSection = QStringLiteral("section");
constexpr double kStep = 0.5; // [m] between lines of height

// Points are drawn on paper, not on what lies around them: none is as light as white paper or as dark as black.
QImage apart_from_paper(const QImage& picture) {
    QImage made = picture.convertToFormat(QImage::Format_ARGB32);
    const bool dark = theme().kind == ThemeKind::Dark;
    const auto moved = [dark](int value) { return dark ? 105 + value * 150 / 255 : value * 150 / 255; };
    for (int y = 0; y < made.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(made.scanLine(y));
        for (int x = 0; x < made.width(); ++x) {
            const QRgb c = line[x];
            line[x] = qRgba(moved(qRed(c)), moved(qGreen(c)), moved(qBlue(c)), qAlpha(c));
        }
    }
    return made;
}

} // namespace

SectionCanvas::SectionCanvas(Models& models_in) : FlatCanvas(models_in, kSection, Up::Upwards) {
    setAccessibleName(tr("Section"));
}

QString SectionCanvas::empty_text() const {
    if (looking_) return tr("looking along the section …");
    return tr(
        "No section yet. Draw outlines or put scans on the site grid, and a cut through them shows here; a section "
        "of the record is a line between two surveyed points, which outlines name when they are imported.");
}

void SectionCanvas::show_section(const SectionModel& sections) {
    const auto section = sections.section();
    extent_ = {};
    length_ = 0.0;
    looking_ = sections.is_looking();
    if (sheet_ != sections.sheet() || painted_for_ != theme().kind) {
        sheet_ = sections.sheet();
        painted_for_ = theme().kind;
        picture_ = {};
        if (sheet_ && !sheet_->pictures.empty()) {
            const geometry::SheetPicture& p = sheet_->pictures.front();
            picture_ = apart_from_paper(QImage(p.rgba.data(), p.width, p.height, 4 * p.width, QImage::Format_RGBA8888));
        }
    }
    std::vector<RegionShape> shapes;
    if (section && models().workspace.is_open()) {
        const app::Snapshot& snapshot = *models().workspace.snapshot();
        if (!section->id.is_nil()) shapes = regions_in_section(snapshot, *section);
        length_ = std::hypot(section->to_in_site[0] - section->from_in_site[0],
                             section->to_in_site[1] - section->from_in_site[1]);
        extent_ = bounds_of(shapes);
        if (sheet_) {
            const geometry::Extent& seen = sheet_->extent;
            extent_ = extent_.united(
                QRectF(QPointF(seen.low[0], seen.low[1]), QPointF(seen.high[0], seen.high[1])).normalized());
        }
        if (extent_.isNull() && !section->id.is_nil()) extent_ = QRectF(0.0, -1.0, 1.0, 2.0);
        if (!extent_.isNull()) extent_ = extent_.united(QRectF(0.0, extent_.top(), length_, extent_.height()));
    }
    set_shapes(std::move(shapes));
}

void SectionCanvas::paint_ground(QPainter& painter, const QRectF& seen) {
    painter.setPen(QPen(theme().edge, 0));
    for (double z = std::ceil(seen.top() / kStep) * kStep; z <= seen.bottom(); z += kStep) {
        painter.drawLine(QPointF(seen.left(), z), QPointF(seen.right(), z));
    }
    for (const double end : {0.0, length_}) painter.drawLine(QPointF(end, seen.top()), QPointF(end, seen.bottom()));
    if (!picture_.isNull()) {
        const geometry::SheetPicture& p = sheet_->pictures.front();
        painter.save(); // its first row is the highest
        painter.translate(p.left, p.top);
        painter.scale(p.pixel, -p.pixel);
        painter.drawImage(QPointF(0.0, 0.0), picture_);
        painter.restore();
    }
}

void SectionCanvas::paint_over(QPainter& painter) {
    const double low = to_place(QPointF(0.0, height())).y();
    const double high = to_place(QPointF(0.0, 0.0)).y();
    painter.setPen(theme().faint);
    for (double z = std::ceil(low / kStep) * kStep; z <= high; z += kStep) {
        const double foot = to_screen({0.0, z}).y() - 3.0;
        if (foot < painter.fontMetrics().ascent()) continue; // cut off by the border
        painter.drawText(QPointF(6.0, foot), number_word(z, 2) + QStringLiteral(" m"));
    }
}

SectionView::SectionView(Models& models)
    : sections_(models.sections), choice_(new QComboBox), canvas_(new SectionCanvas(models)),
      bar_(new OutlineBar(models, kSection)) {
    lay_out(kSection, canvas_, bar_, {choice_});
    choice_->setObjectName(QStringLiteral("sectionChoice"));
    choice_->setAccessibleName(tr("Section"));
    choice_->setMinimumWidth(170);
    connect(choice_, &QComboBox::activated, &sections_, &SectionModel::choose);
    connect(&sections_, &SectionModel::changed, this, &SectionView::refresh);
    connect(&models.section_line, &SectionLine::handedOver, &sections_,
            [this](const model::Section& section, double thickness) { sections_.show_cut(section, thickness / 2.0); });
    // Outlines on it may be others although the section is the same.
    connect(&models.workspace, &Workspace::snapshotChanged, this, [this] { canvas_->show_section(sections_); });
    refresh();
}

QString SectionView::words_for(QPointF place) const {
    return tr("%1 m along, height %2 m").arg(number_word(place.x(), 2)).arg(number_word(place.y(), 2));
}

void SectionView::refresh() {
    choice_->clear();
    for (const SectionModel::Choice& choice : sections_.choices()) choice_->addItem(choice.name);
    choice_->setCurrentIndex(sections_.chosen());
    choice_->setVisible(choice_->count() > 0);
    set_ground();
    canvas_->show_section(sections_);
}

void SectionView::set_ground() {
    const auto section = sections_.section();
    if (section == ground_of_) return;
    ground_of_ = section;
    if (!section) return bar_->set_ground({});
    if (section->id.is_nil())
        return bar_->set_ground({}, tr("A cut to look at; outlines are drawn on recorded sections."));
    EditGround edit;
    edit.to_view = [section = *section](const geometry::Point3& x_in_site) {
        const geometry::Point3 p = app::onto_plane({{{x_in_site}}}, section).front().front().front();
        return QPointF(p[0], p[1]);
    };
    edit.to_site = [section = *section](QPointF from, QPointF to) {
        return app::from_plane({{{{from.x(), from.y(), 0.0}, {to.x(), to.y(), 0.0}}}}, section).front().front();
    };
    const auto draw = [name = section->name](app::Project&, const app::DrawnOutline& labels, const PointList& corners,
                                             Progress&) {
        app::DrawnOutline outline = labels;
        outline.section = app::SectionWish{name, {}};
        outline.on_plane = true;
        outline.drawn_on = "section";
        geometry::Line3 ring;
        for (const QPointF& p : corners) ring.push_back({p.x(), p.y(), 0.0});
        outline.shape = {{ring}};
        return app::OutlineFile{{outline}, {}};
    };
    bar_->set_ground(draw, {}, std::move(edit));
}

void SectionView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    sections_.set_watched(true);
}

void SectionView::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    sections_.set_watched(false);
}

} // namespace planum::gui
