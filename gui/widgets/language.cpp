// SPDX-License-Identifier: MIT
#include "gui/widgets/language.hpp"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>

namespace planum::gui {

namespace {

const QString kKey = QStringLiteral("language");

QString& applied() {
    static QString code;
    return code;
}

} // namespace

QStringList languages() {
    return {QStringLiteral("en"), QStringLiteral("de"), QStringLiteral("it"), QStringLiteral("fr")};
}

QString language_name(const QString& code) {
    QString name = QLocale(code).nativeLanguageName();
    if (code == QLatin1String("en")) name = QStringLiteral("English");
    if (!name.isEmpty()) name[0] = name[0].toUpper();
    return name;
}

QString chosen_language() {
    const QString chosen = QSettings().value(kKey).toString();
    if (languages().contains(chosen)) return chosen;
    const QString of_system = QLocale::system().name().section(QLatin1Char('_'), 0, 0);
    return languages().contains(of_system) ? of_system : QStringLiteral("en");
}

void choose_language(const QString& code) { QSettings().setValue(kKey, code); }

QString window_language() { return applied().isEmpty() ? chosen_language() : applied(); }

void apply_language(const QString& code) {
    const QString wanted = code.isEmpty() ? chosen_language() : code;
    applied() = wanted;
    // Numbers follow the words; of its own language the system knows better which country's.
    if (QLocale::system().language() != QLocale(wanted).language()) QLocale::setDefault(QLocale(wanted));
    auto* own = new QTranslator(qApp);
    if (own->load(QStringLiteral(":/translations/planum_%1.qm").arg(wanted))) QCoreApplication::installTranslator(own);
    if (wanted == QLatin1String("en")) return; // only its plurals
    // File dialogs and the like, where Qt's own translations are installed.
    auto* qt_own = new QTranslator(qApp);
    if (qt_own->load(QStringLiteral("qtbase_") + wanted, QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
        QCoreApplication::installTranslator(qt_own);
    }
}

} // namespace planum::gui
