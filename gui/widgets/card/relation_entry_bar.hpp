// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

#include <array>

class QCompleter;
class QLabel;
class QLineEdit;
class QPushButton;
class QStringListModel;

namespace planum::gui {

struct Models;

/// Three fields: number, kind, number. Enter goes on to the next field and adds the relation at the end; what it will
/// mean, or why one should look again, stands below.
class RelationEntryBar : public QWidget {
    Q_OBJECT

  public:
    explicit RelationEntryBar(Models& models);

    /// Puts the unit's number in front and the cursor behind it.
    void begin_with(const QString& unit);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void show_judgement();
    void typed(int field, const QString& text);
    void go_on(int field);

    Models& models_;
    std::array<QLineEdit*, 3> fields_{};
    std::array<QStringListModel*, 3> words_{};
    QLabel* sentence_;
    QPushButton* show_;
};

} // namespace planum::gui
