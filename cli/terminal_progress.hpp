// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <ostream>
#include <stop_token>
#include <string>

#include "core/base/progress.hpp"

namespace planum::cli {

/// One line on a terminal that says what is being done, how far it is and how long it will take; nothing
/// where stderr is no terminal, and nothing in the first second of a command.
class TerminalProgress final : public Progress {
  public:
    TerminalProgress(std::ostream& err, bool visible, std::stop_token token);
    ~TerminalProgress() override;

    void step(std::string_view name) override;
    void fraction(double done) override;

  private:
    void wipe();

    std::ostream& err_;
    bool visible_;
    bool shown_ = false;
    std::string name_;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
    std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
    std::chrono::steady_clock::time_point last_ = began_;
};

/// A stop source that Ctrl-C asks to stop; a second Ctrl-C ends the program at once.
[[nodiscard]] std::stop_source& stop_on_interrupt();

} // namespace planum::cli
