// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>

#include <memory>
#include <optional>

#include "core/geometry/map_sheet.hpp"
#include "core/model/place.hpp"
#include "gui/viewmodels/section_model.hpp"
#include "gui/widgets/flat/flat_canvas.hpp"
#include "gui/widgets/flat/flat_page.hpp"
#include "gui/widgets/theme.hpp"

class QComboBox;

namespace planum::gui {

class OutlineBar;

/// A section: metres along it to the right, heights upwards: what the scans show in its plane, and the outlines drawn
/// on it.
class SectionCanvas : public FlatCanvas {
    Q_OBJECT

  public:
    explicit SectionCanvas(Models& models);

    void show_section(const SectionModel& sections);

  protected:
    void paint_ground(QPainter& painter, const QRectF& seen) override;
    void paint_over(QPainter& painter) override;

    [[nodiscard]] QRectF extent() const override { return extent_; }

    [[nodiscard]] QString empty_text() const override;

  private:
    QRectF extent_;
    double length_ = 0.0; ///< [m]
    std::shared_ptr<const geometry::MapSheet> sheet_;
    QImage picture_; ///< of the sheet
    ThemeKind painted_for_ = ThemeKind::Light;
    bool looking_ = false;
};

class SectionView : public FlatPage {
    Q_OBJECT

  public:
    explicit SectionView(Models& models);

  protected:
    [[nodiscard]] QString words_for(QPointF place) const override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void refresh();
    void set_ground();

    SectionModel& sections_;
    QComboBox* choice_;
    SectionCanvas* canvas_;
    OutlineBar* bar_;
    std::optional<model::Section> ground_of_; ///< what the bar draws on
};

} // namespace planum::gui
