// SPDX-License-Identifier: MIT
#pragma once

#include <QRegularExpression>
#include <QString>

#include <optional>
#include <utility>
#include <vector>

namespace planum::gui {

/// `%1 covers %2`: whether a sentence is made after it, and what stands at its places.
class SentenceForm {
  public:
    explicit SentenceForm(const char* english);

    /// Fixed letters: of two forms that fit, the one with more is meant.
    [[nodiscard]] qsizetype letters() const noexcept { return letters_; }

    [[nodiscard]] const QString& english() const noexcept { return english_; }

    /// Each place with what stands there; nullopt: another sentence.
    [[nodiscard]] std::optional<std::vector<std::pair<int, QString>>> fit(const QString& text) const;

  private:
    void add_words(QString& expression, const QString& words);

    QString english_;
    QString longest_;
    QRegularExpression expression_;
    std::vector<int> places_;
    qsizetype letters_ = 0;
};

/// The form in another language, with other words at its places; what `parts` has nothing for is left out.
[[nodiscard]] QString filled(const QString& pattern, const std::vector<std::pair<int, QString>>& parts);

/// A sentence of ours with its measures (`0.15 m`, `95.5 %`) written as in the language of the window. Numbers without
/// a unit may be names and stay.
[[nodiscard]] QString with_window_numbers(const QString& sentence);

} // namespace planum::gui
