// SPDX-License-Identifier: MIT
#include "gui/widgets/styled_parts.hpp"

#include <QApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QFont>
#include <QTimer>
#include <QWidget>

#include <algorithm>
#include <functional>

namespace planum::gui {

namespace {

constexpr int kTurn = 25; // [ms] of work between two looks at what else is asked for
constexpr const char* kInParts = "inParts";

bool is_marked(const QWidget& widget) { return widget.property(kInParts).toBool(); }

bool is_part(const QWidget& widget) {
    const QWidget* parent = widget.parentWidget();
    return !is_marked(widget) && (parent == nullptr || is_marked(*parent));
}

bool lies_in(const QWidget& widget, const QWidget& part) {
    const QWidget* at = widget.parentWidget();
    while (at != nullptr && at != &part) at = at->parentWidget();
    return at == &part;
}

// Sheets of parts mark the widgets around them, which they ask about, as if these had one, too, and those get no new
// font from their parents any more.
void take_font_of_parent(QWidget& widget) {
    if (!is_marked(widget)) return;
    widget.setAttribute(Qt::WA_StyleSheet, false);
    widget.setFont(QFont());
    for (QWidget* child : widget.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
        take_font_of_parent(*child);
}

} // namespace

StyledParts::StyledParts(QObject* parent) : QObject(parent) { qApp->installEventFilter(this); }

void StyledParts::in_parts(QWidget& widget) { widget.setProperty(kInParts, true); }

void StyledParts::set_sheet(const QString& sheet, Pace pace) {
    sheet_ = sheet;
    for (QWidget* window : QApplication::topLevelWidgets()) take_font_of_parent(*window);
    const auto gone = [](const QPointer<QWidget>& part) { return part.isNull(); };
    parts_.erase(std::remove_if(parts_.begin(), parts_.end(), gone), parts_.end());
    std::vector<QPointer<QWidget>> ordered = parts_;
    std::stable_partition(ordered.begin(), ordered.end(), [](const auto& part) { return part->isVisible(); });
    const bool idle = waiting_.empty();
    waiting_.assign(ordered.begin(), ordered.end());
    if (pace == Pace::InTurns) {
        if (idle) go_on();
        return;
    }
    while (!waiting_.empty()) {
        if (waiting_.front() != nullptr) dress(*waiting_.front());
        waiting_.pop_front();
    }
}

void StyledParts::go_on() {
    QElapsedTimer timer;
    timer.start();
    while (!waiting_.empty() && timer.elapsed() < kTurn) {
        if (waiting_.front() != nullptr) dress(*waiting_.front());
        waiting_.pop_front();
    }
    if (!waiting_.empty()) QTimer::singleShot(0, this, &StyledParts::go_on);
}

void StyledParts::dress(QWidget& part) {
    if (part.styleSheet() != sheet_) part.setStyleSheet(sheet_);
}

// A widget gets Polish once, before it is shown or when somebody asks how large it would be. Then it may not yet be
// where it is going to be: what holds it is the part later.
bool StyledParts::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::Polish || !watched->isWidgetType() || sheet_.isEmpty()) return false;
    auto& part = static_cast<QWidget&>(*watched);
    if (!is_part(part) || !part.styleSheet().isEmpty()) return false;
    const auto inside = [&](const QPointer<QWidget>& other) { return other != nullptr && lies_in(*other, part); };
    const auto first = std::stable_partition(parts_.begin(), parts_.end(), std::not_fn(inside));
    std::for_each(first, parts_.end(), [](const QPointer<QWidget>& other) { other->setStyleSheet({}); });
    parts_.erase(first, parts_.end());
    parts_.emplace_back(&part);
    dress(part);
    return false;
}

} // namespace planum::gui
