// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace planum::strat {

/// Weight of the one typeface drawings use (DejaVu Sans).
enum class FontWeight { Regular, Bold };

/// How wide text will be when drawn. The layout asks through this so that it needs no fonts itself.
class TextMeasure {
  public:
    virtual ~TextMeasure() = default;

    /// Advance width [pt] of one line of UTF-8 text at a font size [pt].
    [[nodiscard]] virtual double width(std::string_view utf8, double size, FontWeight weight) const = 0;
};

/// Widths from a built-in table of DejaVu Sans (ASCII exactly, other letters by their mean): the same on
/// every machine, without any font installed.
class TableTextMeasure final : public TextMeasure {
  public:
    [[nodiscard]] double width(std::string_view utf8, double size, FontWeight weight) const override;
};

} // namespace planum::strat
