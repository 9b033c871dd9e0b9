// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QSurfaceFormat>

namespace planum::gui {

/// What the 3D view draws with.
[[nodiscard]] QSurfaceFormat opengl_format();

/// Why there cannot be OpenGL here whatever the driver; empty where there can. Qt's platforms without a screen may well
/// hand out a context, yet none that a widget can draw with.
[[nodiscard]] QString display_trouble();

/// That the display offers only this version, 0.0 for none (SceneThread::unusable).
[[nodiscard]] QString opengl_trouble(int major, int minor);

} // namespace planum::gui
