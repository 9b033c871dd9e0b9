// SPDX-License-Identifier: MIT
#include "strat/exchange/delimited_table.hpp"

#include <string>

#include "core/base/text.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using namespace planum::strat;

namespace {

using Cells = std::vector<std::string>;

DelimitedTable parse(std::string_view bytes) { return parse_table(bytes, "t.csv"); }

} // namespace

TEST_CASE("Comma, semicolon, tab and bar are found by themselves") {
    CHECK(parse("unit,title\n1,floor\n").delimiter == ',');
    CHECK(parse("unit;title\n1;floor, burnt\n2;pit, round, deep\n").delimiter == ';');
    CHECK(parse("unit\ttitle\n1\ta, b\n").delimiter == '\t');
    CHECK(parse("unit|title\n1|a\n").delimiter == '|');
    CHECK(parse("ABOVE;BELOW\n\"1,2\";\"3,4\"\n").delimiter == ';');
    CHECK(parse("unit\n1\n").delimiter == ',');
}

TEST_CASE("Quotes hold delimiters, line ends, doubled quotes and blanks") {
    const DelimitedTable table = parse("unit,title\r\n 1 ,\"a \"\"b\"\", c\r\nd \"\r\n2,\" 16/9\"\r\n");
    REQUIRE(table.rows.size() == 3);
    CHECK(table.rows[1].cells == Cells{"1", "a \"b\", c\nd "});
    CHECK(table.rows[1].line == 2);
    CHECK(table.rows[2].cells == Cells{"2", " 16/9"});
    CHECK(table.rows[2].line == 4);
    CHECK(table.notes.empty());
}

TEST_CASE("A quote that never closes is a character, and is reported with its line") {
    const DelimitedTable table = parse("unit,title\n1,5\" pipe\n2,\"open\n3,c\n");
    REQUIRE(table.rows.size() == 4);
    CHECK(table.rows[1].cells == Cells{"1", "5\" pipe"});
    CHECK(table.rows[2].cells == Cells{"2", "\"open"});
    CHECK(table.rows[3].cells == Cells{"3", "c"});
    REQUIRE(table.notes.size() == 1);
    CHECK(table.notes[0].line == 3);
    CHECK(table.notes[0].code == "open-quote");
}

TEST_CASE("Windows-1252, UTF-16 and UTF-8 with its mark become the same text") {
    CHECK(parse("unit\nGr\xE4"
                "ber\n")
              .rows[1]
              .cells == Cells{"Gräber"});
    CHECK(parse("unit\nGr\xE4"
                "ber\n")
              .encoding == "windows-1252");
    CHECK(parse("\xEF\xBB\xBFunit\nGräber\n").rows[0].cells == Cells{"unit"});
    const std::string little("\xFF\xFE"
                             "a\0,\0\xE4\0\n\0",
                             10);
    CHECK(parse(little).rows[0].cells == Cells{"a", "ä"});
    const std::string big("\xFE\xFF"
                          "\0a\0,\0\xE4\0\n\xD8",
                          11);
    CHECK(parse(big).rows[0].cells == Cells{"a", "ä"});
    CHECK(parse(big).notes.size() == 1);
}

TEST_CASE("UTF-8 cut off within a letter stays UTF-8") {
    const DelimitedTable table = parse("unit,title\n1,Grä\n2,Gr\xC3");
    CHECK(table.encoding == "utf-8");
    CHECK(table.rows[1].cells == Cells{"1", "Grä"});
    CHECK(table.notes.size() == 1);
}

TEST_CASE("A row of endless cells and a table without end are cut, and that is said") {
    const DelimitedTable table = parse("a,b\n" + std::string(100'000, ',') + "\n1,2\n");
    REQUIRE(table.rows.size() == 3);
    CHECK(table.rows[1].cells.size() == 2000);
    CHECK(table.rows[2].cells == Cells{"1", "2"});
    CHECK(table.notes.size() == 1);
}

TEST_CASE("Excel's sep line names the delimiter and is no row") {
    const DelimitedTable table = parse("sep=;\nunit;title\n1;a,b\n");
    REQUIRE(table.rows.size() == 2);
    CHECK(table.rows[0].cells == Cells{"unit", "title"});
    CHECK(table.rows[0].line == 2);
}

TEST_CASE("Header names are found without regard to case, blanks and hyphens") {
    const TableHeader header({1, {"Unit-Type", " Site Code ", "Größe"}});
    CHECK(header.find("unit_type") == 0U);
    CHECK(header.find("site_code") == 1U);
    CHECK(header.find("größe") == 2U);
    CHECK_FALSE(header.has("unit"));
    const std::string_view names[] = {"code", "site_code"};
    CHECK(header.find_any(names) == 1U);
    CHECK(cell({1, {"a"}}, 3U).empty());
}

TEST_CASE("Written rows are read back, and no cell is a formula to a spreadsheet") {
    const Cells cells = {"=1+2", "'=x", "-5", "+", "a;b", "c \"d\"", " e ", "f\ng", "", "'s"};
    RowWriter writer{';', "\r\n", false, true};
    const std::string line = writer.write(cells);
    CHECK(line == "'=1+2;''=x;-5;'+;\"a;b\";\"c \"\"d\"\"\";\" e \";\"f\ng\";;'s\r\n");
    const DelimitedTable table = parse_table(line, "t", {';', {}});
    CHECK(table.rows[0].cells == Cells{"'=1+2", "''=x", "-5", "'+", "a;b", "c \"d\"", " e ", "f\ng", "", "'s"});
}
