// SPDX-License-Identifier: MIT
#include "gui/widgets/choice_dialog.hpp"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>

namespace planum::gui {

QStringList ask_choices(QWidget* parent, const QString& what, const std::vector<Choice>& choices) {
    QDialog dialog(parent);
    dialog.setWindowTitle(what);
    auto* form = new QFormLayout(&dialog);
    form->setVerticalSpacing(10);
    std::vector<QComboBox*> boxes;
    for (const Choice& choice : choices) {
        auto* box = new QComboBox;
        box->addItems(choice.items);
        box->setEditable(choice.editable);
        box->setAccessibleName(choice.label);
        box->setMinimumWidth(220);
        const auto at = choice.items.indexOf(choice.first);
        if (at >= 0) box->setCurrentIndex(static_cast<int>(at));
        form->addRow(choice.label, box);
        boxes.push_back(box);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(what);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    form->addRow(buttons);
    if (dialog.exec() != QDialog::Accepted) return {};
    QStringList chosen;
    for (const QComboBox* box : boxes) chosen << box->currentText();
    return chosen;
}

} // namespace planum::gui
