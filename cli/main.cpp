// SPDX-License-Identifier: MIT
#include <csignal>
#include <iostream>
#include <string>
#include <vector>

#include "cli/context.hpp"
#include "core/base/error.hpp"
#include "strat/layout/layout_worker.hpp"

int main(int argc, char** argv) {
    if (const auto status = planum::strat::run_layout_worker_if_asked(argc, argv)) return *status;
    // A file over the limit set for its size is then an error that is told, as a full disk is, and cleaned up after.
    std::signal(SIGXFSZ, SIG_IGN);
    std::ios::sync_with_stdio(false);
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const int status = planum::cli::run_command_line(arguments, std::cout, std::cerr);
    std::cout.flush();
    if (std::cout || status > 1) return status;
    // Whoever reads the output must not take a part of it for all.
    std::cerr << "planum: the output could not be written in full; is the disk full?\n";
    return planum::exit_status(planum::ErrorCode::Io);
}
