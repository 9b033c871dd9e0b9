// SPDX-License-Identifier: MIT
#pragma once

#include <QLayout>

#include <memory>
#include <vector>

namespace planum::gui {

/// Puts widgets beside each other and begins a new line where the next one does not fit, as words in a paragraph;
/// nothing is clipped however narrow the panel is.
class FlowLayout : public QLayout {
    Q_OBJECT

  public:
    explicit FlowLayout(int spacing); ///< [px] between and below
    ~FlowLayout() override;

    void addItem(QLayoutItem* item) override;
    [[nodiscard]] int count() const override;
    [[nodiscard]] QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    [[nodiscard]] Qt::Orientations expandingDirections() const override;
    [[nodiscard]] bool hasHeightForWidth() const override;
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] QSize minimumSize() const override;
    [[nodiscard]] QSize sizeHint() const override;
    void setGeometry(const QRect& rect) override;

  private:
    enum class Place { Measure, Move };
    int flow(const QRect& whole, Place place) const; ///< returns the height
    [[nodiscard]] QSize margins() const;

    std::vector<std::unique_ptr<QLayoutItem>> items_;
};

} // namespace planum::gui
