// SPDX-License-Identifier: MIT
#pragma once

#include <stop_token>
#include <string_view>

namespace planum {

/// How a long operation tells where it is and learns that it shall stop. The base class ignores
/// everything, so that tests and callers without an interest pass `Progress::none()`.
class Progress {
  public:
    Progress() = default;

    explicit Progress(std::stop_token token) : token_(std::move(token)) {}

    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    virtual ~Progress() = default;

    /// A new step with its name in plain words ("reading station1.ptx").
    virtual void step(std::string_view /*name*/) {}

    /// Share done of the current step, 0…1. Call at most ten times a second.
    virtual void fraction(double /*done*/) {}

    [[nodiscard]] const std::stop_token& stop_token() const noexcept { return token_; }

    /// Throws Error{Cancelled} when the user has asked to stop.
    void check() const;

    /// Ignores everything and never stops.
    [[nodiscard]] static Progress& none();

  private:
    std::stop_token token_;
};

} // namespace planum
