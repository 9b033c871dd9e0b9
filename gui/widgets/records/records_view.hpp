// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

#include "gui/viewmodels/records_model.hpp"

class QComboBox;
class QLineEdit;
class QListWidget;
class QPushButton;
class QScrollArea;

namespace planum::gui {

struct Models;

/// Finds, levels, samples, phases and all other lists: names at the left, fields of the chosen one at the right.
class RecordsView : public QWidget {
    Q_OBJECT

  public:
    explicit RecordsView(Models& models);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void show_names();
    void show_fields();
    [[nodiscard]] QWidget* editor_of(const RecordsModel::FieldLine& field);

    Models& models_;
    RecordsModel records_;
    QComboBox* kind_;
    QLineEdit* search_;
    QLineEdit* fresh_;
    QListWidget* names_;
    QPushButton* add_;
    QPushButton* delete_;
    QScrollArea* scroll_;
};

} // namespace planum::gui
