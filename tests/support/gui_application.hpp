// SPDX-License-Identifier: MIT
#pragma once

#include <QApplication>
#include <QSettings>

#include "gui/widgets/theme.hpp"
#include "tests/support/temporary.hpp"

namespace planum::test {

/// The application that widgets need, in the light theme, with settings of its own that end with the program.
inline void ensure_application() {
    static int argc = 1;
    static char name[] = "test";
    static char* argv[] = {name, nullptr};
    if (QCoreApplication::instance() == nullptr) {
        static const TemporaryFolder settings;
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                           QString::fromStdString(settings.path().string()));
        QCoreApplication::setOrganizationName(QStringLiteral("Planum"));
        QCoreApplication::setApplicationName(QStringLiteral("test"));
        new QApplication(argc, argv);
    }
    gui::apply_theme(gui::ThemeKind::Light);
}

} // namespace planum::test
