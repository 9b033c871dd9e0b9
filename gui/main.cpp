// SPDX-License-Identifier: MIT
#include "gui/desktop.hpp"
#include "strat/layout/layout_worker.hpp"

int main(int argc, char** argv) {
    if (const auto status = planum::strat::run_layout_worker_if_asked(argc, argv)) return *status;
    return planum::gui::run_desktop(argc, argv);
}
