// SPDX-License-Identifier: MIT
#include "gui/widgets/space/opengl_here.hpp"

#include <QGuiApplication>

#include "gui/widgets/space/space_canvas.hpp"

namespace planum::gui {

QSurfaceFormat opengl_format() {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    return format;
}

QString display_trouble() {
    const QString platform = QGuiApplication::platformName();
    if (platform != QLatin1String("offscreen") && platform != QLatin1String("minimal")) return {};
    return SpaceCanvas::tr("The 3D view needs a display; the program runs without one (%1). All other views work.")
        .arg(platform);
}

QString opengl_trouble(int major, int minor) {
    if (major == 0) {
        return SpaceCanvas::tr(
            "The 3D view needs OpenGL 3.3, which this display does not offer. All other views work.");
    }
    return SpaceCanvas::tr("The 3D view needs OpenGL 3.3; there is %1.%2 here. All other views work.")
        .arg(major)
        .arg(minor);
}

} // namespace planum::gui
