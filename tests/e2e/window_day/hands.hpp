// SPDX-License-Identifier: MIT
#pragma once

#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QMouseEvent>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <QUrl>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "gui/widgets/language.hpp"
#include "gui/widgets/theme.hpp"
#include "gui/widgets/window/main_window.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"
#include "tests/support/real_data.hpp"

namespace planum::test {

/// Somebody before the window: clicks, types, answers dialogs, drops files; and takes pictures of what is seen, which
/// stay in the build's folder `journey/`.
class Hands {
  public:
    explicit Hands(const std::string& pictures) : folder_(binary_folder() / "journey" / pictures) {
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
        QObject::connect(&window.models().workspace, &gui::Workspace::failed,
                         [this](const QString& sentence) { failures << sentence; });
        QObject::connect(&window.models().day, &gui::DayJobs::done, [this](const QString& text) { said << text; });
        window.resize(1600, 1000);
        window.show();
        REQUIRE(QTest::qWaitForWindowExposed(&window));
    }

    template<class Object>
    Object* find(const char* name) {
        auto* object = window.findChild<Object*>(QString::fromLatin1(name));
        INFO(name);
        REQUIRE(object != nullptr);
        return object;
    }

    void settle_all() {
        for (int round = 0; round < 4; ++round) settle(window.models().workspace);
    }

    void click(const char* name) {
        QTest::mouseClick(find<QWidget>(name), Qt::LeftButton);
        settle_all();
    }

    void click_at(QWidget* widget, QPointF where) {
        QTest::mouseMove(widget, where.toPoint());
        QTest::mouseClick(widget, Qt::LeftButton, {}, where.toPoint());
    }

    /// With the left button held down.
    static void drag(QWidget* widget, QPointF from, QPointF to) {
        const auto send = [&](QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons held) {
            QMouseEvent event(type, at, widget->mapToGlobal(at), button, held, {});
            QApplication::sendEvent(widget, &event);
        };
        send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        send(QEvent::MouseMove, (from + to) / 2.0, Qt::NoButton, Qt::LeftButton);
        send(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton);
        send(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
    }

    /// The pointer comes to rest there; sent straight to the widget, so that no other window can catch it.
    static void hover(QWidget* widget, QPointF where) {
        QMouseEvent move(QEvent::MouseMove, where, widget->mapToGlobal(where), Qt::NoButton, Qt::NoButton, {});
        QApplication::sendEvent(widget, &move);
    }

    /// The next dialog that waits for an answer gets its first text fields filled, in their order, and is accepted.
    void answer_next(const QStringList& texts) {
        auto* timer = new QTimer(&window);
        auto answered = std::make_shared<bool>(false);
        QObject::connect(timer, &QTimer::timeout, &window, [this, timer, texts, answered] {
            QWidget* modal = QApplication::activeModalWidget();
            if (auto* box = qobject_cast<QMessageBox*>(modal)) { // the answer was not liked
                failures << box->text();
                box->reject();
                if (auto* below = qobject_cast<QDialog*>(QApplication::activeModalWidget())) below->reject();
            }
            if (modal == nullptr && *answered) timer->deleteLater();
            auto* dialog = qobject_cast<QDialog*>(modal);
            if (dialog == nullptr || *answered) return;
            *answered = true;
            const QList<QLineEdit*> fields = dialog->findChildren<QLineEdit*>();
            for (qsizetype i = 0; i < texts.size() && i < fields.size(); ++i) fields[i]->setText(texts[i]);
            dialog->accept();
        });
        timer->start(20);
    }

    void drop(const std::vector<std::filesystem::path>& files) {
        QMimeData data;
        QList<QUrl> urls;
        for (const auto& file : files) urls << QUrl::fromLocalFile(QString::fromStdString(file.string()));
        data.setUrls(urls);
        QDragEnterEvent enter(QPoint(500, 400), Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&window, &enter);
        REQUIRE(enter.isAccepted());
        QDropEvent event(QPointF(500, 400), Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&window, &event);
        settle_all();
    }

    /// What is seen now, as FILE.png.
    void picture(const char* name, QWidget* of = nullptr) {
        settle_all();
        // What a view still makes in steps.
        const bool ready = QTest::qWaitFor(
            [this] {
                const auto widgets = window.findChildren<QWidget*>();
                return std::none_of(widgets.begin(), widgets.end(), [](const QWidget* one) {
                    return one->isVisible() && one->property("busy").toBool();
                });
            },
            60'000);
        CHECK(ready);
        QTest::qWait(50);
        const std::filesystem::path file = folder_ / (std::string(name) + ".png");
        CHECK((of == nullptr ? &window : of)->grab().save(QString::fromStdString(file.string())));
    }

    [[nodiscard]] const model::Record& record() { return window.models().workspace.snapshot()->record(); }

  private:
    struct First {
        First() {
            static int argc = 1;
            static char name[] = "journey";
            static char* argv[] = {name, nullptr};
            if (QCoreApplication::instance() == nullptr) {
                // The desktop's own dialogs cannot be answered, and what was opened lately is nobody's business here.
                QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
                qputenv("XDG_CONFIG_HOME", (binary_folder() / "journey" / "config").string().c_str());
                new QApplication(argc, argv);
            }
            gui::apply_theme(gui::ThemeKind::Light);
            gui::apply_language(QStringLiteral("en"));
        }
    } first_;

    std::filesystem::path folder_;

  public:
    gui::MainWindow window{app::Session{"Ada"}};
    QStringList failures; ///< sentences of the notice bar
    QStringList said;     ///< what jobs said they did
};

} // namespace planum::test
