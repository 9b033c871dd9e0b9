// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <span>
#include <string_view>

class QWidget;

namespace planum::gui {

struct Models;

/// Where in the window a view stands.
enum class Place { Left, Centre, Right, Bottom };

/// One view of the window. Each is a set of files of its own (gui/widgets/NAME/) with its model beside the others
/// (gui/viewmodels/NAME_model); adding one means adding its line in views.cpp.
struct ViewEntry {
    std::string_view name;       ///< for --screenshot, settings and object names: `matrix`
    const char* title = nullptr; ///< English; translated in context `views`
    Place place = Place::Centre;
    const char* shortcut = nullptr; ///< brings it to the front
    QWidget* (*make)(Models& models) = nullptr;
};

/// All views in the order in which the window shows them.
[[nodiscard]] std::span<const ViewEntry> all_views() noexcept;

[[nodiscard]] QString view_title(const ViewEntry& view);

} // namespace planum::gui
