// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "app/demo/simulator.hpp"

namespace planum::test {

/// For the eye: DIR/plan-DAY.ppm (shaded relief with the drawn outlines, 1 cm a pixel) and
/// DIR/STATION.pgm (intensity by column and row) of the first station of each day.
void write_demo_pictures(const app::demo::DemoDig& dig, const std::filesystem::path& folder);

} // namespace planum::test
