// SPDX-License-Identifier: MIT
#pragma once

#include <QFrame>

class QLabel;

namespace planum::gui {

/// One plain sentence about something that could not be done, above the views until it is closed. Never in the way.
class NoticeBar : public QFrame {
    Q_OBJECT

  public:
    NoticeBar();

    void say(const QString& sentence);
    [[nodiscard]] QString sentence() const;

  private:
    QLabel* text_;
};

} // namespace planum::gui
