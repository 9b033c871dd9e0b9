// SPDX-License-Identifier: MIT
#include "scans/formats/gps_time.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

namespace planum::scans {

namespace {

// GPS seconds at which each leap second since 1980 was over (IERS Bulletin C; none since 2017).
constexpr std::array<std::int64_t, 18> kLeapSeconds = {
    46828801,  78364802,  109900803, 173059204, 252028805, 315187206, 346723207,  393984008,  425520009,
    457056010, 504489611, 551750412, 599184013, 820108814, 914803215, 1025136016, 1119744017, 1167264018};

constexpr std::int64_t kGpsStartInUnix = 315964800; // 1980-01-06

std::string iso_date(std::chrono::sys_days day) {
    const std::chrono::year_month_day date{day};
    return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                       static_cast<unsigned>(date.day()));
}

} // namespace

std::string iso_time_of_gps(double gps_seconds) {
    constexpr double kYear2200 = 220.0 * 366.0 * 86400.0;
    if (!(gps_seconds > 0.0 && gps_seconds < kYear2200)) return {};
    const auto whole = static_cast<std::int64_t>(std::floor(gps_seconds));
    std::int64_t leap = 0;
    for (const std::int64_t when : kLeapSeconds) {
        if (whole >= when) ++leap;
    }
    const std::chrono::sys_seconds time{std::chrono::seconds{kGpsStartInUnix + whole - leap}};
    const std::chrono::sys_days day = std::chrono::floor<std::chrono::days>(time);
    const std::int64_t second = (time - day).count();
    return fmt::format("{}T{:02}:{:02}:{:02}Z", iso_date(day), second / 3600, second / 60 % 60, second % 60);
}

std::string iso_date_of_year_day(int year, int day_of_year) {
    if (year < 1980 || year > 2200 || day_of_year < 1 || day_of_year > 366) return {};
    const std::chrono::sys_days first{std::chrono::year{year} / std::chrono::January / 1};
    return iso_date(first + std::chrono::days{day_of_year - 1});
}

} // namespace planum::scans
