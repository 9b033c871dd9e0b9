// SPDX-License-Identifier: MIT
#include "tests/support/catch.hpp"
#include "tests/unit/core_store/filled_project.cpp"
#include "tests/unit/core_store/kill_rounds.cpp"

TEST_CASE("A project survives being killed in the middle of an import, 200 times") {
    planum::test::kill_during_imports(200);
}
