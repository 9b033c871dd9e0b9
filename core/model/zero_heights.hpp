// SPDX-License-Identifier: MIT
#pragma once

#include "core/model/record.hpp"

namespace planum::model {

/// Outlines of surfaces whose every z is exactly 0 lose their heights unless there is ground at 0: files of schema
/// version 3 and older, and programs that draw in plan, have zeros where nobody said a height. There is ground at 0
/// where 0 lies among the heights of the other outlines of the surface, with half a metre to spare; where these say
/// nothing, among those of all outlines and levels and of the ground below all set-ups of the scanner.
void forget_zero_heights(Record& record);

} // namespace planum::model
