// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>

#include "gui/widgets/space/flight_frames.hpp"
#include "gui/widgets/theme.hpp"
#include "gui/widgets/window/screenshot.hpp"

namespace planum::gui {

/// What `planum-desktop` was called with.
struct DesktopArguments {
    QString site;
    ScreenshotRequest screenshot; ///< where a view is named
    FlightRequest flight;         ///< where cameras are named
    ThemeKind theme = ThemeKind::Light;
    QString language; ///< `de`; empty: as chosen in the window, else the system's
    bool read_only = false;
    bool help = false;
    bool version = false;
    QString help_text;
};

/// Throws Usage.
[[nodiscard]] DesktopArguments read_desktop_arguments(const QStringList& given);

} // namespace planum::gui
