// SPDX-License-Identifier: MIT
#include "core/base/calendar.hpp"

#include "tests/support/catch.hpp"

using planum::is_day;

TEST_CASE("A day is one of the calendar, written in full and nothing else") {
    for (const char* day : {"2025-06-01", "2024-02-29", "2000-02-29", "1999-12-31"}) CHECK(is_day(day));
    for (const char* none : {"", "2025-6-1", "2025-02-29", "1900-02-29", "2025-06-31", "2025-13-01", "2025-00-10",
                             "2025-06-00", "2025/06/01", "2025-06-01 ", "20250601", "June"}) {
        CHECK_FALSE(is_day(none));
    }
}
