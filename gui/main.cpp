// SPDX-License-Identifier: MIT
#include <csignal>

#include "gui/desktop.hpp"
#include "strat/layout/layout_worker.hpp"

int main(int argc, char** argv) {
    if (const auto status = planum::strat::run_layout_worker_if_asked(argc, argv)) return *status;
    // A file over the limit set for its size is then an error that is told, as a full disk is.
    std::signal(SIGXFSZ, SIG_IGN);
    return planum::gui::run_desktop(argc, argv);
}
