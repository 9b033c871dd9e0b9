// SPDX-License-Identifier: MIT
#include "gui/viewmodels/models.hpp"

#include <algorithm>

#include "app/records/record_kind.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;
using Part = RelationEntryModel::Part;

namespace {

struct Desk {
    test::GuiProject site;
    Models models{app::Session{"Ada"}};
    QStringList failures;

    Desk() {
        QObject::connect(&models.workspace, &Workspace::failed, [this](const QString& s) { failures << s; });
        models.workspace.open(site.file, store::OpenMode::ReadWrite);
        settle(models.workspace);
    }

    void relate(const char* subject, const char* kind, const char* object) {
        models.entry.set(Part::Subject, QString::fromUtf8(subject));
        models.entry.set(Part::Kind, QString::fromUtf8(kind));
        models.entry.set(Part::Object, QString::fromUtf8(object));
    }

    void select(const std::string& number) {
        const auto& snapshot = models.workspace.snapshot();
        models.workspace.select(snapshot->record().units[snapshot->index().named(number).front()].id);
        settle(models.workspace);
    }

    [[nodiscard]] std::size_t relations() const { return models.workspace.snapshot()->record().relations.size(); }
};

int row_of_code(const ProblemListModel& problems, const std::string& code) {
    for (int row = 0; row < problems.rowCount(); ++row) {
        const QString id = problems.data(problems.index(row), ProblemListModel::IdRole).toString();
        for (const model::Diagnostic& d : problems.check().problems) {
            if (d.code == code && QString::fromStdString(d.id) == id) return row;
        }
    }
    return -1;
}

} // namespace

TEST_CASE("The list narrows while somebody types: beginnings of numbers, or words of the definition") {
    Desk desk;
    UnitListModel& units = desk.models.units;
    CHECK(units.rowCount() == 3);
    units.set_filter({QStringLiteral("floor"), {}, {}, {}, false});
    REQUIRE(units.rowCount() == 1);
    CHECK(units.data(units.index(0, UnitListModel::Number), Qt::DisplayRole).toString() == QStringLiteral("3"));
    units.set_filter({QStringLiteral("2"), {}, {}, {}, false});
    CHECK(units.rowCount() == 1);
    units.set_filter({{}, model::UnitKind::Cut, {}, {}, false});
    CHECK(units.rowCount() == 1);
    units.set_filter({{}, {}, model::UnitStatus::Open, {}, false});
    CHECK(units.rowCount() == 2);
    units.set_filter({{}, {}, {}, desk.models.workspace.snapshot()->record().areas.front().id, false});
    CHECK(units.rowCount() == 2);
    CHECK(units.total() == 3);
}

TEST_CASE("Every field of a unit is on the card, with the value that the command line shows") {
    Desk desk;
    app::Project project = desk.site.reopened();
    const app::RecordKind& kind = app::record_kind("unit");
    for (const std::string number : {"1", "2", "3"}) {
        desk.select(number);
        const auto& fields = desk.models.card.fields();
        const app::FieldValues shown = kind.show(project, number);
        for (const app::FieldInfo& info : kind.fields()) {
            INFO(info.name);
            if (info.name == "form") continue; // the card's kind says both
            const auto field =
                std::find_if(fields.begin(), fields.end(), [&](const CardField& f) { return f.name == info.name; });
            REQUIRE(field != fields.end());
            const auto value =
                std::find_if(shown.begin(), shown.end(), [&](const auto& v) { return v.first == info.name; });
            const bool empty = value == shown.end();
            if (field->choices.isEmpty()) {
                CHECK(field->value.toStdString() == (empty ? "" : value->second));
            } else {
                CHECK(field->choices.size() == field->stored.size());
                CHECK((field->value.isEmpty() || field->choices.contains(field->value)));
            }
        }
    }
}

TEST_CASE("Every choice of a card's field can be stored and is shown again") {
    Desk desk;
    desk.select("3");
    for (const std::string name : {"kind", "status", "area"}) {
        const auto choices = [&] {
            for (const CardField& field : desk.models.card.fields()) {
                if (field.name == name) return field.choices;
            }
            return QStringList();
        }();
        for (const QString& choice : choices) {
            INFO(name << " " << choice.toStdString());
            desk.models.card.set_field(name, choice);
            settle(desk.models.workspace);
            CHECK(desk.failures.isEmpty());
            for (const CardField& field : desk.models.card.fields()) {
                if (field.name == name) CHECK(field.value == choice);
            }
        }
    }
}

TEST_CASE("The card reads relations from the unit's own side") {
    Desk desk;
    desk.select("2");
    const auto& relations = desk.models.card.relations();
    REQUIRE(relations.size() == 2);
    CHECK(relations[0].sentence == QStringLiteral("filled by 1"));
    CHECK(relations[1].sentence == QStringLiteral("cuts 3"));
    CHECK(relations[0].said_by.contains(QStringLiteral("Ada")));
}

TEST_CASE("A new unit takes the next number and is selected") {
    Desk desk;
    CHECK(desk.models.card.next_number() == QStringLiteral("4"));
    desk.models.card.add_unit({});
    settle(desk.models.workspace);
    CHECK(desk.models.card.name() == QStringLiteral("4"));
    desk.models.card.delete_unit();
    settle(desk.models.workspace);
    CHECK(desk.models.card.unit().is_nil());
    CHECK(desk.models.units.total() == 3);
}

TEST_CASE("Kinds may be begun, in any of the languages") {
    const auto kind = [](const char* typed) { return RelationEntryModel::kind_of(QString::fromUtf8(typed)); };
    CHECK(kind("c") == model::DirectedKind{model::RelationKind::Covers, false});
    CHECK(kind("cut b") == model::DirectedKind{model::RelationKind::Cuts, true});
    CHECK(kind("fi") == model::DirectedKind{model::RelationKind::Fills, false});
    CHECK(kind("liegt über") == model::DirectedKind{model::RelationKind::Covers, false});
    CHECK(kind("Coperto da") == model::DirectedKind{model::RelationKind::Covers, true});
    CHECK_FALSE(kind("xyz"));
    CHECK_FALSE(kind("  "));
}

TEST_CASE("A relation typed from the lower side is stored from the upper one, and the fields wait for the next") {
    Desk desk;
    desk.relate("3", "covered by", "1");
    REQUIRE(desk.models.entry.judgement().ready);
    CHECK_FALSE(desk.models.entry.judgement().warns);
    REQUIRE(desk.models.entry.commit());
    CHECK(desk.models.entry.text(Part::Subject) == QStringLiteral("3"));
    CHECK(desk.models.entry.text(Part::Object).isEmpty());
    settle(desk.models.workspace);
    CHECK(desk.relations() == 3);
    desk.select("1");
    bool found = false;
    for (const CardRelation& relation : desk.models.card.relations()) {
        found = found || relation.sentence == QStringLiteral("covers 3");
    }
    CHECK(found);
}

TEST_CASE("A relation that would close a circle warns first, shows the circle, and is recorded all the same") {
    Desk desk;
    desk.relate("3", "covers", "1");
    const auto& judgement = desk.models.entry.judgement();
    CHECK(judgement.ready);
    CHECK(judgement.warns);
    CHECK(judgement.cycle.size() == 3);
    desk.models.entry.show_cycle();
    CHECK(desk.models.workspace.proof().units.size() == 3);
    CHECK(desk.models.entry.commit());
    settle(desk.models.workspace);
    CHECK(desk.relations() == 3);
    CHECK(row_of_code(desk.models.problems, "cycle") >= 0);
}

TEST_CASE("A number without a unit yet is said, and Enter adds both") {
    Desk desk;
    desk.relate("31", "covers", "3");
    CHECK(desk.models.entry.judgement().ready);
    CHECK(desk.models.entry.judgement().warns);
    desk.models.entry.commit();
    settle(desk.models.workspace);
    CHECK(desk.failures.isEmpty());
    CHECK(desk.models.units.total() == 4);
    CHECK(desk.relations() == 3);
}

TEST_CASE("What is missing is named, and nothing is added before it is there") {
    Desk desk;
    CHECK(desk.models.entry.judgement().miss == Part::Subject);
    desk.relate("1", "", "");
    CHECK(desk.models.entry.judgement().miss == Part::Kind);
    desk.relate("1", "cuts", "");
    CHECK(desk.models.entry.judgement().miss == Part::Object);
    CHECK_FALSE(desk.models.entry.commit());
    settle(desk.models.workspace);
    CHECK(desk.relations() == 2);
}

TEST_CASE("A suspect is withdrawn with a reason; the problem goes, undo brings both back") {
    Desk desk;
    desk.relate("3", "covers", "1");
    desk.models.entry.commit();
    settle(desk.models.workspace);
    ProblemListModel& problems = desk.models.problems;
    problems.open(row_of_code(problems, "cycle"));
    const ProblemDetail detail = problems.detail();
    REQUIRE_FALSE(detail.suspects.empty());
    CHECK(desk.models.workspace.proof().units.size() == 3);
    std::size_t at = detail.suspects.size();
    for (std::size_t i = 0; i < detail.suspects.size(); ++i) {
        const auto& actions = detail.suspects[i].actions;
        if (std::find(actions.begin(), actions.end(), ProblemAction::Withdraw) != actions.end()) at = std::min(at, i);
    }
    REQUIRE(at < detail.suspects.size());
    problems.act(at, ProblemAction::Withdraw, QStringLiteral("seen in the section"));
    settle(desk.models.workspace);
    CHECK(desk.failures.isEmpty());
    CHECK(desk.relations() == 2);
    CHECK(row_of_code(problems, "cycle") == -1);
    CHECK(problems.opened() == -1);
    CHECK(desk.models.workspace.undo_label().contains(QStringLiteral("seen in the section")));
    desk.models.workspace.undo();
    settle(desk.models.workspace);
    CHECK(row_of_code(problems, "cycle") >= 0);
}

TEST_CASE("An action without a reason is refused with a sentence") {
    Desk desk;
    desk.relate("3", "covers", "1");
    desk.models.entry.commit();
    settle(desk.models.workspace);
    desk.models.problems.open(row_of_code(desk.models.problems, "cycle"));
    desk.models.problems.accept(QStringLiteral("  "));
    settle(desk.models.workspace);
    CHECK(desk.failures.size() == 1);
}

TEST_CASE("A problem known because of something falls silent; a day signed off makes nothing new") {
    Desk desk;
    desk.relate("3", "covers", "1");
    desk.models.entry.commit();
    settle(desk.models.workspace);
    ProblemListModel& problems = desk.models.problems;
    problems.open(row_of_code(problems, "cycle"));
    problems.accept(QStringLiteral("undercut"));
    settle(desk.models.workspace);
    CHECK(row_of_code(problems, "cycle") == -1);
    problems.sign_off();
    settle(desk.models.workspace);
    CHECK_FALSE(problems.check().signed_off_at.empty());
    CHECK(problems.check().new_ids.empty());
    CHECK(problems.changes_since_sign_off().isEmpty());
    desk.relate("3", "covers", "2");
    desk.models.entry.commit();
    settle(desk.models.workspace);
    REQUIRE(problems.changes_since_sign_off().size() == 1);
    CHECK(problems.changes_since_sign_off().front().contains(QStringLiteral("Ada")));
}
