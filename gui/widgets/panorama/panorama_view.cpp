// SPDX-License-Identifier: MIT
#include "gui/widgets/panorama/panorama_view.hpp"

#include <QComboBox>
#include <QPainter>

#include <algorithm>

#include "gui/viewmodels/models.hpp"
#include "gui/widgets/flat/outline_bar.hpp"
#include "gui/widgets/theme.hpp"

namespace planum::gui {

namespace {

const QString kPanorama = QStringLiteral("panorama");

QImage image_of(const scans::Picture& picture) {
    const QImage borrowed(picture.values.data(), picture.width, picture.height, picture.width * picture.channels,
                          picture.channels == 1 ? QImage::Format_Grayscale8 : QImage::Format_RGB888);
    return borrowed.copy();
}

// The picture in halves of its size; made in a thread.
std::shared_ptr<const std::vector<QImage>> halves_of(const scans::Picture& picture) {
    auto halves = std::make_shared<std::vector<QImage>>();
    halves->push_back(image_of(picture));
    while (halves->back().width() > 1500) {
        const QImage& last = halves->back();
        halves->push_back(last.scaled(last.width() / 2, std::max(last.height() / 2, 1), Qt::IgnoreAspectRatio,
                                      Qt::SmoothTransformation));
    }
    return halves;
}

} // namespace

PanoramaCanvas::PanoramaCanvas(Models& models_in, PanoramaModel& panorama)
    : FlatCanvas(models_in, kPanorama, Up::Downwards), panorama_(panorama) {
    setAccessibleName(tr("Panorama"));
    panorama_.set_preparation([](const scans::Picture& picture) { return halves_of(picture); });
}

QRectF PanoramaCanvas::extent() const {
    return shown_ ? QRectF(0.0, 0.0, shown_->picture.width, shown_->picture.height) : QRectF();
}

QString PanoramaCanvas::empty_text() const {
    if (panorama_.is_loading()) return tr("unrolling the scan …");
    if (!panorama_.trouble().isEmpty()) return panorama_.trouble();
    return tr("No scan of this surface yet. Add scans from the project menu, or drop files on the window.");
}

void PanoramaCanvas::refresh() {
    if (shown_ != panorama_.loaded()) {
        const bool same_size = shown_ && panorama_.loaded() &&
                               shown_->picture.width == panorama_.loaded()->picture.width &&
                               shown_->scan.id == panorama_.loaded()->scan.id;
        shown_ = panorama_.loaded();
        halves_ = shown_ ? std::static_pointer_cast<const std::vector<QImage>>(shown_->prepared) : nullptr;
        if (!same_size) fit();
    }
    set_shapes(panorama_.shapes());
    show_patches();
}

void PanoramaCanvas::show_patches() {
    const PatchModel& patches = models().patches;
    set_patches(panorama_.in_picture(patches.patches(), patches.shapes()));
}

void PanoramaCanvas::paint_ground(QPainter& painter, const QRectF& seen) {
    if (halves_ == nullptr || halves_->empty()) return;
    std::size_t level = 0;
    while (level + 1 < halves_->size() && scale() * static_cast<double>(2U << level) <= 1.0) ++level;
    const QImage& image = (*halves_)[level];
    const QRectF part = seen.intersected(extent());
    const double shrink = image.width() / extent().width();
    painter.setRenderHint(QPainter::SmoothPixmapTransform, scale() < 3.0);
    painter.drawImage(part, image, QRectF(part.topLeft() * shrink, part.size() * shrink));
}

void PanoramaCanvas::paint_over(QPainter&) {}

PanoramaView::PanoramaView(Models& models)
    : models_(models), panorama_(models.workspace, models.time), canvas_(new PanoramaCanvas(models, panorama_)),
      bar_(new OutlineBar(models, kPanorama, OutlineBar::Offers::Patches)), scan_(new QComboBox),
      projection_(new QComboBox), channel_(new QComboBox) {
    scan_->setAccessibleName(tr("Scan"));
    scan_->setObjectName(QStringLiteral("panoramaScan"));
    scan_->setMinimumWidth(180);
    projection_->setAccessibleName(tr("Projection"));
    projection_->addItem(tr("equirectangular"), QStringLiteral("equirectangular"));
    projection_->addItem(tr("cylindrical"), QStringLiteral("cylindrical"));
    projection_->addItem(tr("Mercator"), QStringLiteral("mercator"));
    projection_->addItem(tr("Miller"), QStringLiteral("miller"));
    projection_->addItem(tr("equal-area"), QStringLiteral("equal-area"));
    projection_->addItem(tr("rectilinear"), QStringLiteral("rectilinear"));
    projection_->addItem(tr("Pannini"), QStringLiteral("pannini"));
    projection_->addItem(tr("stereographic"), QStringLiteral("stereographic"));
    channel_->setAccessibleName(tr("Channel"));
    channel_->addItem(tr("as scanned"), QString());
    channel_->addItem(tr("reflectance"), QStringLiteral("reflectance"));
    channel_->addItem(tr("range"), QStringLiteral("range"));
    channel_->addItem(tr("colour"), QStringLiteral("colour"));
    channel_->addItem(tr("shaded"), QStringLiteral("normals"));
    connect(scan_, &QComboBox::textActivated, &panorama_, &PanoramaModel::set_scan);
    connect(projection_, &QComboBox::activated, this,
            [this] { panorama_.set_projection(projection_->currentData().toString()); });
    connect(channel_, &QComboBox::activated, this,
            [this] { panorama_.set_channel(channel_->currentData().toString()); });
    lay_out(kPanorama, canvas_, bar_, {scan_, projection_, channel_});
    connect(&panorama_, &PanoramaModel::changed, this, &PanoramaView::refresh);
    connect(&models_.patches, &PatchModel::changed, canvas_, &PanoramaCanvas::show_patches);
    refresh();
}

QString PanoramaView::words_for(QPointF place) const { return panorama_.place_text(place); }

void PanoramaView::refresh() {
    const QStringList names = panorama_.scans();
    QStringList shown;
    for (int i = 0; i < scan_->count(); ++i) shown << scan_->itemText(i);
    if (names != shown) {
        scan_->clear();
        scan_->addItems(names);
    }
    scan_->setCurrentText(panorama_.scan());
    scan_->setEnabled(!names.isEmpty());
    if (ground_of_ != panorama_.loaded().get()) {
        ground_of_ = panorama_.loaded().get();
        bar_->set_ground(panorama_.ground(), panorama_.why_no_ground(), panorama_.edit_ground());
    }
    canvas_->refresh();
}

void PanoramaView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    panorama_.set_watched(true);
}

void PanoramaView::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    panorama_.set_watched(false);
}

} // namespace planum::gui
