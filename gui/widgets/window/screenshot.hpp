// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "gui/render/point_colour.hpp"

namespace planum::gui {

class MainWindow;

struct ScreenshotRequest {
    std::string view;                         ///< name of a view: what comes to the front
    std::string unit;                         ///< selected first; empty: none
    std::string problem;                      ///< code of the problem to open; empty: the first there is
    PointColour colour = PointColour::Colour; ///< of the points, in 3D
    std::filesystem::path output;
    int width = 1600; ///< [px]
    int height = 1000;
};

/// Waits until the window has done its work, brings the view to the front and writes a PNG. Problems are shown with
/// one open. Throws Usage for an unknown view (with those there are), NotFound for a unit or a problem that there is
/// not, and Io.
void write_screenshot(MainWindow& window, const ScreenshotRequest& request);

} // namespace planum::gui
