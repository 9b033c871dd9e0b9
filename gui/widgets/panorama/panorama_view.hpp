// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>

#include <vector>

#include "gui/viewmodels/panorama_model.hpp"
#include "gui/widgets/flat/flat_canvas.hpp"
#include "gui/widgets/flat/flat_page.hpp"

class QComboBox;

namespace planum::gui {

class OutlineBar;

/// The picture of a panorama, in halves of its size, so that any zoom reads about as many pixels as it shows.
class PanoramaCanvas : public FlatCanvas {
    Q_OBJECT

  public:
    PanoramaCanvas(Models& models, PanoramaModel& panorama);

    void refresh();
    void show_patches();

  protected:
    void paint_ground(QPainter& painter, const QRectF& seen) override;
    void paint_over(QPainter& painter) override;
    [[nodiscard]] QRectF extent() const override;
    [[nodiscard]] QString empty_text() const override;

  private:
    PanoramaModel& panorama_;
    std::shared_ptr<const LoadedPanorama> shown_;
    std::shared_ptr<const std::vector<QImage>> halves_; ///< full size first
};

class PanoramaView : public FlatPage {
    Q_OBJECT

  public:
    explicit PanoramaView(Models& models);

  protected:
    [[nodiscard]] QString words_for(QPointF place) const override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void refresh();

    Models& models_;
    PanoramaModel panorama_;
    PanoramaCanvas* canvas_;
    OutlineBar* bar_;
    QComboBox* scan_;
    QComboBox* projection_;
    QComboBox* channel_;
    const LoadedPanorama* ground_of_ = nullptr; ///< whose ground the outline bar has
};

} // namespace planum::gui
