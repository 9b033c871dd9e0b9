// SPDX-License-Identifier: MIT
#include "app/demo/demo_job.hpp"

#include <string>

#include "core/base/error.hpp"
#include "tests/support/catch.hpp"

using namespace planum;

TEST_CASE("a large sample dig is refused where 11 GB would fill the disk", "[demo]") {
    CHECK_NOTHROW(app::require_room_for_demo(app::demo::DemoSize::Large, 20'000'000'000));
    CHECK_NOTHROW(app::require_room_for_demo(app::demo::DemoSize::Small, 200'000'000));
    try {
        app::require_room_for_demo(app::demo::DemoSize::Large, 10'999'000'000);
        FAIL("11 GB do not fit in less");
    } catch (const Error& refused) {
        CHECK(refused.code() == ErrorCode::Io);
        const std::string said = refused.what();
        CHECK(said.find("10999 MB free") != std::string::npos);
        CHECK(said.find("--size") != std::string::npos);
    }
}
