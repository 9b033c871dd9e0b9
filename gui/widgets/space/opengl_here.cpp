// SPDX-License-Identifier: MIT
#include "gui/widgets/space/opengl_here.hpp"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include <utility>

#include "gui/widgets/space/space_canvas.hpp"

namespace planum::gui {

QSurfaceFormat opengl_format() {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    return format;
}

QString opengl_trouble() {
    // Qt's platforms without a screen may well hand out a context, yet none that a widget can draw with.
    if (const QString platform = QGuiApplication::platformName();
        platform == QLatin1String("offscreen") || platform == QLatin1String("minimal")) {
        return SpaceCanvas::tr("The 3D view needs a display; the program runs without one (%1). All other views work.")
            .arg(platform);
    }
    QOffscreenSurface surface;
    surface.setFormat(opengl_format());
    surface.create();
    QOpenGLContext context;
    context.setFormat(opengl_format());
    if (!context.create() || !context.makeCurrent(&surface)) {
        return SpaceCanvas::tr(
            "The 3D view needs OpenGL 3.3, which this display does not offer. All other views work.");
    }
    const auto version = context.format().version();
    context.doneCurrent();
    if (version < std::pair(3, 3)) {
        return SpaceCanvas::tr("The 3D view needs OpenGL 3.3; there is %1.%2 here. All other views work.")
            .arg(version.first)
            .arg(version.second);
    }
    return {};
}

} // namespace planum::gui
