// SPDX-License-Identifier: MIT
#include "gui/widgets/window/tools_menu.hpp"

#include <QAction>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "gui/viewmodels/service_sentences.hpp"
#include "gui/viewmodels/words.hpp"
#include "gui/widgets/choice_dialog.hpp"
#include "gui/widgets/window/main_window.hpp"

namespace planum::gui {

ToolsMenu::ToolsMenu(MainWindow& window) : QMenu(tr("Tools"), &window), window_(window) {
    setObjectName(QStringLiteral("toolsMenu"));
    Inquiry& inquiry = window_.models().inquiry;
    const auto add = [this](const char* name, const QString& text, auto&& what) {
        addAction(text, this, what)->setObjectName(QString::fromLatin1(name));
    };
    add("verify", tr("Verify the project"), [&inquiry] { inquiry.verify(); });
    add("cleanProject", tr("Verify and clean up …"), [this] { clean(); });
    add("compareReadings", tr("Compare readings …"), [this] { compare_readings(); });
    add("findPatches", tr("Ground not outlined yet"), [this] {
        const TimeModel& time = window_.models().time;
        const int at = time.current();
        window_.models().inquiry.find_patches(at < 0 ? QString() : time.stops()[static_cast<std::size_t>(at)].name);
    });
    add("regionPoints", tr("Points of a region …"), [this] { write_region_points(); });
    addSeparator();
    add("compareRuns", tr("Compare registrations …"), [this] { compare_runs(); });
    add("acceptRun", tr("Accept a registration …"), [this] { choose_run(tr("Accept a registration"), true); });
    add("discardRun", tr("Discard a registration …"), [this] { choose_run(tr("Discard a registration"), false); });
    connect(&inquiry, &Inquiry::answered, this, &ToolsMenu::show_answer);
    const auto enable = [this] {
        for (QAction* action : actions()) action->setEnabled(window_.models().workspace.is_open());
    };
    connect(&window_.models().workspace, &Workspace::opened, this, enable);
    connect(&window_.models().workspace, &Workspace::closed, this, enable);
    enable();
}

// What was kept only to be made again is removed; that is not undone, so it is said before.
void ToolsMenu::clean() {
    QMessageBox box(
        QMessageBox::Question, tr("Verify and clean up"),
        tr("Kept points, pictures and heights that nothing uses any more are removed. The record, the scans "
           "themselves and all that can be taken back stay as they are."),
        QMessageBox::Cancel, &window_);
    const QPushButton* go = box.addButton(tr("Clean up"), QMessageBox::AcceptRole);
    box.exec();
    if (box.clickedButton() == go) window_.models().inquiry.clean();
}

void ToolsMenu::write_region_points() {
    const QStringList names = window_.models().inquiry.regions();
    if (names.isEmpty()) return window_.models().workspace.say(tr("There is no outline yet."));
    const QStringList one =
        ask_choices(&window_, tr("Points of a region"), {{tr("Region"), names, names.front(), false}});
    if (one.isEmpty()) return;
    const QString file =
        QFileDialog::getSaveFileName(&window_, tr("Points of %1").arg(one[0]), {}, tr("Points (*.ply)"));
    if (!file.isEmpty()) window_.models().inquiry.write_region_points(one[0], file.toStdString());
}

void ToolsMenu::compare_readings() {
    const QStringList names = window_.models().inquiry.readings();
    if (names.size() < 2) {
        window_.models().workspace.say(tr("There is no reading beside the record to compare it with."));
        return;
    }
    const QStringList two = ask_choices(&window_, tr("Compare readings"),
                                        {{tr("Reading"), names, {}, false}, {tr("with"), names, names[1], false}});
    if (two.size() == 2) window_.models().inquiry.compare_readings(two[0], two[1]);
}

void ToolsMenu::compare_runs() {
    const QStringList names = window_.models().inquiry.runs();
    if (names.size() < 2) {
        window_.models().workspace.say(tr("There are no two registrations to compare."));
        return;
    }
    const QStringList two = ask_choices(
        &window_, tr("Compare registrations"),
        {{tr("Registration"), names, names[names.size() - 2], false}, {tr("with"), names, names.back(), false}});
    if (two.size() == 2) window_.models().inquiry.compare_runs(two[0], two[1]);
}

void ToolsMenu::choose_run(const QString& what, bool accept) {
    const QStringList names = window_.models().inquiry.runs();
    if (names.isEmpty()) {
        window_.models().workspace.say(tr("There is no registration yet."));
        return;
    }
    const QStringList one = ask_choices(&window_, what, {{tr("Registration"), names, names.back(), false}});
    if (one.isEmpty()) return;
    if (accept) return window_.models().inquiry.accept_run(one[0]);
    window_.models().inquiry.discard_run(one[0]);
}

void ToolsMenu::show_answer(const Answer& answer) {
    auto* dialog = new QDialog(&window_);
    dialog->setObjectName(QStringLiteral("answer"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(answer.title);
    auto* list = new QListWidget;
    list->setObjectName(QStringLiteral("answerLines"));
    list->setAccessibleName(answer.title);
    list->setWordWrap(true);
    list->setSpacing(3);
    list->addItems(answer.lines);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
    if (!answer.file.empty()) {
        QPushButton* save = buttons->addButton(tr("Save as outlines …"), QDialogButtonBox::ActionRole);
        connect(save, &QPushButton::clicked, dialog, [this, dialog, answer] {
            const QString file = QFileDialog::getSaveFileName(dialog, answer.title, {}, answer.file_kind);
            if (file.isEmpty()) return;
            try {
                write_file_atomically(file.toStdString(), answer.file);
                emit window_.models().day.done(tr("wrote %1").arg(file));
            } catch (const Error& e) {
                window_.models().workspace.say(service_sentence(std::string(e.what())));
            }
        });
    }
    auto* column = new QVBoxLayout(dialog);
    column->addWidget(list);
    column->addWidget(buttons);
    dialog->resize(760, 420);
    dialog->show();
}

} // namespace planum::gui
