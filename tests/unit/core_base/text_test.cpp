// SPDX-License-Identifier: MIT
#include "core/base/text.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/catch.hpp"

using namespace planum;

TEST_CASE("Natural order counts as people do") {
    std::vector<std::string> numbers = {"12a", "9", "10", "B. 36", "12", "b. 9", "", "1297+", "01", "1"};
    std::sort(numbers.begin(), numbers.end(), text::NaturalLess{});
    CHECK(numbers == std::vector<std::string>{"", "01", "1", "9", "10", "12", "12a", "1297+", "b. 9", "B. 36"});
}

TEST_CASE("Natural order compares numbers longer than any integer type") {
    CHECK(text::NaturalLess{}("99999999999999999999999", "100000000000000000000000"));
    CHECK(text::NaturalLess{}("00000000000000000000000000001", "2"));
}

TEST_CASE("Windows-1252 and Latin-1 become UTF-8 and go back") {
    CHECK(text::from_latin1("Gr\xE4"
                            "ber \x80") == "Gräber €");
    std::size_t lost = 0;
    CHECK(text::to_latin1("Gräber", &lost) == "Gr\xE4"
                                              "ber");
    CHECK(lost == 0);
    CHECK(text::to_latin1("Ωx", &lost) == "?x");
    CHECK(lost == 1);
}

TEST_CASE("Control characters and broken UTF-8 are replaced and counted") {
    const text::Cleaned cleaned = text::clean_utf8(std::string_view("a\r\nb\x01"
                                                                    "c\xFF"
                                                                    "d\te\r",
                                                                    10));
    CHECK(cleaned.text == "a\nb\xEF\xBF\xBD"
                          "c\xEF\xBF\xBD"
                          "d\te");
    CHECK(cleaned.replaced == 2);
    CHECK(text::clean_utf8("x\ry").text == "x\ny");
}

TEST_CASE("Names stand on one line and turn no direction") {
    const text::Cleaned name = text::on_one_line(" A\u202e12\n3\t4\u2028\x01\r\n");
    CHECK(name.text == "A\uFFFD12 3 4 \uFFFD");
    CHECK(name.replaced == 5);
    CHECK(text::on_one_line("16/9 ö 日").replaced == 0);
}

TEST_CASE("Overlong forms, surrogates and codes beyond Unicode are not valid UTF-8") {
    CHECK(text::is_valid_utf8("Käse €"));
    CHECK_FALSE(text::is_valid_utf8("\xC0\xAF"));
    CHECK_FALSE(text::is_valid_utf8("\xED\xA0\x80"));
    CHECK_FALSE(text::is_valid_utf8("\xF4\x90\x80\x80"));
    CHECK_FALSE(text::is_valid_utf8("\xE2\x82"));
}

TEST_CASE("Case folds in four languages") {
    CHECK(text::fold_case("LIEGT ÜBER") == "liegt über");
    CHECK(text::fold_case("Coupée Par ŒÀÉ") == "coupée par œàé");
}

TEST_CASE("Decimal comma and point both make numbers, anything else none") {
    CHECK(text::parse_double(" 12,5 ").value() == Approx(12.5));
    CHECK(text::parse_double("-0.25").value() == Approx(-0.25));
    CHECK_FALSE(text::parse_double("12 m").has_value());
    CHECK_FALSE(text::parse_double("").has_value());
    CHECK(text::parse_integer("+7").value() == 7);
    CHECK_FALSE(text::parse_integer("7.0").has_value());
}

TEST_CASE("One thing is counted in the singular") {
    CHECK(text::counted(0, "unit") == "0 units");
    CHECK(text::counted(1, "unit") == "1 unit");
    CHECK(text::counted(std::size_t{2}, "unit") == "2 units");
    CHECK(text::counted(1, "box", "boxes") == "1 box");
    CHECK(text::counted(3, "box", "boxes") == "3 boxes");
}
