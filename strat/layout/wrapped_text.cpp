// SPDX-License-Identifier: MIT
#include "strat/layout/wrapped_text.hpp"

#include <utility>

#include "core/base/text.hpp"

namespace planum::strat {

std::string shortened(std::string_view text, double width, TextLook look, const TextMeasure& measure) {
    constexpr std::string_view kEllipsis = "…";
    const auto fits = [&](const std::string& s) { return measure.width(s, look.size, look.weight) <= width; };
    const std::string whole(text);
    if (fits(whole)) return whole;
    std::vector<std::size_t> ends; // of characters
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (i > 0 && (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) ends.push_back(i);
    }
    const auto cut = [&](std::size_t count) {
        std::string_view kept = count == 0 ? std::string_view{} : text.substr(0, ends[count - 1]);
        while (kept.ends_with(' ')) kept.remove_suffix(1);
        return std::string(kept) + std::string(kEllipsis);
    };
    std::size_t low = 0; // characters that fit with the ellipsis
    std::size_t high = ends.size();
    while (low < high) {
        const std::size_t middle = (low + high + 1) / 2;
        if (fits(cut(middle))) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    return cut(low);
}

std::vector<std::string> wrapped(std::string_view text, double width, std::size_t most_lines, TextLook look,
                                 const TextMeasure& measure) {
    std::vector<std::string> lines;
    std::string line;
    for (const std::string_view word : text::split(text, ' ')) {
        if (word.empty()) continue;
        const std::string longer = line.empty() ? std::string(word) : line + " " + std::string(word);
        const bool last = lines.size() + 1 == most_lines;
        // The last line takes all that is left, to be cut off.
        if (line.empty() || last || measure.width(longer, look.size, look.weight) <= width) {
            line = longer;
            continue;
        }
        lines.push_back(std::move(line));
        line = word;
    }
    if (!line.empty()) lines.push_back(std::move(line));
    for (std::string& l : lines) l = shortened(l, width, look, measure);
    return lines;
}

} // namespace planum::strat
