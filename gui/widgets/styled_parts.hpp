// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>

#include <deque>
#include <vector>

class QWidget;

namespace planum::gui {

/// Gives the widgets of the program a style sheet part by part.
///
/// A sheet of the whole application is set on all widgets in one go, and for so long no window answers: a seventh of a
/// second where all views were seen. Here each part, a dock or a view or a dialog, has it for itself and can get
/// another one between two turns of the event loop. Parts are the outermost widgets that are not marked by in_parts(),
/// and stand in none that is not; what they hold, and open, takes its sheet from them.
class StyledParts : public QObject {
    Q_OBJECT

  public:
    enum class Pace {
        AtOnce, ///< all parts before this returns
        InTurns ///< what is seen first, the rest while the windows answer
    };

    explicit StyledParts(QObject* parent);

    /// The sheet of all parts, those included that are shown later.
    void set_sheet(const QString& sheet, Pace pace);

    /// This widget is no part, its children are, each for itself.
    static void in_parts(QWidget& widget);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void go_on();
    void dress(QWidget& part);

    QString sheet_;
    std::vector<QPointer<QWidget>> parts_;
    std::deque<QPointer<QWidget>> waiting_; ///< for the sheet
};

} // namespace planum::gui
