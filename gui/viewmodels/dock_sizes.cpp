// SPDX-License-Identifier: MIT
#include "gui/viewmodels/dock_sizes.hpp"

#include <algorithm>

namespace planum::gui {

namespace {

constexpr int kUnitsDigits = 48; // a number, a kind and a definition
constexpr int kCardDigits = 47;  // the name of a field and its value
constexpr int kLinesBelow = 18;

} // namespace

DockSizes dock_sizes(int digit, int line, QSize window) {
    return {std::min(kUnitsDigits * digit, window.width() / 4), std::min(kCardDigits * digit, window.width() / 4),
            std::min(kLinesBelow * line, window.height() * 3 / 10)};
}

} // namespace planum::gui
