// SPDX-License-Identifier: MIT
#include "app/project/project.hpp"

#include <string>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/record_builder.hpp"

using namespace planum;

TEST_CASE("Numbers one slip of the hand away are offered, and no others") {
    auto builder = test::a_record();
    for (const char* number : {"1042", "1024", "104", "10422", "1043", "2042", "9999", "1402"}) builder.unit(number);
    const auto record = builder.record();
    CHECK(app::near_numbers(record, "1042", 10) ==
          std::vector<std::string>{"104", "1024", "1043", "1402", "2042", "10422"});
    CHECK(app::near_numbers(record, "1042", 2).size() == 2);
    CHECK(app::near_numbers(record, "7", 5).empty());
}
