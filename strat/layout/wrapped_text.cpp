// SPDX-License-Identifier: MIT
#include "strat/layout/wrapped_text.hpp"

#include <algorithm>
#include <utility>

#include "core/base/text.hpp"

namespace planum::strat {

namespace {

constexpr std::string_view kEllipsis = "…";

// Where letters end, the last one's end included.
std::vector<std::size_t> letter_ends(std::string_view text) {
    std::vector<std::size_t> ends;
    for (std::size_t i = 1; i <= text.size(); ++i) {
        if (i == text.size() || (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) ends.push_back(i);
    }
    return ends;
}

// The greatest count for which `fits` holds, if it holds for all smaller ones; 0 if for none.
template<class Fits>
std::size_t most_that_fit(std::size_t count, Fits fits) {
    std::size_t low = 0;
    std::size_t high = count;
    while (low < high) {
        const std::size_t middle = (low + high + 1) / 2;
        if (fits(middle)) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    return low;
}

bool may_end_line(char c) { return std::string_view(" -_/.,;:|+").find(c) != std::string_view::npos; }

} // namespace

std::string shortened(std::string_view text, double width, TextLook look, const TextMeasure& measure) {
    const auto fits = [&](const std::string& s) { return measure.width(s, look.size, look.weight) <= width; };
    const std::string whole(text);
    if (fits(whole)) return whole;
    const std::vector<std::size_t> ends = letter_ends(text);
    const auto cut = [&](std::size_t count) {
        std::string_view kept = count == 0 ? std::string_view{} : text.substr(0, ends[count - 1]);
        while (kept.ends_with(' ')) kept.remove_suffix(1);
        return std::string(kept) + std::string(kEllipsis);
    };
    return cut(most_that_fit(ends.size(), [&](std::size_t count) { return fits(cut(count)); }));
}

std::string shortened_inside(std::string_view text, double width, TextLook look, const TextMeasure& measure) {
    const auto fits = [&](const std::string& s) { return measure.width(s, look.size, look.weight) <= width; };
    const std::string whole(text);
    if (fits(whole)) return whole;
    const std::vector<std::size_t> ends = letter_ends(text);
    const auto cut = [&](std::size_t count) {
        const std::size_t tail = count / 2;
        const std::size_t head = count - tail;
        const std::string_view first = head == 0 ? std::string_view{} : text.substr(0, ends[head - 1]);
        const std::string_view last = tail == 0 ? std::string_view{} : text.substr(ends[ends.size() - tail - 1]);
        return std::string(first) + std::string(kEllipsis) + std::string(last);
    };
    return cut(most_that_fit(ends.size() - 1, [&](std::size_t count) { return fits(cut(count)); }));
}

std::vector<std::string> broken_anywhere(std::string_view text, double width, TextLook look,
                                         const TextMeasure& measure) {
    std::vector<std::string> lines;
    while (true) {
        const std::vector<std::size_t> ends = letter_ends(text);
        std::size_t count = most_that_fit(ends.size(), [&](std::size_t n) {
            return n == 0 || measure.width(text.substr(0, ends[n - 1]), look.size, look.weight) <= width;
        });
        count = std::max<std::size_t>(count, 1);
        if (count >= ends.size()) break;
        for (std::size_t n = count; n > count - count / 2; --n) {
            if (!may_end_line(text[ends[n - 1] - 1])) continue;
            count = n;
            break;
        }
        lines.emplace_back(text.substr(0, ends[count - 1]));
        text.remove_prefix(ends[count - 1]);
    }
    lines.emplace_back(text);
    return lines;
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
