// SPDX-License-Identifier: MIT
#include "tests/support/catch.hpp"
#include "tests/unit/core_store/kill_rounds.hpp"

TEST_CASE("A project survives being killed in the middle of an import, ten times") {
    planum::test::kill_during_imports(10);
}
