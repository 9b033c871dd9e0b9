// SPDX-License-Identifier: MIT
#include "gui/viewmodels/sentence_form.hpp"

#include <QLocale>

#include <algorithm>

namespace planum::gui {

SentenceForm::SentenceForm(const char* english) : english_(QString::fromUtf8(english)) {
    static const QRegularExpression place(QStringLiteral("%(\\d)"));
    QString expression;
    qsizetype at = 0;
    for (auto it = place.globalMatch(english_); it.hasNext();) {
        const auto found = it.next();
        add_words(expression, english_.mid(at, found.capturedStart() - at));
        // A date stays whole: in `on 2 June 2025 1.5 m² of 3 …` the first place does not end behind the 2.
        expression += QStringLiteral("(\\d\\d? [A-Z][a-z]+ \\d{4}|.+?)");
        places_.push_back(found.captured(1).toInt());
        at = found.capturedEnd();
    }
    add_words(expression, english_.mid(at));
    expression_.setPattern(QRegularExpression::anchoredPattern(expression));
    expression_.setPatternOptions(QRegularExpression::DotMatchesEverythingOption);
}

std::optional<std::vector<std::pair<int, QString>>> SentenceForm::fit(const QString& text) const {
    if (!text.contains(longest_)) return std::nullopt; // most forms, at once
    const auto match = expression_.match(text);
    if (!match.hasMatch()) return std::nullopt;
    std::vector<std::pair<int, QString>> parts;
    for (std::size_t i = 0; i < places_.size(); ++i)
        parts.emplace_back(places_[i], match.captured(static_cast<int>(i) + 1));
    return parts;
}

void SentenceForm::add_words(QString& expression, const QString& words) {
    expression += QRegularExpression::escape(words);
    letters_ += words.size();
    if (words.size() > longest_.size()) longest_ = words;
}

QString filled(const QString& pattern, const std::vector<std::pair<int, QString>>& parts) {
    QString said;
    for (qsizetype i = 0; i < pattern.size(); ++i) {
        const bool place = pattern[i] == QLatin1Char('%') && i + 1 < pattern.size() && pattern[i + 1].isDigit();
        if (!place) {
            said += pattern[i];
            continue;
        }
        const int number = pattern[++i].digitValue();
        const auto part =
            std::find_if(parts.begin(), parts.end(), [&](const auto& one) { return one.first == number; });
        if (part != parts.end()) said += part->second;
    }
    return said;
}

QString with_window_numbers(const QString& sentence) {
    const QString point = QLocale().decimalPoint();
    if (point == QLatin1String(".")) return sentence;
    static const QRegularExpression measure(
        QStringLiteral("(?<![\\w.])(\\d+)\\.(\\d+)(?=\\s?(?:m²|m³|km|cm|mm|m|°|%|Grad|Standardabweichungen)(?!\\w))"));
    QString said = sentence;
    return said.replace(measure, QStringLiteral("\\1") + point + QStringLiteral("\\2"));
}

} // namespace planum::gui
