// SPDX-License-Identifier: MIT
#include "gui/viewmodels/service_sentences.hpp"

#include <QCoreApplication>
#include <QTranslator>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "app/records/record_kind.hpp"
#include "strat/checks/check.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"
#include "tests/support/real_data.hpp"

using namespace planum;
using namespace planum::gui;
namespace fs = std::filesystem;

namespace {

struct German {
    QTranslator translator;
    bool there = translator.load(QStringLiteral(":/translations/planum_de.qm"));

    German() {
        if (there) QCoreApplication::installTranslator(&translator);
    }

    ~German() { QCoreApplication::removeTranslator(&translator); }
};

// A hint as a person would see it: a command of the program, or one of its options.
bool names_a_command(const std::string& text) {
    static const std::regex hint(
        R"((^|[^/\w-])planum (new|verify|undo|import|unit|relation|area|surface|scan|markers|register|region|suggest|check|interpretation)\b|(^|[^\w-])--[a-z])");
    return std::regex_search(text, hint);
}

// Texts in quotation marks, those side by side as one, places filled.
std::set<std::string> texts_in(const fs::path& folder) {
    std::set<std::string> texts;
    const std::regex run(R"("(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*)");
    const std::regex one(R"re("((?:[^"\\\n]|\\.)*)")re");
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".cpp") continue;
        std::ifstream in(entry.path());
        const std::string source((std::istreambuf_iterator<char>(in)), {});
        for (auto it = std::sregex_iterator(source.begin(), source.end(), run); it != std::sregex_iterator(); ++it) {
            const std::string all = it->str();
            std::string text;
            for (auto part = std::sregex_iterator(all.begin(), all.end(), one); part != std::sregex_iterator(); ++part)
                text += (*part)[1].str();
            text = std::regex_replace(text, std::regex(R"(\\")"), "\"");
            texts.insert(std::regex_replace(text, std::regex(R"(\{[^}]*\})"), "7"));
        }
    }
    return texts;
}

std::string here(const std::string& text) { return service_sentence(text).toStdString(); }

} // namespace

TEST_CASE("In English the window says what services say, but what to press instead of a command") {
    test::ensure_core_application();
    for (const char* text :
         {"the disk is full: nothing was changed; free some space and try again",
          "site.gpkg: number already used in area A", "placed by 4 markers and 2 links", "something that nobody knows"})
        CHECK(here(text) == text);
    CHECK(here("site.gpkg: no such file; make a project with planum new") ==
          "site.gpkg: no such file; Project › New project makes one");
    CHECK(here("a.ptx: of which day? Put it into a folder named by its date (2025-06-01) or say --day 2025-06-01") ==
          "a.ptx: of which day? Put it into a folder named by its date (2025-06-01) and add that");
    CHECK(here("lists.txt: not recognised; looked for lst, json by content, name and the files beside it; name the "
               "format with --format") == "lists.txt: not recognised: none of the lists that Planum reads (lst, json)");
}

TEST_CASE("Advice on commands that the window does not know yet is left out, the rest stays") {
    test::ensure_core_application();
    CHECK(here("this went wrong; planum check lists them") == "this went wrong");
    CHECK(here("this went wrong (see --columns)") == "this went wrong");
    CHECK(here("/digs/planum demo/site.gpkg: odd") == "/digs/planum demo/site.gpkg: odd");
    CHECK(here("say --day") == "say --day"); // nothing would be left
}

TEST_CASE("No service sends people to the command line from within the window") {
    test::ensure_core_application();
    std::set<std::string> hints;
    for (const char* folder : {"core", "app", "scans", "strat", "gui/widgets"}) {
        for (const std::string& text : texts_in(test::source_folder() / folder)) {
            const bool is_file_stamp = text.ends_with("\\n");
            if (names_a_command(text) && text.find(' ') != std::string::npos && !is_file_stamp) hints.insert(text);
        }
    }
    CHECK(hints.size() > 30);
    for (const std::string& hint : hints) {
        INFO(hint);
        CHECK_FALSE(names_a_command(here(hint)));
    }
}

TEST_CASE("In German errors, verdicts and notes are said in German, with what stood around them") {
    test::ensure_core_application();
    const German german;
    if (!german.there) {
        WARN("skipped: no translations were built");
        return;
    }
    const auto is = [](const char* text, const char* said) { CHECK(here(text) == said); };
    is("site.gpkg: no such file; make a project with planum new",
       "site.gpkg: die Datei gibt es nicht; Projekt › Neues Projekt legt eine an");
    is("site.gpkg: writing: No space left on device", "site.gpkg: Schreiben: kein Platz mehr auf der Platte");
    is("found-on: yesterday is no day; write YYYY-MM-DD", "Gefunden am: yesterday ist kein Tag; JJJJ-MM-TT schreiben");
    is("poorly placed by 4 markers: its position is only known to 14 mm; marker M3 left out: 22.0 mm off its place",
       "unsicher eingepasst über 4 Passmarken: seine Lage ist nur auf 14 mm bekannt; Passmarke M3 weggelassen: 22.0 mm "
       "neben ihrem Platz");
    is("not placed: its markers: 2 of the scan's 4 markers can be paired with the survey, three are needed; M7: not in "
       "the survey",
       "nicht eingepasst: seine Passmarken: 2 der 4 Passmarken des Scans sind eingemessen, drei braucht es; M7: nicht "
       "eingemessen");
    is("the column colour is not known; left out", "die Spalte colour ist unbekannt; ausgelassen");
    is("reading units.csv", "units.csv lesen");
    is("no unit 1O5; near it: 105, 15", "Befund 1O5 gibt es nicht; ähnlich: 105, 15");
    is("what somebody wrote", "what somebody wrote");
}

TEST_CASE("The help of every field of the lists is said in German") {
    test::ensure_core_application();
    const German german;
    if (!german.there) {
        WARN("skipped: no translations were built");
        return;
    }
    for (const auto& kind : app::record_kinds()) {
        if (kind->word() == "unit" || kind->word() == "relation") continue; // they have views of their own
        for (const app::FieldInfo& field : kind->fields()) {
            const std::string words = field.words.empty() ? field.help : field.help.substr(0, field.help.find(" ("));
            if (words == "material") continue; // the same in German
            INFO(kind->word() << ": " << words);
            CHECK(here(words) != words);
        }
    }
}
