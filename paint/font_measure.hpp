// SPDX-License-Identifier: MIT
#pragma once

#include "strat/layout/text_measure.hpp"

namespace planum::paint {

/// Widths as the font will really draw them, unhinted, so that they scale.
class FontTextMeasure final : public strat::TextMeasure {
  public:
    FontTextMeasure();

    [[nodiscard]] double width(std::string_view utf8, double size, strat::FontWeight weight) const override;
};

} // namespace planum::paint
