// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>

#include "strat/layout/drawing.hpp"
#include "tests/support/catch.hpp"

namespace planum::test {

/// The box of a unit; the test fails where there is none.
inline const strat::DrawnBox& box_named(const strat::MatrixDrawing& drawing, const std::string& name) {
    const auto at = std::find_if(drawing.boxes.begin(), drawing.boxes.end(), [&](const strat::DrawnBox& b) {
        return std::find(b.names.begin(), b.names.end(), name) != b.names.end();
    });
    REQUIRE(at != drawing.boxes.end());
    return *at;
}

} // namespace planum::test
