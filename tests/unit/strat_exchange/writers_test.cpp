// SPDX-License-Identifier: MIT
#include "strat/exchange/writer.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/uuid.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/real_data.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;
using namespace planum::strat;
using Catch::Matchers::Contains;

namespace {

/// A pit 12 in layer 13, with a level, an area and a phase.
model::Record small_record() {
    SeededUuids ids(1);
    model::Record record;
    record.settings.name = "Mill \"old\"";
    record.areas.push_back({model::AreaId{ids.next()}, "A", "", model::DigMethod::Stratigraphic, "", ""});
    model::Phase phase;
    phase.id = model::PhaseId{ids.next()};
    phase.number = "II";
    phase.from = -100;
    record.phases.push_back(phase);
    for (const char* number : {"12", "13"}) {
        model::StratigraphicUnit unit;
        unit.id = model::UnitId{ids.next()};
        unit.number = number;
        unit.area = record.areas[0].id;
        unit.kind = model::UnitKind::Cut;
        unit.title = "=SUM(A1)";
        record.units.push_back(unit);
    }
    record.units[1].kind = model::UnitKind::Deposit;
    record.units[0].phase = phase.id;
    model::PhysicalRelation relation;
    relation.id = model::RelationId{ids.next()};
    relation.subject = record.units[0].id;
    relation.kind = model::RelationKind::Cuts;
    relation.object = record.units[1].id;
    relation.certainty = model::Certainty::Uncertain;
    record.relations.push_back(relation);
    record.levels.push_back(
        {model::LevelId{ids.next()}, record.units[0].id, 1.5, std::nullopt, 12.34, model::LevelRole::Top, ""});
    return record;
}

const std::string& bytes_of(const Written& written, std::string_view name) {
    const auto it =
        std::find_if(written.files.begin(), written.files.end(), [&](const auto& f) { return f.name == name; });
    REQUIRE(it != written.files.end());
    return it->bytes;
}

bool says(const Written& written, std::string_view sentence) {
    return std::find(written.lost.begin(), written.lost.end(), sentence) != written.lost.end();
}

} // namespace

TEST_CASE("Our tables guard against formulas and may begin with a mark for spreadsheets") {
    WriteOptions options;
    options.delimiter = ';';
    options.byte_order_mark = true;
    const Written written = writer_for("planum-csv").write(small_record(), options);
    CHECK(bytes_of(written, "units.csv") ==
          "\xEF\xBB\xBFunit;area;kind;status;title;phase\n12;A;cut;open;'=SUM(A1);II\n"
          "13;A;deposit;open;'=SUM(A1);\n");
    CHECK(bytes_of(written, "relations.csv") ==
          "\xEF\xBB\xBFunit;area;relation;other;certainty\n12;A;cuts;13;uncertain\n");
    CHECK(bytes_of(written, "levels.csv") == "\xEF\xBB\xBFunit;area;z;role;x\n12;A;12.34;top;1.5\n");
    CHECK(written.lost.empty());
    CHECK(written.files.size() == 5);
}

TEST_CASE("A writer says in numbers what its format cannot carry") {
    const Written written = writer_for("lst").write(small_record(), {});
    CHECK(says(written, "units of a kind that the format does not know: 2"));
    CHECK(says(written, "relations cuts, fills and abuts written as above: 1"));
    CHECK(says(written, "relations not marked as uncertain: 1"));
    CHECK(says(written, "levels not written: 1"));
    CHECK(says(written, "units without their phase: 1"));
}

TEST_CASE("A .lst is Latin-1 with three lines of title and four keys a unit") {
    const Written written = writer_for("lst").write(small_record(), {});
    CHECK(written.files.at(0).bytes == "   Stratigraphic Dataset Mill \"old\"\r\n\r\n  Name\r\n"
                                       "12   =SUM(A1)\r\n            above: \r\n            contemporary with: \r\n"
                                       "            equal to: \r\n            below: 13\r\n"
                                       "13   =SUM(A1)\r\n            above: 12\r\n            contemporary with: \r\n"
                                       "            equal to: \r\n            below: \r\n");
}

TEST_CASE("GraphML has shapes with labels, data with uuids and one edge a relation") {
    const model::Record record = small_record();
    const std::string xml = writer_for("graphml").write(record, {}).files.at(0).bytes;
    CHECK_THAT(xml, Contains("<y:NodeLabel>12</y:NodeLabel>"));
    CHECK_THAT(xml, Contains("<data key=\"n_uuid\">" + record.units[0].id.to_string() + "</data>"));
    CHECK_THAT(xml, Contains("<edge id=\"e0\" source=\"n0\" target=\"n1\">") &&
                        Contains("<data key=\"e_relation\">cuts</data>"));
}

TEST_CASE("Graphviz reads what we write for it, whatever the names") {
    if (std::system("command -v dot >/dev/null") != 0) {
        WARN("SKIPPED: no dot");
        return;
    }
    model::Record record = small_record();
    record.units[0].number = "a\"b\\";
    record.units[1].title = "two\nlines \\";
    const test::TemporaryFolder folder;
    const auto path = folder.write("m.dot", writer_for("dot").write(record, {}).files.at(0).bytes);
    CHECK(std::system(fmt::format("dot -Tcanon '{}' >/dev/null", path.string()).c_str()) == 0);
}

TEST_CASE("JSON of a record keeps to its schema") {
    if (std::system("python3 -c 'import jsonschema' 2>/dev/null") != 0) {
        WARN("SKIPPED: no python3-jsonschema");
        return;
    }
    const test::TemporaryFolder folder;
    const auto path = folder.write("r.json", writer_for("json").write(small_record(), {}).files.at(0).bytes);
    const std::string command =
        fmt::format("python3 -c 'import json,sys,jsonschema; jsonschema.validate(json.load(open(sys.argv[1])), "
                    "json.load(open(sys.argv[2])))' '{}' '{}'",
                    path.string(), (test::source_folder() / "schema/json/record.schema.json").string());
    CHECK(std::system(command.c_str()) == 0);
}

TEST_CASE("An unknown format to write is a usage error that lists the formats") {
    CHECK_THROWS_WITH(writer_for("wordstar"), Contains("no format wordstar") && Contains("planum-csv"));
}
