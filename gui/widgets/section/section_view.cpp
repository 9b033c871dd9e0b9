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

} // namespace

SectionCanvas::SectionCanvas(Models& models_in) : FlatCanvas(models_in, kSection, Up::Upwards) {
    setAccessibleName(tr("Section"));
}

QString SectionCanvas::empty_text() const {
    return tr("No section yet. A section is a line between two surveyed points; add one by importing outlines that "
              "name it.");
}

void SectionCanvas::show_section(const std::optional<model::Section>& section) {
    extent_ = {};
    length_ = 0.0;
    std::vector<RegionShape> shapes;
    if (section && models().workspace.is_open()) {
        const app::Snapshot& snapshot = *models().workspace.snapshot();
        shapes = regions_in_section(snapshot, *section);
        length_ = std::hypot(section->to_in_site[0] - section->from_in_site[0],
                             section->to_in_site[1] - section->from_in_site[1]);
        extent_ = bounds_of(shapes);
        if (extent_.isNull()) extent_ = QRectF(0.0, -1.0, 1.0, 2.0);
        extent_ = extent_.united(QRectF(0.0, extent_.top(), length_, extent_.height()));
    }
    set_shapes(std::move(shapes));
}

void SectionCanvas::paint_ground(QPainter& painter, const QRectF& seen) {
    painter.setPen(QPen(theme().edge, 0));
    for (double z = std::ceil(seen.top() / kStep) * kStep; z <= seen.bottom(); z += kStep) {
        painter.drawLine(QPointF(seen.left(), z), QPointF(seen.right(), z));
    }
    for (const double end : {0.0, length_}) painter.drawLine(QPointF(end, seen.top()), QPointF(end, seen.bottom()));
}

void SectionCanvas::paint_over(QPainter& painter) {
    const double low = to_place(QPointF(0.0, height())).y();
    const double high = to_place(QPointF(0.0, 0.0)).y();
    painter.setPen(theme().faint);
    for (double z = std::ceil(low / kStep) * kStep; z <= high; z += kStep) {
        painter.drawText(QPointF(6.0, to_screen({0.0, z}).y() - 3.0),
                         QString::number(z, 'f', 2) + QStringLiteral(" m"));
    }
}

SectionView::SectionView(Models& models)
    : models_(models), choice_(new QComboBox), canvas_(new SectionCanvas(models)),
      bar_(new OutlineBar(models, kSection)) {
    lay_out(kSection, canvas_, bar_, {choice_});
    choice_->setAccessibleName(tr("Section"));
    choice_->setMinimumWidth(140);
    connect(choice_, &QComboBox::activated, this, &SectionView::show_chosen);
    connect(&models_.workspace, &Workspace::snapshotChanged, this, &SectionView::refresh);
    connect(&models_.workspace, &Workspace::closed, this, &SectionView::refresh);
    refresh();
}

QString SectionView::words_for(QPointF place) const {
    return tr("%1 m along, height %2 m").arg(place.x(), 0, 'f', 2).arg(place.y(), 0, 'f', 2);
}

void SectionView::refresh() {
    const QString before = choice_->currentText();
    choice_->clear();
    if (models_.workspace.is_open()) {
        for (const model::Section& section : models_.workspace.snapshot()->record().sections)
            choice_->addItem(qt(section.name));
    }
    const int again = choice_->findText(before);
    if (again >= 0) choice_->setCurrentIndex(again);
    choice_->setVisible(choice_->count() > 0);
    show_chosen();
}

void SectionView::show_chosen() {
    std::optional<model::Section> section;
    if (models_.workspace.is_open() && choice_->currentIndex() >= 0) {
        section = models_.workspace.snapshot()->record().sections[static_cast<std::size_t>(choice_->currentIndex())];
    }
    OutlineTool::ToOutlines ground;
    EditGround edit;
    if (section) {
        edit.to_view = [section = *section](const geometry::Point3& x_in_site) {
            const geometry::Point3 p = app::onto_plane({{{x_in_site}}}, section).front().front().front();
            return QPointF(p[0], p[1]);
        };
        edit.to_site = [section = *section](QPointF from, QPointF to) {
            return app::from_plane({{{{from.x(), from.y(), 0.0}, {to.x(), to.y(), 0.0}}}}, section).front().front();
        };
        ground = [name = section->name](app::Project&, const app::DrawnOutline& labels, const PointList& corners,
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
    }
    if (section != ground_of_) {
        ground_of_ = section;
        bar_->set_ground(std::move(ground), {}, std::move(edit));
    }
    canvas_->show_section(section);
}

} // namespace planum::gui
