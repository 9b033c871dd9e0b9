// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace planum::scans {

/// GPS seconds (since 1980-01-06, without leap seconds) as UTC `2011-08-05T12:27:27Z`; empty for 0 and
/// for what is no time between 1980 and 2200.
[[nodiscard]] std::string iso_time_of_gps(double gps_seconds);

/// Day `day_of_year` (from 1) of a year as `2011-08-05`; empty when it is none.
[[nodiscard]] std::string iso_date_of_year_day(int year, int day_of_year);

} // namespace planum::scans
