// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace planum {

/// Where "now" comes from. Injected, so that tests and golden files repeat themselves.
class Clock {
  public:
    virtual ~Clock() = default;

    /// UTC as `2025-06-01T17:04:05.123Z`, the form GeoPackage asks for.
    [[nodiscard]] virtual std::string now() const = 0;
};

class SystemClock final : public Clock {
  public:
    [[nodiscard]] std::string now() const override;
};

class FixedClock final : public Clock {
  public:
    explicit FixedClock(std::string time) : time_(std::move(time)) {}

    [[nodiscard]] std::string now() const override { return time_; }

  private:
    std::string time_;
};

} // namespace planum
