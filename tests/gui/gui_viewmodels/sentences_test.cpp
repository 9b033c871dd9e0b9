// SPDX-License-Identifier: MIT
#include "gui/viewmodels/sentences.hpp"

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

#include <set>

#include "app/checks/daily_check.hpp"
#include "app/demo/record_generator.hpp"
#include "app/demo/record_mistakes.hpp"
#include "gui/viewmodels/sentence_form.hpp"
#include "gui/viewmodels/words.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"

using namespace planum;
using namespace planum::gui;

namespace {

// All that checks say of records with every kind of mistake: messages, reasons of suspicion, what could not be judged.
std::set<std::string> all_sentences() {
    std::set<std::string> said;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        app::RecordOptions options;
        options.seed = seed;
        options.units = 200;
        app::GeneratedRecord generated = app::generate_record(options);
        using app::MistakeKind;
        for (const MistakeKind kind :
             {MistakeKind::Reversed, MistakeKind::Transposed, MistakeKind::Mistyped, MistakeKind::WrongSameAs,
              MistakeKind::NumberUsedTwice, MistakeKind::SwappedLevels}) {
            app::MistakeOptions mistake;
            mistake.seed = seed;
            mistake.least_cycle = 0;
            (void)app::seed_mistake(generated, kind, mistake);
        }
        const app::DailyCheck check = app::check_record(generated.record, Progress::none());
        for (const model::Diagnostic& problem : check.problems) {
            said.insert(problem.message);
            for (const model::Suspect& suspect : problem.suspects)
                said.insert(suspect.reasons.begin(), suspect.reasons.end());
        }
        for (const auto& [why, count] : check.coverage.untestable) said.insert(why);
    }
    return said;
}

struct German {
    QTranslator translator;
    bool there = translator.load(QStringLiteral(":/translations/planum_de.qm"));

    German() {
        if (there) QCoreApplication::installTranslator(&translator);
    }

    ~German() { QCoreApplication::removeTranslator(&translator); }
};

} // namespace

TEST_CASE("In English every sentence of the checks stays as it is") {
    test::ensure_core_application();
    for (const std::string& sentence : all_sentences()) CHECK(in_window_language(sentence).toStdString() == sentence);
}

TEST_CASE("In German no sentence of the checks is left in English") {
    test::ensure_core_application();
    const German german;
    if (!german.there) {
        WARN("skipped: no translations were built");
        return;
    }
    const std::set<std::string> all = all_sentences();
    CHECK(all.size() > 50);
    for (const std::string& sentence : all) {
        INFO(sentence);
        const QString said = in_window_language(sentence);
        INFO(said.toStdString());
        CHECK(said.toStdString() != sentence);
        for (const char* word : {" the ", " covers ", " is ", " and ", " of "}) {
            CHECK_FALSE(said.contains(QLatin1String(word)));
        }
    }
}

TEST_CASE("Sentences within a sentence are said in German too, what people wrote stays theirs") {
    test::ensure_core_application();
    const German german;
    if (!german.there) {
        WARN("skipped: no translations were built");
        return;
    }
    CHECK(
        in_window_language(std::string("1008 covers 1003, 1003 fills 1004 and 2 steps more: one contact stated as two "
                                       "kinds; the order is the same")) ==
        QString::fromUtf8("1008 überlagert 1003, 1003 verfüllt 1004 und 2 weitere Schritte: ein Kontakt in zwei Arten "
                          "genannt; die Folge ist dieselbe"));
    CHECK(in_window_language(
              std::string("units.csv:8: the title of 3 is clay and ash here and was sand before; the first "
                          "is kept")) ==
          QString::fromUtf8("units.csv:8: title von 3 ist hier clay and ash und war vorher sand; das erste bleibt"));
    CHECK(in_window_language(std::string("on 2 June 2025 1.5 m² of 1008 lay bare where 1005 had been on 1 June 2025, "
                                         "4 cm lower")) ==
          QString::fromUtf8("am 2. Juni 2025 lagen 1.5 m² von 1008 frei, wo am 1. Juni 2025 1005 gewesen war, 4 cm "
                            "tiefer"));
    CHECK(in_window_language(std::string("a note that somebody wrote")) ==
          QStringLiteral("a note that somebody wrote"));
}

TEST_CASE("Measures are written as in the language of the window, names that look like numbers are not") {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German));
    CHECK(with_window_numbers(QStringLiteral("1.5 liegt bei 49.23 m auf 2.25 m², 95.5 % von 1.5 und 3 cm")) ==
          QString::fromUtf8("1.5 liegt bei 49,23 m auf 2,25 m², 95,5 % von 1.5 und 3 cm"));
    CHECK(number_word(12345.678, 2) == QStringLiteral("12345,68"));
    QLocale::setDefault(before);
    CHECK(number_word(0.5, 1) == QStringLiteral("0.5"));
}
