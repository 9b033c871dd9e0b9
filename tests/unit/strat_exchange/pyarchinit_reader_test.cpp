// SPDX-License-Identifier: MIT
#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>

#include "core/base/error.hpp"
#include "core/sqlite/database.hpp"
#include "strat/exchange/dating_text.hpp"
#include "strat/exchange/pyarchinit_relations.hpp"
#include "strat/exchange/python_literal.hpp"
#include "strat/exchange/readers.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/real_data.hpp"
#include "tests/support/temporary.hpp"
#include "tests/unit/strat_exchange/matrix_oracle.hpp"
#include "tests/unit/strat_exchange/reader_support.hpp"

using namespace planum;
using namespace planum::strat;
using planum::test::input;
using planum::test::read_with;
using Texts = std::vector<std::string>;

namespace {

const std::string kRelations = "us,area,settore,rapporti,osservazioni\n"
                               "1,A,N,\"[['Covers', '2', 'A', 'Hill'], ['Cut by', '3', 'A', 'Hill']]\",\"\"\n"
                               "2,A,N,\"[['Covers', '', 'A', 'Hill'], ['Same as', '4']]\",roots\n"
                               "3,A,S,\"[['Dances with', '2', 'A', 'Hill']]\",\"\"\n"
                               "4,A,S,\"[['Covers', '2'\",\"\"\n"
                               "5,A,S,[],\"\"\n";

const std::string kPeriods = "us,area,settore,periodo_iniziale,fase_iniziale,periodo_finale,fase_finale,datazione\n"
                             "1,A,N,1,1,1,1,Recent (1800 : present)\n"
                             "2,A,N,2,1,1,1,Old (-300 : 100) / Recent (1800 : present)\n"
                             "3,A,S,1,1,\"\",\"\",Recent (1800 : present) / \n";

strat::InputFile database(const test::TemporaryFolder& folder, std::string_view script) {
    const auto file = folder / "site.sqlite";
    {
        const auto made = sqlite::Database::open(file, sqlite::Access::Create);
        made.execute(script);
    }
    return load_input_file(file);
}

const ImportedUnit& unit(const ImportedRecord& record, std::string_view number) {
    for (const ImportedUnit& candidate : record.units) {
        if (candidate.name.number == number) return candidate;
    }
    throw std::runtime_error("no unit " + std::string(number));
}

} // namespace

TEST_CASE("pyArchInit's table of relations is read item by item, and what is wrong is named by line") {
    const auto read = read_with(pyarchinit_reader(), {input("rel.csv", kRelations)});
    CHECK(test::relation_texts(read.values) == Texts{"1 covers 2", "3 cuts 1", "2 same_as 4"});
    CHECK(read.values.relations[1].side == model::StatementSide::Object);
    CHECK(read.values.relations[1].line == 2);
    CHECK(read.values.relations[0].object.area == "A");
    CHECK(read.values.units.size() == 5);
    CHECK(read.values.project_name == "Hill");
    CHECK(unit(read.values, "2").values.details.at("observations") == "roots");
    REQUIRE(read.diagnostics.size() == 3);
    CHECK(read.diagnostics[0].code == "empty-target");
    CHECK(read.diagnostics[0].line == 3);
    CHECK(read.diagnostics[0].file == "rel.csv");
    CHECK(read.diagnostics[0].raw_text == "['Covers', '', 'A', 'Hill']");
    CHECK(read.diagnostics[1].code == "unknown-relation");
    CHECK(read.diagnostics[1].line == 4);
    CHECK(read.diagnostics[2].code == "unparsed");
    CHECK(read.diagnostics[2].line == 5);
}

TEST_CASE("pyArchInit's tables of relations and periods are read together in any order") {
    const auto one = read_with(pyarchinit_reader(), {input("rel.csv", kRelations), input("per.csv", kPeriods)});
    const auto two = read_with(pyarchinit_reader(), {input("per.csv", kPeriods), input("rel.csv", kRelations)});
    for (const auto* read : {&one, &two}) {
        const ImportedRecord& record = read->values;
        CHECK(record.units.size() == 5);
        CHECK(record.relations.size() == 3);
        CHECK(unit(record, "2").phase == "2-1");
        CHECK(unit(record, "2").period == "2");
        CHECK(unit(record, "2").values.details.at("custom") == "fase_finale=1\nperiodo_finale=1");
        CHECK(unit(record, "3").phase == "1-1");
        REQUIRE(record.phases.size() == 2);
        const auto old = std::find_if(record.phases.begin(), record.phases.end(),
                                      [](const auto& phase) { return phase.values.number == "2-1"; });
        REQUIRE(old != record.phases.end());
        CHECK(old->values.title == "Old");
        CHECK(old->values.from == -300);
        CHECK(old->values.to == 100);
        CHECK(record.periods.size() == 2);
    }
}

TEST_CASE("The date of a pyArchInit unit is that of the phase in which it was formed") {
    const auto read = read_with(pyarchinit_reader(), {input("per.csv", kPeriods)});
    REQUIRE(read.values.datings.size() == 3);
    const model::Dating& dating = read.values.datings[1].values;
    CHECK(read.values.datings[1].unit == UnitName{"A", "2"});
    CHECK(dating.kind == model::DatingKind::Typed);
    CHECK(dating.from == -300);
    CHECK(dating.to == 100);
    CHECK(read.values.datings[0].values.from == 1800);
    CHECK_FALSE(read.values.datings[0].values.to);
}

TEST_CASE("A pyArchInit database gives units, phases, heights, finds and relations") {
    const test::TemporaryFolder folder;
    const InputFile file = database(folder, R"(
CREATE TABLE us_table (id_us INTEGER PRIMARY KEY, sito TEXT, area TEXT, us TEXT, unita_tipo TEXT, d_stratigrafica TEXT,
  d_interpretativa TEXT, periodo_iniziale TEXT, fase_iniziale TEXT, rapporti TEXT, struttura TEXT, scavato TEXT,
  quota_max_abs REAL, colore TEXT, schedatore TEXT);
INSERT INTO us_table VALUES
 (1,'Hill','1','10','US','Strato di terra','floor','2','1','[[''Copre'', ''11'', ''1'', ''Hill'']]','ST1/ST2','Si',4.5,'grey','Ada'),
 (2,'Hill','1','11','US','Taglio','','','','Coperto da 10, Copre 12; Riempito da','','No',NULL,'',''),
 (3,'Hill','1','12','USM','Muro','','','','> 13','','',NULL,'',''),
 (4,'Hill','1','13','USVA','virtual','','','','< 12','','',NULL,'','');
CREATE TABLE periodizzazione_table (sito TEXT, periodo INTEGER, fase TEXT, cron_iniziale INTEGER, cron_finale INTEGER,
  descrizione TEXT, datazione_estesa TEXT);
INSERT INTO periodizzazione_table VALUES ('Hill',2,'1',-300,100,'','Hellenistic');
CREATE TABLE pyarchinit_quote (sito_q TEXT, area_q TEXT, us_q INTEGER, unita_misu_q TEXT, quota_q REAL, the_geom BLOB);
INSERT INTO pyarchinit_quote VALUES ('Hill','1',11,'m',3.25,
  x'0001E6100000000000000000F03F0000000000000040000000000000F03F00000000000000407C01000000000000000000F03F0000000000000040FE');
CREATE TABLE inventario_materiali_table (sito TEXT, numero_inventario INTEGER, tipo_reperto TEXT, definizione TEXT,
  area TEXT, us TEXT, datazione_reperto TEXT);
INSERT INTO inventario_materiali_table VALUES ('Hill',7,'Coin','as','1','10','98-117 AD');
CREATE TABLE us_relationships_table (sito TEXT, us_from INTEGER, us_to INTEGER, relationship_type TEXT);
INSERT INTO us_relationships_table VALUES ('Hill',10,11,'Copre'),('Hill',11,10,'Coperto da'),('Hill',12,10,'Coperto da');
)");
    REQUIRE(file.is_database);
    const auto recognised = pyarchinit_reader().recognise(std::span(&file, 1));
    CHECK(recognised.confidence == Confidence::Certain);
    const auto read = read_with(pyarchinit_reader(), {file});
    const ImportedRecord& record = read.values;
    CHECK(record.project_name == "Hill");
    CHECK(test::relation_texts(record) == Texts{"10 covers 11", "10 covers 11", "11 covers 12", "10 covers 12"});
    CHECK(record.relations.back().side == model::StatementSide::Neither);
    CHECK(unit(record, "11").values.kind == model::UnitKind::Cut);
    CHECK(unit(record, "12").values.form == model::UnitForm::Masonry);
    CHECK(unit(record, "10").values.status == model::UnitStatus::Excavated);
    CHECK(unit(record, "10").phase == "2-1");
    CHECK(unit(record, "10").values.details.at("colour") == "grey");
    CHECK(unit(record, "12").values.details.at("custom") == "extended_matrix=> 13");
    REQUIRE(record.levels.size() == 2);
    CHECK(record.levels[0].values.z == 4.5);
    CHECK(record.levels[1].values.role == model::LevelRole::Cut);
    CHECK(record.levels[1].values.x == 1.0);
    CHECK(record.levels[1].values.y == 2.0);
    REQUIRE(record.phases.size() == 1);
    CHECK(record.phases[0].values.title == "Hellenistic");
    CHECK(record.phases[0].values.from == -300);
    REQUIRE(record.finds.size() == 1);
    CHECK(record.finds[0].unit == UnitName{"1", "10"});
    REQUIRE(record.datings.size() == 1);
    CHECK(record.datings[0].values.kind == model::DatingKind::Coin);
    CHECK(record.datings[0].values.from == 98);
    CHECK(record.groups.size() == 2);
    CHECK(test::count_notes(read.diagnostics, "empty-target") == 1);
    CHECK(test::count_notes(read.diagnostics, "extended-matrix-link") == 2);
}

TEST_CASE("Of several sites in a pyArchInit database the largest is taken, or the one named, or all") {
    const test::TemporaryFolder folder;
    const InputFile file = database(folder, R"(
CREATE TABLE us_table (sito TEXT, area TEXT, us TEXT);
INSERT INTO us_table VALUES ('Hill','1','1'),('Hill','1','2'),('Valley','1','1');)");
    const auto largest = read_with(pyarchinit_reader(), {file});
    CHECK(largest.values.project_name == "Hill");
    CHECK(largest.values.units.size() == 2);
    REQUIRE(test::count_notes(largest.diagnostics, "several-sites") == 1);
    CHECK(largest.diagnostics[0].message ==
          "site Hill with 2 units was read; left out: Valley (1 unit); --site takes another or all (*)");
    ReadOptions valley;
    valley.site = "Valley";
    CHECK(read_with(pyarchinit_reader(), {file}, valley).values.units.size() == 1);
    ReadOptions all;
    all.site = "*";
    const auto everything = read_with(pyarchinit_reader(), {file}, all);
    REQUIRE(everything.values.units.size() == 3);
    CHECK(everything.values.units[2].name == UnitName{"Valley 1", "1"});
}

TEST_CASE("A view or trigger named like a pyArchInit table is not read") {
    const test::TemporaryFolder folder;
    const InputFile file = database(folder, "CREATE TABLE t(us); INSERT INTO t VALUES('1');"
                                            "CREATE VIEW us_table AS SELECT us, 'x' AS sito FROM t;");
    CHECK(pyarchinit_reader().recognise(std::span(&file, 1)).confidence == Confidence::No);
    CHECK_THROWS_WITH(read_with(pyarchinit_reader(), {file}), Catch::Contains("no table us_table"));
    const test::TemporaryFolder other;
    const InputFile trigger =
        database(other, "CREATE TABLE t(us); CREATE TRIGGER us_table AFTER INSERT ON t BEGIN DELETE FROM t; END;");
    CHECK_THROWS_WITH(read_with(pyarchinit_reader(), {trigger}), Catch::Contains("no table us_table"));
}

TEST_CASE("A pyArchInit table of pairs finds units by number where only one has it") {
    const test::TemporaryFolder folder;
    const InputFile file = database(folder, R"(
CREATE TABLE us_table (area TEXT, us TEXT);
INSERT INTO us_table VALUES ('A','1'),('A','2'),('B','2');
CREATE TABLE harris_matrix_table (us_sopra INTEGER, us_sotto INTEGER, tipo_rapporto TEXT);
INSERT INTO harris_matrix_table VALUES (1,2,'Copre'),(2,1,'nonsense');)");
    const auto read = read_with(pyarchinit_reader(), {file});
    REQUIRE(read.values.relations.size() == 2);
    CHECK(read.values.relations[0].subject == UnitName{"A", "1"});
    CHECK(read.values.relations[0].object == UnitName{"", "2"});
    CHECK(read.values.relations[1].kind == model::RelationKind::Later);
}

TEST_CASE("A pyArchInit database cut at any place is an error or a smaller record, never a crash") {
    const test::TemporaryFolder folder;
    const InputFile whole = database(folder, "CREATE TABLE us_table(sito TEXT, us TEXT, rapporti TEXT);"
                                             "INSERT INTO us_table VALUES('H','1','Copre 2'),('H','2','');");
    std::ifstream in(whole.path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    for (std::size_t size = 100; size < bytes.size(); size += 97) {
        const InputFile cut = load_input_file(folder.write("cut.sqlite", std::string_view(bytes).substr(0, size)));
        INFO(size);
        try {
            const auto read = read_with(pyarchinit_reader(), {cut});
            CHECK(read.values.units.size() <= 2);
        } catch (const Error& e) {
            CHECK(std::string(e.what()).find("cut.sqlite") != std::string::npos);
        }
    }
}

TEST_CASE("The relations of a pyArchInit sheet are read from lists and from words") {
    const auto kinds = [](std::string_view cell) {
        Texts out;
        for (const auto& relation : read_rapporti(cell).relations) {
            out.push_back(std::string(relation.kind.inverse ? "-" : "+") +
                          std::string(model::to_word(relation.kind.kind)) + " " + relation.target);
        }
        return out;
    };
    CHECK(kinds("[['Copre', '13', '1', 'Site'], ['Tagliato da', 20]]") == Texts{"+covers 13", "-cuts 20"});
    CHECK(kinds("['Copre', '13', '1', 'Site']") == Texts{"+covers 13"});
    CHECK(kinds("[['', 'Copre', '13', '1']]") == Texts{"+covers 13"});
    CHECK(kinds("Covers US 1001") == Texts{"+covers 1001"});
    CHECK(kinds("Copre 2, 8; Si appoggia a 6, Gli si appoggia 4") ==
          Texts{"+covers 2", "+covers 8", "+abuts 6", "-abuts 4"});
    CHECK(kinds("[['', '', '', '']]").empty());
    CHECK(read_rapporti("[['', '', '', '']]").problems.empty());
    CHECK(read_rapporti("[['Covers', ' ']]").problems.front().code == "empty-target");
    CHECK(read_rapporti("[['Covers', '12?']]").relations.front().uncertain);
    CHECK(read_rapporti("__import__('os').system('x')").problems.size() == 1);
}

TEST_CASE("A printed Python list is read as data, whatever it holds") {
    REQUIRE(read_python_list(R"([['l\'altro', "a, b", None, 3, u'\u00e0'], []])"));
    const auto list = *read_python_list(R"([['l\'altro', "a, b", None, 3, u'\u00e0'], []])");
    REQUIRE(list.items.size() == 2);
    CHECK(list.items[0].items[0].text == "l'altro");
    CHECK(list.items[0].items[1].text == "a, b");
    CHECK(list.items[0].items[2].text.empty());
    CHECK(list.items[0].items[3].text == "3");
    CHECK(list.items[0].items[4].text == "à");
    CHECK_FALSE(read_python_list("[1, 2"));
    CHECK_FALSE(read_python_list("[1] + [2]"));
    CHECK_FALSE(read_python_list("['a"));
    CHECK_FALSE(read_python_list("['\\u12"));
    CHECK_FALSE(read_python_list(std::string(100'000, '[')));
    std::string long_list = "[";
    for (int i = 0; i < 100'001; ++i) long_list += "1,";
    CHECK_FALSE(read_python_list(long_list + "]"));
}

TEST_CASE("Years are read from datings only where they are certain") {
    const auto span = [](model::Year from, model::Year to) { return YearSpan{from, to}; };
    CHECK(years_in_text("Late Bronze (-1300 : -1200)") == span(-1300, -1200));
    CHECK(years_in_text("Now (630 CE : present)") == YearSpan{630, std::nullopt});
    CHECK(years_in_text("98-117 AD") == span(98, 117));
    CHECK(years_in_text("300-200 a.C.") == span(-300, -200));
    CHECK(years_in_text("50 BC - 20 AD") == span(-50, 20));
    CHECK(years_in_text("-50 : 20") == span(-50, 20));
    CHECK(years_in_text("XV secolo") == span(1401, 1500));
    CHECK(years_in_text("1st century AD") == span(1, 100));
    CHECK(years_in_text("2nd century BC") == span(-200, -101));
    CHECK_FALSE(years_in_text("Wall (2-3)"));
    CHECK_FALSE(years_in_text("Prima metà del XVI secolo"));
    CHECK_FALSE(years_in_text("(300 : -200)"));
    CHECK_FALSE(years_in_text("99999999999999999999 : 5"));
    CHECK_FALSE(years_in_text(""));
}

TEST_CASE("Al-Khutm is read as counted") {
    const auto relations = test::real_data("matrix/pyarchinit/alkhutm_us_senza_periodo.csv");
    const auto periods = test::real_data("matrix/pyarchinit/alkhutm_us_con_periodo_FINALE.csv");
    if (!relations || !periods) return;
    const auto read = read_with(pyarchinit_reader(), {load_input_file(*relations), load_input_file(*periods)});
    CHECK(test::count_matrix(read.values) ==
          test::MatrixCounts{482, 376, 15, 1, 1, 2, 15, 6, 6, 25, 61, 328, 12, 223, 1});
    CHECK(test::count_notes(read.diagnostics, "empty-target") == 17);
    CHECK(read.diagnostics.size() == 17);
    for (const ReadNote& note : read.diagnostics) {
        CHECK(note.file == "alkhutm_us_senza_periodo.csv");
        CHECK(note.line > 1);
    }
    // Years of the periods touch: what ended in -1300 ended before what began in -1300.
    std::map<UnitName, model::Dating> dates;
    for (const auto& dating : read.values.datings) dates.emplace(dating.unit, dating.values);
    std::set<std::pair<UnitName, UnitName>> orders;
    for (const auto& relation : read.values.relations) {
        if (model::time_meaning(relation.kind) == model::TimeMeaning::SubjectLater) {
            orders.emplace(relation.subject, relation.object);
        }
    }
    int impossible = 0;
    for (const auto& [later, earlier] : orders) {
        const auto a = dates.find(later);
        const auto b = dates.find(earlier);
        if (a == dates.end() || b == dates.end() || later == earlier) continue;
        impossible += a->second.to && b->second.from && *a->second.to <= *b->second.from ? 1 : 0;
    }
    CHECK(impossible == 49);
}

TEST_CASE("The tutorial database is read as counted") {
    const auto file = test::real_data("matrix/pyarchinit/pyarchinit_tutorial.db");
    if (!file) return;
    const auto read = read_with(pyarchinit_reader(), {load_input_file(*file)});
    CHECK(test::count_matrix(read.values) == test::MatrixCounts{51, 81, 0, 0, 0, 0, 0, 0, 0, 0, 34, 81, 23, 12});
    CHECK(read.values.project_name == "Scavo archeologico");
    CHECK(test::count_notes(read.diagnostics, "several-sites") == 1);
}
