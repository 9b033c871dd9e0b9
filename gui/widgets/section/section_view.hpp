// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/model/place.hpp"
#include "gui/widgets/flat/flat_canvas.hpp"
#include "gui/widgets/flat/flat_page.hpp"

class QComboBox;

namespace planum::gui {

class OutlineBar;

/// A section: metres along it to the right, heights upwards, with the outlines drawn on it.
class SectionCanvas : public FlatCanvas {
    Q_OBJECT

  public:
    explicit SectionCanvas(Models& models);

    void show_section(const std::optional<model::Section>& section);

  protected:
    void paint_ground(QPainter& painter, const QRectF& seen) override;
    void paint_over(QPainter& painter) override;

    [[nodiscard]] QRectF extent() const override { return extent_; }

    [[nodiscard]] QString empty_text() const override;

  private:
    QRectF extent_;
    double length_ = 0.0; ///< [m]
};

class SectionView : public FlatPage {
    Q_OBJECT

  public:
    explicit SectionView(Models& models);

  protected:
    [[nodiscard]] QString words_for(QPointF place) const override;

  private:
    void refresh();
    void show_chosen();

    Models& models_;
    QComboBox* choice_;
    SectionCanvas* canvas_;
    OutlineBar* bar_;
    std::optional<model::Section> ground_of_; ///< what the bar draws on
};

} // namespace planum::gui
