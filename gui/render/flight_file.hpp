// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gui/render/camera.hpp"

namespace planum::gui {

/// `NAME.flight.json` beside the project NAME.gpkg.
[[nodiscard]] std::filesystem::path flight_file_of(const std::filesystem::path& project);

/// The cameras of a flight as JSON (docs/formats/flight.md): places to a tenth of a millimetre, angles to a millionth
/// of a degree, so that what was read is written as it was.
[[nodiscard]] std::string flight_text(const std::vector<Camera>& cameras);

/// Throws BadInput with line or camera where `text` is no such JSON; at most kMostCameras.
[[nodiscard]] std::vector<Camera> flight_from(const std::string& text);

/// As flight_from(), of a file, named in whatever is thrown: NotFound, BadInput or Io.
[[nodiscard]] std::vector<Camera> read_flight(const std::filesystem::path& file);

inline constexpr std::size_t kMostCameras = 1000;

} // namespace planum::gui
