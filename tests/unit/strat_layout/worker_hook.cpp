// SPDX-License-Identifier: MIT
// The engine starts its own executable again; in tests that is the test program, whose main belongs to
// Catch2, so the worker is asked for before main.
#include <unistd.h>

#include <cstdio>
#include <string>
#include <vector>

#include "strat/layout/layout_worker.hpp"

namespace {

struct WorkerHook {
    WorkerHook() {
        std::FILE* file = std::fopen("/proc/self/cmdline", "rb");
        if (file == nullptr) return;
        std::vector<char> bytes(4096);
        const std::size_t size = std::fread(bytes.data(), 1, bytes.size() - 1, file);
        std::fclose(file);
        std::vector<const char*> arguments;
        for (std::size_t at = 0; at < size; at += std::string(&bytes[at]).size() + 1) arguments.push_back(&bytes[at]);
        const auto status =
            planum::strat::run_layout_worker_if_asked(static_cast<int>(arguments.size()), arguments.data());
        if (status) _exit(*status);
    }
};

const WorkerHook hook;

} // namespace
