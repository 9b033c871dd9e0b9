// SPDX-License-Identifier: MIT
#pragma once

#include <QFormLayout>
#include <QWidget>

#include <string>

#include "core/model/ids.hpp"
#include <vector>

class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;

namespace planum::gui {

struct CardField;
struct Models;
class PhotoStrip;
class RelationEntryBar;

/// The record card: few fields first, the full record behind a button; relations with their entry; levels, finds,
/// papers and photos; what was changed. Everything is saved when a field is left.
class CardPanel : public QWidget {
    Q_OBJECT

  public:
    explicit CardPanel(Models& models);

    void show_full(bool full);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    [[nodiscard]] QFormLayout::RowWrapPolicy row_wrapping() const;
    void show_card();
    void show_fields();
    void show_relations();
    void show_lines();
    void show_history();
    QWidget* editor_of(const CardField& field);

    Models& models_;
    QLabel* title_;
    QLabel* subtitle_;
    QLineEdit* new_number_;
    QPushButton* add_;
    QPushButton* more_;
    QPushButton* delete_;
    RelationEntryBar* entry_;
    QWidget* fields_;
    QWidget* relations_;
    QWidget* lines_;
    PhotoStrip* photos_;
    QLabel* history_;
    QWidget* body_;
    QScrollArea* scroll_;
    QLabel* nothing_;
    bool full_ = false;
    std::string shown_; ///< what the fields show, so that they are not rebuilt under somebody's hands
    model::UnitId shown_unit_;
};

} // namespace planum::gui
