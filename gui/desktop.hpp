// SPDX-License-Identifier: MIT
#pragma once

namespace planum::gui {

/// The program `planum-desktop`: reads its arguments, opens the window, runs until it is closed. Returns the exit
/// status of DESIGN 5.
int run_desktop(int argc, char** argv);

} // namespace planum::gui
