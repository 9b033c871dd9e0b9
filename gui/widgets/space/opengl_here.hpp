// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QSurfaceFormat>

namespace planum::gui {

/// What the 3D view draws with.
[[nodiscard]] QSurfaceFormat opengl_format();

/// Why OpenGL 3.3 cannot be used here; empty where it can.
[[nodiscard]] QString opengl_trouble();

} // namespace planum::gui
