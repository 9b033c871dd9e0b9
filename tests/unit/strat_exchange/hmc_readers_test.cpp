// SPDX-License-Identifier: MIT
#include <array>

#include "core/base/error.hpp"
#include "strat/exchange/zip_archive.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strat_exchange/support.hpp"

using namespace planum;
using namespace planum::strat;
using Catch::Matchers::Contains;

namespace {

using Texts = std::vector<std::string>;

std::string failure(const InputFile& file, std::string_view format) {
    try {
        (void)test::read_all({file}, format);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

} // namespace

TEST_CASE("HMC XML: nested groups are period and phase, edges are found in every graph") {
    const auto read = test::read_all(test::sample("hmcx/small.matrix.xml"));
    const ImportedRecord& record = read.values;
    REQUIRE(record.units.size() == 3);
    CHECK(record.units[0].name.number == "12");
    CHECK(record.units[0].values.title == "floor & bench");
    CHECK(record.units[0].phase == "H");
    CHECK(record.units[0].period == "P");
    CHECK(record.units[1].values.kind == model::UnitKind::Interface);
    CHECK(record.units[2].values.kind == model::UnitKind::Natural);
    REQUIRE(record.phases.size() == 1);
    CHECK(record.phases[0].values.title == "House");
    CHECK(record.phases[0].values.description == "one room");
    CHECK(record.phases[0].period == "P");
    REQUIRE(record.periods.size() == 1);
    CHECK(record.periods[0].title == "Roman");
    CHECK(test::relations_of(record) == Texts{"12 later 13", "11 covers 12", "11 contemporary 13"});
    CHECK(test::notes_of(read.diagnostics) == Texts{"small.matrix.xml:11 unparsed",
                                                    "small.matrix.xml:0 marked-incomplete",
                                                    "small.matrix.xml:14 group-relation"});
}

TEST_CASE("An .hmcx is a zip of project.xml and matrix.xml") {
    const std::string matrix = test::sample("hmcx/small.matrix.xml").front().bytes;
    const std::array<std::pair<std::string, std::string>, 2> members = {
        std::pair{"project.xml", "<ProjectProperties Name=\"Mill\" Description=\"\" ExcavationSite=\"Ford\"/>"},
        std::pair{"matrix.xml", matrix}};
    const std::vector files = {test::a_file("mill.hmcx", write_zip(members))};
    CHECK(test::format_of(files) == "hmcx");
    const auto read = test::read_all(files);
    CHECK(read.values.project_name == "Mill");
    CHECK(read.values.units.size() == 3);
}

TEST_CASE("A zip that unpacks to far more than it is is refused") {
    const std::array<std::pair<std::string, std::string>, 1> members = {
        std::pair{std::string{"matrix.xml"}, std::string(std::size_t{40} << 20U, ' ')}};
    const std::string bytes = write_zip(members);
    CHECK(bytes.size() < 100'000);
    CHECK_THAT(failure(test::a_file("bomb.hmcx", bytes), "hmcx"),
               Contains("bomb.hmcx: matrix.xml in the archive unpacks"));
}

TEST_CASE("A DOCTYPE is refused, so that no entity can grow") {
    const std::string xml = "<?xml version=\"1.0\"?>\n<!DOCTYPE x [<!ENTITY a \"b\">]>\n<x><hmcnode id=\"&a;\"/></x>";
    CHECK_THAT(failure(test::a_file("evil.xml", xml), "hmcx"), Contains("evil.xml: line 2: a DOCTYPE is not accepted"));
}

TEST_CASE("Deeply nested XML is walked without recursion") {
    std::string xml = "<graphml>";
    for (int i = 0; i < 200'000; ++i) xml += "<graph><node>";
    xml += "<data><hmcnode id='1' type='DEPOSIT'/></data>";
    for (int i = 0; i < 200'000; ++i) xml += "</node></graph>";
    xml += "</graphml>";
    CHECK(test::read_all({test::a_file("deep.xml", xml)}, "hmcx").values.units.size() == 1);
}

TEST_CASE("HMC CSV: ABOVE lists what the unit is above, groups hold units") {
    const auto read = test::read_all(test::sample("hmc-csv/small.csv"));
    CHECK(read.values.project_name == "Mill");
    REQUIRE(read.values.units.size() == 3);
    CHECK(read.values.units[0].values.description == "floor");
    CHECK(read.values.units[0].phase == "B. 1");
    CHECK(read.values.units[1].values.kind == model::UnitKind::Interface);
    CHECK(test::relations_of(read.values) == Texts{"12 covers 13", "12 covers 14", "11 covers 12", "12 contemporary 15",
                                                   "11 covers 12", "11 later 16", "12 covers 13"});
    CHECK(test::notes_of(read.diagnostics) == Texts{"small.csv:0 marked-incomplete"});
}
