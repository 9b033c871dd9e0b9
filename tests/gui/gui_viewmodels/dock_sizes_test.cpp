// SPDX-License-Identifier: MIT
#include "gui/viewmodels/dock_sizes.hpp"

#include "tests/support/catch.hpp"

using namespace planum::gui;

TEST_CASE("Panels grow with the letters, so that as much is read at any size of them") {
    const DockSizes small = dock_sizes(8, 19, {4000, 3000});
    const DockSizes large = dock_sizes(16, 38, {4000, 3000});
    CHECK(large.units == 2 * small.units);
    CHECK(large.card == 2 * small.card);
    CHECK(large.below == 2 * small.below);
}

TEST_CASE("Large letters in a small window leave room for the middle") {
    const QSize tablet(1280, 800);
    const DockSizes sizes = dock_sizes(14, 32, tablet);
    CHECK(tablet.width() - sizes.units - sizes.card >= tablet.width() / 2);
    CHECK(tablet.height() - sizes.below >= tablet.height() * 2 / 3);
}
