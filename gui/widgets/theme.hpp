// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QString>

#include <cstdint>

#include "gui/widgets/styled_parts.hpp"

namespace planum::gui {

/// How the window looks: on a desk by day, in the dark, or on a tablet in the sun (black on white, larger, no greys).
enum class ThemeKind { Light, Dark, Sunlight };

/// Colours and measures that widgets painting themselves use. Signs never rest on colour alone.
struct Theme {
    ThemeKind kind = ThemeKind::Light;
    QColor window;
    QColor paper; ///< ground of lists, forms and drawings
    QColor ink;
    QColor faint; ///< secondary text; still 4.5 : 1 on paper
    QColor off;   ///< what cannot be pressed or typed into
    QColor edge;  ///< lines between things
    QColor accent;
    QColor on_accent;
    QColor error;
    QColor warning;
    QColor remark;
    double text_points = 10.0;
    int touch = 30; ///< least height of what is pressed [px]

    /// A colour of a drawing made for white paper, as this theme shows it.
    [[nodiscard]] QColor drawn(std::uint32_t rgb) const;

    /// Lines are at least this strong [px].
    [[nodiscard]] double least_line() const noexcept { return kind == ThemeKind::Sunlight ? 1.5 : 0.0; }
};

[[nodiscard]] const Theme& theme() noexcept;

/// Sets palette, font and style of the whole program. Before that, theme() is the light one.
void apply_theme(ThemeKind kind, StyledParts::Pace pace = StyledParts::Pace::AtOnce);

[[nodiscard]] QString to_word(ThemeKind kind);
[[nodiscard]] ThemeKind theme_from_word(const QString& word) noexcept;

} // namespace planum::gui
