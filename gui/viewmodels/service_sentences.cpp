// SPDX-License-Identifier: MIT
#include "gui/viewmodels/service_sentences.hpp"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "gui/viewmodels/record_words.hpp"
#include "gui/viewmodels/sentence_form.hpp"
#include "gui/viewmodels/sentences.hpp"
#include "gui/viewmodels/services/sentence_tables.hpp"

namespace planum::gui {

namespace {

constexpr int kDeepest = 6; // sentences within sentences

const QString kContext = QStringLiteral(": "); // an error says in front what was being done
const QString kList = QStringLiteral("; ");

struct ServiceForm {
    SentenceForm said;
    const char* here;
    bool verbatim = false; ///< what is put in are names in a file, which are no words of ours

    ServiceForm(const char* english, const char* window) : said(english), here(window) {
        static const QRegularExpression name(QStringLiteral("\\b(columns?|field|key|tag|property) %"));
        verbatim = name.match(said.english()).hasMatch();
    }
};

const std::vector<ServiceForm>& forms() {
    static const std::vector<ServiceForm> all = [] {
        std::vector<ServiceForm> made;
        for (const auto table : {services::file_sentences(), services::record_sentences(), services::scan_sentences(),
                                 services::import_sentences()}) {
            for (const char* sentence : table) made.emplace_back(sentence, sentence);
        }
        for (const services::Reworded& hint : services::command_hints()) made.emplace_back(hint.said, hint.here);
        std::stable_sort(made.begin(), made.end(), [](const ServiceForm& a, const ServiceForm& b) {
            return a.said.letters() > b.said.letters();
        });
        return made;
    }();
    return all;
}

std::optional<QString> said(const QString& text, int depth);

enum class Parts { OneSentenceEach, Any };

// Whether the parts are more than the form has places for: a list of sentences, or what an error says in front.
bool holds_more(const SentenceForm& form, const std::vector<std::pair<int, QString>>& parts) {
    const bool begins_with_place = form.english().startsWith(QLatin1Char('%'));
    if (begins_with_place && !parts.empty() && parts.front().second.contains(kContext)) return true;
    return std::any_of(parts.begin(), parts.end(), [](const auto& part) { return part.second.contains(kList); });
}

std::optional<QString> by_form(const QString& text, Parts allowed, int depth) {
    for (const ServiceForm& form : forms()) {
        auto parts = form.said.fit(text);
        if (!parts) continue;
        if (allowed == Parts::OneSentenceEach && holds_more(form.said, *parts)) continue;
        for (auto& [place, words] : *parts) {
            if (!form.verbatim) words = said(words, depth + 1).value_or(words);
        }
        return filled(QCoreApplication::translate("services", form.here), *parts);
    }
    return std::nullopt;
}

enum class Pieces { All, Some };

std::optional<QString> as_list(const QString& text, Pieces known, int depth) {
    const QStringList pieces = text.split(kList);
    if (pieces.size() < 2) return std::nullopt;
    QStringList all;
    int found = 0;
    for (const QString& piece : pieces) {
        const auto here = said(piece, depth + 1);
        found += here ? 1 : 0;
        all << here.value_or(piece);
    }
    if (found == 0 || (known == Pieces::All && found < pieces.size())) return std::nullopt;
    return all.join(kList);
}

// `site.gpkg: found-on: x is no day`: the longest end that is known, behind what stands in front of it.
std::optional<QString> behind_context(const QString& text, int depth) {
    for (qsizetype at = text.indexOf(kContext); at >= 0; at = text.indexOf(kContext, at + 1)) {
        const auto tail = said(text.mid(at + kContext.size()), depth + 1);
        if (!tail) continue;
        QStringList front;
        for (const QString& one : text.left(at).split(kContext))
            front << by_form(one, Parts::OneSentenceEach, depth + 1).value_or(record_field_label(one));
        return front.join(kContext) + kContext + *tail;
    }
    return std::nullopt;
}

std::optional<QString> said(const QString& text, int depth) {
    if (text.isEmpty() || depth > kDeepest) return std::nullopt;
    if (auto here = by_form(text, Parts::OneSentenceEach, depth)) return here;
    if (auto here = as_list(text, Pieces::All, depth)) return here;
    if (auto here = behind_context(text, depth)) return here;
    if (auto here = by_form(text, Parts::Any, depth)) return here;
    if (auto here = as_list(text, Pieces::Some, depth)) return here;
    const QString of_checks = in_window_language(text);
    return of_checks == text ? std::nullopt : std::optional(of_checks);
}

// A hint that the tables do not know yet is better left out than shown where it helps nobody.
QString without_hints(const QString& text) {
    static const QRegularExpression hint(QStringLiteral(
        "(?<![/\\w-])planum (new|info|verify|backup|undo|redo|history|today|import|unit|relation|find|level|sample|"
        "document|area|surface|phase|period|group|dating|survey|scan|markers|register|panorama|plan|section|region|"
        "suggest|check|interpretation|matrix|report|export|demo)\\b|(?<![\\w-])--[a-z][a-z-]*"));
    if (!hint.match(text).hasMatch()) return text;
    static const QRegularExpression aside(QStringLiteral(" \\([^()]*\\)"));
    QString kept = text;
    for (auto it = aside.globalMatch(text); it.hasNext();) {
        const QString words = it.next().captured();
        if (hint.match(words).hasMatch()) kept.remove(words);
    }
    for (const QString& joint : {kList, kContext}) {
        QStringList pieces;
        for (const QString& piece : kept.split(joint)) {
            if (!hint.match(piece).hasMatch()) pieces << piece;
        }
        if (!pieces.isEmpty()) kept = pieces.join(joint);
    }
    return kept;
}

} // namespace

QString service_sentence(const QString& english) {
    const auto here = said(english, 0);
    return here ? with_window_numbers(*here) : without_hints(english);
}

QString service_sentence(const std::string& english) { return service_sentence(QString::fromStdString(english)); }

} // namespace planum::gui
