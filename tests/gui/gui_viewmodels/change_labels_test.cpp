// SPDX-License-Identifier: MIT
#include "gui/viewmodels/change_labels.hpp"

#include <QCoreApplication>
#include <QTranslator>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

#include "app/records/record_kind.hpp"
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

// Names of changes as the services write them: the first text after `change(`, its places filled.
std::set<std::string> labels_in_services() {
    std::set<std::string> labels;
    const std::regex call(R"(\bchange\(\s*(?:fmt::format\(\s*)?"((?:[^"\\]|\\.)*)\")");
    for (const auto& entry : fs::recursive_directory_iterator(test::source_folder() / "app")) {
        const std::string end = entry.path().extension().string();
        if (end != ".cpp" && end != ".hpp") continue;
        std::ifstream in(entry.path());
        const std::string text((std::istreambuf_iterator<char>(in)), {});
        for (auto it = std::sregex_iterator(text.begin(), text.end(), call); it != std::sregex_iterator(); ++it)
            labels.insert(std::regex_replace((*it)[1].str(), std::regex(R"(\{[^}]*\})"), "unit 7"));
    }
    return labels;
}

} // namespace

TEST_CASE("In English a change is called as the project calls it") {
    test::ensure_core_application();
    for (const char* label : {"Add unit 1042", "Import 4 outlines", "Withdraw 1 covers 2: wrong sheet", "my own words"})
        CHECK(change_label(label) == QString::fromLatin1(label));
    CHECK(change_label("Accept problem cycle of 1, 2") ==
          QString::fromUtf8("Accept problem “Units above one another in a circle” (1, 2)"));
    CHECK(change_label("Accept problem df92a1c04b") == QStringLiteral("Accept a problem"));
}

TEST_CASE("In German changes are called in German, with the thing and what relates to what") {
    test::ensure_core_application();
    const German german;
    if (!german.there) {
        WARN("skipped: no translations were built");
        return;
    }
    const auto is = [](const char* label, const char* said) { CHECK(change_label(label).toStdString() == said); };
    is("Add unit 1042", "Befund 1042 anlegen");
    is("Add relation 1 covers 2", "Beziehung 1 überlagert 2 anlegen");
    is("Withdraw 1 covers 2: wrong sheet", "1 überlagert 2 zurücknehmen: wrong sheet");
    is("Add 4 scans", "4 Scans aufnehmen");
    is("Import units.csv and 3 more", "units.csv und 3 weitere einlesen");
    is("Draw an outline of 900", "Umriss von 900 zeichnen");
    is("Accept problem height-contradiction of 3, 5 and 2 more",
       "Problem „Flächen widersprechen der Beziehung“ (3, 5 und 2 weitere) hinnehmen");
    is("Accept problem df92a1c04b", "Ein Problem hinnehmen");
    is("Sign the day off", "Tag abzeichnen");
    is("Changed 3 rows of unit with another program", "Befund: 3 Einträge mit einem anderen Programm geändert");
    is("my own words", "my own words");
}

TEST_CASE("No name that a service gives to a change is left in English") {
    test::ensure_core_application();
    const German german;
    if (!german.there) {
        WARN("skipped: no translations were built");
        return;
    }
    const std::set<std::string> labels = labels_in_services();
    CHECK(labels.size() > 15);
    // Whose places are filled with words of the service.
    const std::map<std::string, std::string> worded = {
        {"Accept unit 7 from surfaces", "Accept relations from surfaces"},
        {"Reject unit 7", "Reject suggestions"},
        {"unit 7 registration run unit 7", "Discard registration run 7"},
        {"Correct to unit 7: unit 7", "Correct to 1 covers 2, instead of 2 covers 1: sheet read again"}};
    for (const std::string& found : labels) {
        const auto special = worded.find(found);
        const std::string label = special != worded.end() ? special->second
                                  : found.ends_with(' ')  ? found + "7"
                                                          : found;
        INFO(label);
        CHECK(change_label(label).toStdString() != label);
    }
    for (const auto& kind : app::record_kinds()) {
        const std::string thing = std::string(kind->word()) + " 1";
        INFO(thing);
        CHECK_FALSE(change_label("Add " + thing).contains(QString::fromStdString(thing)));
    }
}
