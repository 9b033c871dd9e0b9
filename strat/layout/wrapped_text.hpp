// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "strat/layout/text_measure.hpp"

namespace planum::strat {

/// How a text is set: size [pt] and weight.
struct TextLook {
    double size = 9.0;
    FontWeight weight = FontWeight::Regular;
};

/// The text, cut off with an ellipsis where it is wider than `width` [pt].
[[nodiscard]] std::string shortened(std::string_view text, double width, TextLook look, const TextMeasure& measure);

/// The words in lines of at most `width` [pt], a word that is wider alone cut off; what does not fit into
/// `most_lines` ends in an ellipsis. Empty for text without words.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, double width, std::size_t most_lines,
                                               TextLook look, const TextMeasure& measure);

/// Like shortened(), but what is left out is in the middle: names that begin alike differ at their ends.
[[nodiscard]] std::string shortened_inside(std::string_view text, double width, TextLook look,
                                           const TextMeasure& measure);

/// All of the text in lines of at most `width` [pt], broken behind a blank or a sign where one stands in its
/// second half, else between any two letters. One line at least.
[[nodiscard]] std::vector<std::string> broken_anywhere(std::string_view text, double width, TextLook look,
                                                       const TextMeasure& measure);

} // namespace planum::strat
