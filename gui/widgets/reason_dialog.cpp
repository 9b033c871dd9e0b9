// SPDX-License-Identifier: MIT
#include "gui/widgets/reason_dialog.hpp"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace planum::gui {

ReasonAnswer ask_reason_in_dialog(QWidget* parent, const QString& what, const QString& number_label) {
    const bool wants_number = !number_label.isEmpty();
    QDialog dialog(parent);
    dialog.setWindowTitle(what);
    auto* column = new QVBoxLayout(&dialog);
    auto* because = new QLineEdit;
    auto* number = new QLineEdit;
    if (wants_number) {
        column->addWidget(new QLabel(number_label));
        column->addWidget(number);
    }
    column->addWidget(new QLabel(QCoreApplication::translate("reason", "Reason, for those who read it in ten years")));
    column->addWidget(because);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(what);
    buttons->button(QDialogButtonBox::Ok)->setEnabled(false);
    const auto enough = [=] {
        buttons->button(QDialogButtonBox::Ok)
            ->setEnabled(!because->text().trimmed().isEmpty() &&
                         (!wants_number || !number->text().trimmed().isEmpty()));
    };
    QObject::connect(because, &QLineEdit::textChanged, buttons, enough);
    QObject::connect(number, &QLineEdit::textChanged, buttons, enough);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    column->addWidget(buttons);
    dialog.resize(480, dialog.sizeHint().height());
    if (dialog.exec() != QDialog::Accepted) return {};
    return {because->text().trimmed(), number->text().trimmed()};
}

} // namespace planum::gui
