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
    /// This sentence, where it is what stands here, holds no longer.
    void take_back(const QString& sentence);
    [[nodiscard]] QString sentence() const;

  private:
    QString said_; ///< as it was handed in
    QLabel* text_;
};

} // namespace planum::gui
