// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "gui/render/point_colour.hpp"

namespace planum::gui {

struct Models;

struct FlightRequest {
    std::filesystem::path cameras; ///< as FlightCameras keeps them
    std::filesystem::path folder;  ///< made where it is not there
    std::string surface;           ///< whose scans are seen; empty: the last one, `all`: of all
    PointColour colour = PointColour::Colour;
    int frames = 50;  ///< from each camera to the next
    int width = 1600; ///< [px]
    int height = 1000;
};

/// Flies over the project that is open, without its window, and writes the frames as the window does. Returns their
/// number; `said` hears of each. Throws BadInput where cameras or scans are missing or no such, NotFound for a surface
/// that there is not, Io where there is no OpenGL or the disk refuses.
int write_flight(Models& models, const FlightRequest& request, const std::function<void(int written, int all)>& said);

} // namespace planum::gui
