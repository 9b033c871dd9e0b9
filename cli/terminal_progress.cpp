// SPDX-License-Identifier: MIT
#include "cli/terminal_progress.hpp"

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

namespace planum::cli {

using namespace std::chrono_literals;

TerminalProgress::TerminalProgress(std::ostream& err, bool visible, std::stop_token token)
    : Progress(std::move(token)), err_(err), visible_(visible) {}

TerminalProgress::~TerminalProgress() { wipe(); }

void TerminalProgress::step(std::string_view name) {
    name_ = name;
    began_ = std::chrono::steady_clock::now();
    wipe();
}

void TerminalProgress::fraction(double done) {
    const auto now = std::chrono::steady_clock::now();
    if (!visible_ || now - started_ < 1s || now - last_ < 100ms) return;
    last_ = now;
    const double spent = std::chrono::duration<double>(now - began_).count();
    const double left = done > 0.01 ? spent / done - spent : 0.0;
    const std::string time = done > 0.01 ? fmt::format(", about {:.0f} s left", left) : "";
    err_ << fmt::format("\r\x1b[K{} … {:.0f} %{}", name_, 100.0 * done, time) << std::flush;
    shown_ = true;
}

void TerminalProgress::wipe() {
    if (shown_) err_ << "\r\x1b[K" << std::flush;
    shown_ = false;
}

namespace {

std::atomic<int> interrupts = 0;

} // namespace

std::stop_source& stop_on_interrupt() {
    static std::stop_source source;
    // The handler may only count: asking the source to stop takes locks. A thread that does nothing else
    // carries the request over.
    static std::jthread carrier([](const std::stop_token& ended) {
        while (!ended.stop_requested()) {
            if (interrupts > 0) source.request_stop();
            std::this_thread::sleep_for(50ms);
        }
    });
    std::signal(SIGINT, [](int) {
        if (++interrupts > 1) _exit(130);
    });
    return source;
}

} // namespace planum::cli
