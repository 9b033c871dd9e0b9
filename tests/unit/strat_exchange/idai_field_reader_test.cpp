// SPDX-License-Identifier: MIT
#include "core/base/error.hpp"
#include "strat/exchange/readers.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/real_data.hpp"
#include "tests/unit/strat_exchange/matrix_oracle.hpp"
#include "tests/unit/strat_exchange/reader_support.hpp"

using namespace planum;
using namespace planum::strat;
using planum::test::input;
using planum::test::read_with;
using planum::test::relation_texts;
using Texts = std::vector<std::string>;

namespace {

// One line, as the program writes it.
const std::string kLines =
    R"({"version":"1"})"
    "\n"
    R"({"docs":[{"resource":{"id":"p","identifier":"hill","category":"Project","shortDescription":{"en":"The Hill"}}},)"
    R"({"resource":{"id":"t","identifier":"Trench 1","type":"Trench","relations":{}}},)"
    R"({"resource":{"id":"a","identifier":"L1","type":"Layer","shortDescription":"floor","color":["grey","brown"],"beginningDate":"05.03.2021","relations":{"isRecordedIn":["t"],"liesWithin":["f"],"isAbove":["b","gone"],"isContemporaryWith":["c"]},"period":{"value":"Roman"},"dating":[{"type":"range","begin":{"inputYear":480,"inputType":"bce"},"end":{"inputYear":333,"inputType":"bce","year":-333}}]}},)"
    R"({"resource":{"id":"b","identifier":"L2","category":"Own:Layer","isNatural":true,"relations":{"isRecordedIn":["t"],"isBelow":["a"]}}},)"
    R"({"resource":{"id":"c","identifier":"L3","category":"Own:Odd","relations":{"isCutBy":["a"]}}},)"
    R"({"resource":{"id":"f","identifier":"F1","category":"Feature","relations":{"isRecordedIn":["t"]}}},)"
    R"({"resource":{"id":"k","identifier":"C1","category":"Coin","weight":"3.5","geometry":{"type":"Point","coordinates":[1.5,2.5,3.5]},"relations":{"isRecordedIn":["t"],"liesWithin":["a"]},"dating":[{"type":"exact","end":{"inputYear":98,"inputType":"ce"}}]}},)"
    R"({"resource":{"id":"i","identifier":"1.jpg","category":"Photo","relations":{"depicts":["k"]}}}]})"
    "\n"
    R"({"seq":5})"
    "\n";

} // namespace

TEST_CASE("iDAI.field's resources become units, finds and areas, ids become identifiers") {
    const InputFile file = input("f.jsonl", kLines);
    CHECK(idai_field_reader().recognise(std::span(&file, 1)).confidence == Confidence::Certain);
    const auto read = read_with(idai_field_reader(), {file});
    const ImportedRecord& record = read.values;
    CHECK(record.project_name == "The Hill");
    CHECK(relation_texts(record) == Texts{"L1 covers L2", "L1 contemporary L3", "L1 covers L2", "L1 cuts L3"});
    REQUIRE(record.units.size() == 4);
    CHECK(record.units[0].name == UnitName{"Trench 1", "L1"});
    CHECK(record.units[0].parent == UnitName{"Trench 1", "F1"});
    CHECK(record.units[0].values.title == "floor");
    CHECK(record.units[0].values.excavated_from == "2021-03-05");
    CHECK(record.units[0].values.details.at("colour") == "grey, brown");
    CHECK(record.units[0].period == "Roman");
    CHECK(record.units[1].values.kind == model::UnitKind::Natural);
    REQUIRE(record.areas.size() == 1);
    REQUIRE(record.finds.size() == 1);
    CHECK(record.finds[0].unit == UnitName{"Trench 1", "L1"});
    CHECK(record.finds[0].values.weight == 3.5);
    CHECK(record.finds[0].values.z == 3.5);
    REQUIRE(record.datings.size() == 2);
    CHECK(record.datings[0].values.from == -480);
    CHECK(record.datings[0].values.to == -333);
    CHECK(record.datings[1].values.kind == model::DatingKind::Coin);
    CHECK(record.datings[1].values.from == 98);
    REQUIRE(record.documents.size() == 1);
    CHECK(record.documents[0].unit == UnitName{"Trench 1", "L1"});
    REQUIRE(read.diagnostics.size() == 1);
    CHECK(read.diagnostics[0].code == "unknown-target");
    CHECK(read.diagnostics[0].line == 2);
}

TEST_CASE("A damaged line of an iDAI.field dump is reported by its number and the others are read") {
    const auto read = read_with(idai_field_reader(), {input("f.jsonl", kLines + "{\"docs\":[\n")});
    CHECK(read.values.units.size() == 4);
    REQUIRE(test::count_notes(read.diagnostics, "unparsed") == 1);
    CHECK(read.diagnostics.front().line == 4);
    CHECK_THROWS_WITH(read_with(idai_field_reader(), {input("f.jsonl", "{\"seq\":1}\n")}),
                      Catch::StartsWith("f.jsonl: no line with a resource"));
    for (std::size_t size = 1; size < kLines.size(); size += 7) {
        try {
            const auto cut = read_with(idai_field_reader(), {input("f.jsonl", kLines.substr(0, size))});
            CHECK(cut.values.units.size() <= 4);
        } catch (const Error& e) {
            CHECK(std::string_view(e.what()).starts_with("f.jsonl: "));
        }
    }
}

TEST_CASE("Things of iDAI.field that lie in each other do not send the reader round in circles") {
    const auto read = read_with(
        idai_field_reader(),
        {input("f.jsonl",
               R"([{"id":"a","identifier":"1","category":"Layer","relations":{"liesWithin":["a"],"isAbove":["a"]}},)"
               R"({"id":"x","identifier":"x","category":"Bone","relations":{"liesWithin":["y"]}},)"
               R"({"id":"y","identifier":"y","category":"Bone","relations":{"liesWithin":["x"]}}])")});
    CHECK(read.values.units.size() == 1);
    CHECK(read.values.units[0].parent.number.empty());
    CHECK(read.values.finds.size() == 2);
    CHECK(relation_texts(read.values) == Texts{"1 covers 1"});
}

TEST_CASE("iDAI.field's test project is read whole") {
    const auto file = test::real_data("matrix/idaifield/rtest.jsonl");
    if (!file) return;
    const auto read = read_with(idai_field_reader(), {load_input_file(*file)});
    const auto counts = test::count_matrix(read.values);
    // Six layers, two features and a grave; the layers' relations as they stand in the file.
    CHECK(counts.units == 9);
    CHECK(counts.orders == 5);
    CHECK(counts.cycle_groups == 0);
    CHECK(read.values.areas.size() == 4);
    CHECK(read.diagnostics.empty());
}
