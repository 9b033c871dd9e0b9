// SPDX-License-Identifier: MIT
#include "gui/viewmodels/change_labels.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <vector>

#include "gui/viewmodels/sentence_form.hpp"
#include "gui/viewmodels/sentences.hpp"
#include "gui/viewmodels/service_sentences.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

namespace {

// The names that the services of app/ give to their changes; tests/gui/gui_viewmodels/change_labels_test.cpp holds them
// to those that are there.
constexpr std::array kLabels = {
    QT_TRANSLATE_NOOP("changes", "Accept a relation from surfaces"),
    QT_TRANSLATE_NOOP("changes", "Accept problem %1"),
    QT_TRANSLATE_NOOP("changes", "Accept problem %1 of %2"),
    QT_TRANSLATE_NOOP("changes", "Accept registration run %1"),
    QT_TRANSLATE_NOOP("changes", "Accept relations from surfaces"),
    QT_TRANSLATE_NOOP("changes", "Add %1"),
    QT_TRANSLATE_NOOP("changes", "Add %1 scans"),
    QT_TRANSLATE_NOOP("changes", "Added %1 row of %2 with another program"),
    QT_TRANSLATE_NOOP("changes", "Added %1 rows of %2 with another program"),
    QT_TRANSLATE_NOOP("changes", "Assign %1 finds"),
    QT_TRANSLATE_NOOP("changes", "Change %1"),
    QT_TRANSLATE_NOOP("changes", "Changed %1 row of %2 with another program"),
    QT_TRANSLATE_NOOP("changes", "Changed %1 rows of %2 with another program"),
    QT_TRANSLATE_NOOP("changes", "Correct to %1, instead of %2: %3"),
    QT_TRANSLATE_NOOP("changes", "Delete %1"),
    QT_TRANSLATE_NOOP("changes", "Deleted %1 row of %2 with another program"),
    QT_TRANSLATE_NOOP("changes", "Deleted %1 rows of %2 with another program"),
    QT_TRANSLATE_NOOP("changes", "Discard registration run %1"),
    QT_TRANSLATE_NOOP("changes", "Draw an outline"),
    QT_TRANSLATE_NOOP("changes", "Draw an outline of %1"),
    QT_TRANSLATE_NOOP("changes", "Find %1 scans again"),
    QT_TRANSLATE_NOOP("changes", "Find a scan again"),
    QT_TRANSLATE_NOOP("changes", "Import %1"),
    QT_TRANSLATE_NOOP("changes", "Import %1 and %2 more"),
    QT_TRANSLATE_NOOP("changes", "Import %1 markers"),
    QT_TRANSLATE_NOOP("changes", "Import %1 outline"),
    QT_TRANSLATE_NOOP("changes", "Import %1 outlines"),
    QT_TRANSLATE_NOOP("changes", "Import measured points of %1"),
    QT_TRANSLATE_NOOP("changes", "Make interpretation %1"),
    QT_TRANSLATE_NOOP("changes", "Mark %1 uncertain: %2"),
    QT_TRANSLATE_NOOP("changes", "Outline changed ground"),
    QT_TRANSLATE_NOOP("changes", "Outline changed ground as %1"),
    QT_TRANSLATE_NOOP("changes", "Redraw region %1"),
    QT_TRANSLATE_NOOP("changes", "Register %1 scans"),
    QT_TRANSLATE_NOOP("changes", "Reject a suggestion"),
    QT_TRANSLATE_NOOP("changes", "Reject suggestions"),
    QT_TRANSLATE_NOOP("changes", "Restored %1 row of %2 with another program"),
    QT_TRANSLATE_NOOP("changes", "Restored %1 rows of %2 with another program"),
    QT_TRANSLATE_NOOP("changes", "Sign the day off"),
    QT_TRANSLATE_NOOP("changes", "Split unit %1, new %2: %3"),
    QT_TRANSLATE_NOOP("changes", "Take over %1 scans"),
    QT_TRANSLATE_NOOP("changes", "Withdraw %1: %2"),
};

// What is added, changed or deleted.
constexpr std::array kThings = {
    QT_TRANSLATE_NOOP("changes", "area %1"),     QT_TRANSLATE_NOOP("changes", "dating %1"),
    QT_TRANSLATE_NOOP("changes", "document %1"), QT_TRANSLATE_NOOP("changes", "find %1"),
    QT_TRANSLATE_NOOP("changes", "group %1"),    QT_TRANSLATE_NOOP("changes", "interpretation %1"),
    QT_TRANSLATE_NOOP("changes", "level %1"),    QT_TRANSLATE_NOOP("changes", "period %1"),
    QT_TRANSLATE_NOOP("changes", "phase %1"),    QT_TRANSLATE_NOOP("changes", "region %1"),
    QT_TRANSLATE_NOOP("changes", "relation %1"), QT_TRANSLATE_NOOP("changes", "sample %1"),
    QT_TRANSLATE_NOOP("changes", "scan %1"),     QT_TRANSLATE_NOOP("changes", "surface %1"),
    QT_TRANSLATE_NOOP("changes", "unit %1"),
};

template<class Texts>
std::vector<SentenceForm> forms_of(const Texts& texts) {
    std::vector<SentenceForm> forms;
    for (const char* english : texts) forms.emplace_back(english);
    std::stable_sort(forms.begin(), forms.end(),
                     [](const SentenceForm& a, const SentenceForm& b) { return a.letters() > b.letters(); });
    return forms;
}

QString translated(const QString& english) {
    return QCoreApplication::translate("changes", english.toUtf8().constData());
}

// `unit 1042`, or what relates to what, or somebody's own words.
QString thing(const QString& english) {
    static const std::vector<SentenceForm> forms = forms_of(kThings);
    for (const SentenceForm& form : forms) {
        auto parts = form.fit(english);
        if (!parts) continue;
        for (auto& [place, words] : *parts) words = in_window_language(words);
        return filled(translated(form.english()), *parts);
    }
    return in_window_language(english);
}

// A problem is called by the title of its check, not by its code; older projects kept the hash that tells problems
// apart, which says nothing to anybody.
QString accepted_problem(const std::vector<std::pair<int, QString>>& parts) {
    const std::string code = parts.front().second.toStdString();
    const QString title = check_title(code);
    if (title == parts.front().second) return QCoreApplication::translate("changes", "Accept a problem");
    if (parts.size() == 1) return QCoreApplication::translate("changes", "Accept problem “%1”").arg(title);
    return QCoreApplication::translate("changes", "Accept problem “%1” (%2)")
        .arg(title, in_window_language(parts.back().second));
}

} // namespace

QString change_label(const std::string& english) {
    static const std::vector<SentenceForm> forms = forms_of(kLabels);
    const QString text = QString::fromStdString(english);
    for (const SentenceForm& form : forms) {
        auto parts = form.fit(text);
        if (!parts) continue;
        if (form.english().startsWith(QLatin1String("Accept problem"))) return accepted_problem(*parts);
        // Another program's work is told by tables, which are called as what they hold.
        const bool outside = form.english().endsWith(QLatin1String("with another program"));
        for (auto& [place, words] : *parts) words = outside ? service_sentence(words) : thing(words);
        return filled(translated(form.english()), *parts);
    }
    return text;
}

QString thing_word(const std::string& english) { return thing(QString::fromStdString(english)); }

} // namespace planum::gui
