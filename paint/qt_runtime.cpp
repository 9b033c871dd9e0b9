// SPDX-License-Identifier: MIT
#include "paint/qt_runtime.hpp"

#include <QGuiApplication>
#include <QHashFunctions>

#include <array>
#include <mutex>

namespace planum::paint {

void ensure_qt_runtime() {
    static std::once_flag once;
    std::call_once(once, [] {
        // Qt numbers the glyphs of an embedded font as its hash goes through them; the same drawing shall be the same
        // file.
        QHashSeed::setDeterministicGlobalSeed();
        if (QCoreApplication::instance() != nullptr) return;
        // Whatever display there is, we need none, and must not fail for a wrong one.
        qputenv("QT_QPA_PLATFORM", "offscreen");
        static int argc = 1;
        static std::array<char, 7> name = {'p', 'l', 'a', 'n', 'u', 'm', '\0'};
        static std::array<char*, 2> argv = {name.data(), nullptr};
        // A library does not print: Qt would complain of a missing runtime directory that we do not need.
        const QtMessageHandler before =
            qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
        // Never deleted: Qt's own statics may be gone before ours would be.
        static QGuiApplication* const application = new QGuiApplication(argc, argv.data());
        static_cast<void>(application);
        qInstallMessageHandler(before);
    });
}

} // namespace planum::paint
