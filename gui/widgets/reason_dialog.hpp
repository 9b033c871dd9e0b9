// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <functional>

class QWidget;

namespace planum::gui {

/// What a person answered; an empty reason: thought better of it.
struct ReasonAnswer {
    QString because;
    QString number;
};

/// Asks for a reason, and for a number or name where `number_label` says one is wanted. `what` is done when the person
/// agrees: title and button. Replaced by tests.
using AskReason = std::function<ReasonAnswer(QWidget* parent, const QString& what, const QString& number_label)>;

[[nodiscard]] ReasonAnswer ask_reason_in_dialog(QWidget* parent, const QString& what, const QString& number_label);

} // namespace planum::gui
