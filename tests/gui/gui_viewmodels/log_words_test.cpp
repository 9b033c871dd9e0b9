// SPDX-License-Identifier: MIT
#include "gui/viewmodels/log_words.hpp"

#include <QCoreApplication>
#include <QTranslator>

#include "app/records/record_kind.hpp"
#include "core/model/unit.hpp"
#include "gui/viewmodels/record_words.hpp"
#include "gui/viewmodels/records_model.hpp"
#include "gui/viewmodels/words.hpp"
#include "strat/checks/check.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"

using namespace planum;
using namespace planum::gui;

namespace {

struct German {
    QTranslator translator;
    bool there = translator.load(QStringLiteral(":/translations/planum_de.qm"));

    German() {
        if (there) QCoreApplication::installTranslator(&translator);
    }

    ~German() { QCoreApplication::removeTranslator(&translator); }
};

} // namespace

TEST_CASE("The log speaks of actions, columns and states as the window does") {
    test::ensure_core_application();
    CHECK(log_action_word("insert") == QStringLiteral("recorded"));
    CHECK(log_action_word("another") == QStringLiteral("another"));
    CHECK(author_word("outside Planum") == QStringLiteral("another program"));
    CHECK(author_word("Ada Hartmann") == QStringLiteral("Ada Hartmann"));
    CHECK(stored_field_label("excavated_on") == QStringLiteral("Dug away on"));
    CHECK(stored_field_label("munsell") == QStringLiteral("Munsell colour"));
    CHECK(stored_field_label("found_on") == QStringLiteral("Found on"));
    CHECK(stored_value_word("status", "partly-excavated") == QStringLiteral("partly excavated"));
    CHECK(stored_value_word("title", "open") == QStringLiteral("open"));
}

TEST_CASE("In German no field of the full record and no word of the lists is left in English") {
    test::ensure_core_application();
    const German german;
    if (!german.there) {
        WARN("skipped: no translations were built");
        return;
    }
    for (const model::UnitFieldInfo& field : model::kUnitFields) {
        if (field.label == "Flotation") continue; // the same in German
        INFO(field.label);
        const std::string label(field.label);
        CHECK(QCoreApplication::translate("card", label.c_str()).toStdString() != label);
    }
    for (const QString& kind : RecordsModel::kinds()) {
        INFO(kind.toStdString());
        CHECK(record_list_title(kind) != kind);
        CHECK(record_thing_word(kind) != kind);
        CHECK(record_name_form(kind) != kind);
        for (const app::FieldInfo& field : app::record_kind(kind.toStdString()).fields()) {
            for (const std::string& word : field.words) {
                const QString stored = QString::fromStdString(word);
                INFO(field.name << " " << word);
                CHECK(record_value_word(kind, QString::fromStdString(field.name), stored) != stored);
            }
        }
    }
}

TEST_CASE("Every check has a title that people read instead of its code") {
    test::ensure_core_application();
    for (const strat::CheckCode& check : strat::all_check_codes()) {
        INFO(check.code);
        CHECK(check_title(check.code) != qt(check.code));
    }
}
