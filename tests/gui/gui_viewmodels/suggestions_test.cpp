// SPDX-License-Identifier: MIT
#include "gui/viewmodels/suggestion_list_model.hpp"

#include <fmt/format.h>

#include "app/suggestions/suggestions.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"

using namespace planum;
using namespace planum::gui;

TEST_CASE("A hundred surfaces that say nothing for the same reason are one line, with their number") {
    test::ensure_core_application();
    std::vector<app::UnusedSurface> unused;
    for (int i = 1; i <= 100; ++i) unused.push_back({fmt::format("2025-06-{:03}", i), "no scans"});
    unused.insert(unused.begin() + 1, {"2025-05-01", "no outlines"});
    const QStringList lines = lines_of_unused(unused);
    REQUIRE(lines.size() == 2);
    CHECK(lines[0].startsWith(QStringLiteral("2025-06-001, 2025-06-002, 2025-06-003")));
    CHECK(lines[0].contains(QStringLiteral("94 more")));
    CHECK(lines[0].endsWith(QStringLiteral(": no scans")));
    CHECK(lines[1] == QStringLiteral("2025-05-01: no outlines"));
    CHECK(lines_of_unused({}).isEmpty());
}
