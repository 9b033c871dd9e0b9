// SPDX-License-Identifier: MIT
#include "core/base/clock.hpp"

#include <chrono>
#include <ctime>

#include <fmt/format.h>

namespace planum {

std::string SystemClock::now() const {
    using namespace std::chrono;
    const auto since_epoch = system_clock::now().time_since_epoch();
    const auto ms = duration_cast<milliseconds>(since_epoch).count();
    const std::time_t seconds = static_cast<std::time_t>(ms / 1000);
    std::tm utc{};
    gmtime_r(&seconds, &utc);
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday,
                       utc.tm_hour, utc.tm_min, utc.tm_sec, ms % 1000);
}

} // namespace planum
