// SPDX-License-Identifier: MIT
#include "strat/exchange/dating_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

#include "core/base/text.hpp"

namespace planum::strat {

namespace {

using model::Year;

enum class Era { None, Common, Before };

struct EraWord {
    std::string_view word;
    Era era;
};

// Folded; longer words stand before those they begin with.
constexpr std::array kEras = {
    EraWord{"bce", Era::Before},       EraWord{"bc", Era::Before},        EraWord{"b.c.", Era::Before},
    EraWord{"a.c.", Era::Before},      EraWord{"a.c", Era::Before},       EraWord{"v. chr.", Era::Before},
    EraWord{"v.chr.", Era::Before},    EraWord{"av. j.-c.", Era::Before}, EraWord{"ce", Era::Common},
    EraWord{"a.d.", Era::Common},      EraWord{"ad", Era::Common},        EraWord{"d.c.", Era::Common},
    EraWord{"d.c", Era::Common},       EraWord{"n. chr.", Era::Common},   EraWord{"n.chr.", Era::Common},
    EraWord{"ap. j.-c.", Era::Common},
};
constexpr std::array<std::string_view, 7> kNow = {"present", "today", "now", "oggi", "heute", "aujourd'hui", "attuale"};
constexpr std::array<std::string_view, 6> kCenturies = {"century", "secolo", "sec.", "jahrhundert", "jh.", "siècle"};

struct Point {
    bool now = false;
    Year year = 0;
    Era era = Era::None;
    std::size_t digits = 0;
};

class SpanReader {
  public:
    explicit SpanReader(std::string_view folded) : s_(folded) {}

    std::optional<YearSpan> whole() {
        const auto first = point();
        if (!first) return std::nullopt;
        if (skip_blanks(); at_ >= s_.size()) return single(*first);
        const bool colon = s_[at_] == ':';
        if (!separator()) return std::nullopt;
        const auto second = point();
        skip_blanks();
        if (!second || at_ < s_.size() || first->now) return std::nullopt;
        const bool certain = colon || first->era != Era::None || second->era != Era::None || second->now ||
                             std::max(first->digits, second->digits) >= 3;
        if (!certain) return std::nullopt;
        return span(*first, *second);
    }

  private:
    void skip_blanks() noexcept {
        while (at_ < s_.size() && s_[at_] == ' ') ++at_;
    }

    bool take(std::string_view word) noexcept {
        if (!s_.substr(at_).starts_with(word)) return false;
        at_ += word.size();
        return true;
    }

    bool separator() noexcept {
        return take(":") || take("–") || take("—") || take("-") || take("to ") || take("bis ");
    }

    std::optional<Point> point() {
        skip_blanks();
        Point out;
        for (const std::string_view word : kNow) {
            if (take(word)) {
                out.now = true;
                return out;
            }
        }
        const bool negative = take("-") || take("−");
        const char* begin = s_.data() + at_;
        const char* end = s_.data() + s_.size();
        const auto [stop, problem] = std::from_chars(begin, end, out.year);
        if (problem != std::errc{} || stop == begin || *begin == '-' || out.year > 1'000'000) return std::nullopt;
        out.digits = static_cast<std::size_t>(stop - begin);
        at_ += out.digits;
        if (negative) {
            out.year = -out.year;
            out.era = Era::Before;
        }
        skip_blanks();
        for (const EraWord& entry : kEras) {
            if (!take(entry.word)) continue;
            if (negative) return std::nullopt;
            out.era = entry.era;
            break;
        }
        return out;
    }

    static Year signed_year(const Point& point, Era era) {
        return era == Era::Before && point.year > 0 ? -point.year : point.year;
    }

    static std::optional<YearSpan> single(const Point& point) {
        if (point.now || point.era == Era::None) return std::nullopt;
        const Year year = signed_year(point, point.era);
        return YearSpan{year, year};
    }

    // "300-200 BC": the era written last holds for both, a sign only for its own number.
    static std::optional<YearSpan> span(const Point& first, const Point& second) {
        const Era first_era = first.era != Era::None || second.year < 0 ? first.era : second.era;
        YearSpan out;
        out.from = signed_year(first, first_era);
        if (!second.now) out.to = signed_year(second, second.era);
        if (out.to && *out.to < *out.from) return std::nullopt;
        return out;
    }

    std::string_view s_;
    std::size_t at_ = 0;
};

std::optional<Year> roman_number(std::string_view folded) {
    static constexpr std::array<std::pair<char, Year>, 4> kDigits = {
        std::pair{'i', Year{1}}, std::pair{'v', Year{5}}, std::pair{'x', Year{10}}, std::pair{'l', Year{50}}};
    Year sum = 0;
    Year previous = 0;
    for (auto c = folded.rbegin(); c != folded.rend(); ++c) {
        const auto digit = std::find_if(kDigits.begin(), kDigits.end(), [&](const auto& d) { return d.first == *c; });
        if (digit == kDigits.end()) return std::nullopt;
        sum += digit->second < previous ? -digit->second : digit->second;
        previous = digit->second;
    }
    return sum > 0 && sum <= 30 && folded.size() <= 6 ? std::optional(sum) : std::nullopt;
}

std::optional<Year> ordinal(std::string_view word) {
    for (const std::string_view ending : {"st", "nd", "rd", "th", ".", "ème", "er", "e"}) {
        if (word.size() > ending.size() && word.ends_with(ending)) {
            word.remove_suffix(ending.size());
            break;
        }
    }
    if (const auto number = text::parse_integer(word)) {
        return *number > 0 && *number <= 30 ? std::optional<Year>(*number) : std::nullopt;
    }
    return roman_number(word);
}

// "13th century", "XV secolo", "1st century BC": the whole text, nothing before or behind.
std::optional<YearSpan> century(std::string_view folded) {
    const std::size_t blank = folded.find(' ');
    if (blank == std::string_view::npos) return std::nullopt;
    const auto number = ordinal(folded.substr(0, blank));
    std::string_view rest = text::trim(folded.substr(blank));
    const auto* const word =
        std::find_if(kCenturies.begin(), kCenturies.end(), [&](std::string_view c) { return rest.starts_with(c); });
    if (!number || word == kCenturies.end()) return std::nullopt;
    rest = text::trim(rest.substr(word->size()));
    Era era = rest.empty() ? Era::Common : Era::None;
    for (const EraWord& entry : kEras) {
        if (rest == entry.word) era = entry.era;
    }
    if (era == Era::None) return std::nullopt;
    if (era == Era::Before) return YearSpan{-100 * *number, -100 * *number + 99};
    return YearSpan{100 * *number - 99, 100 * *number};
}

} // namespace

std::optional<YearSpan> years_in_text(std::string_view utf8) {
    if (utf8.size() > 1000) return std::nullopt;
    const std::string folded = text::fold_case(text::trim(utf8));
    std::string_view rest = folded;
    while (true) {
        const std::size_t open = rest.find('(');
        if (open == std::string_view::npos) break;
        const std::size_t close = rest.find(')', open);
        if (close == std::string_view::npos) break;
        if (auto span = SpanReader(text::trim(rest.substr(open + 1, close - open - 1))).whole()) return span;
        rest = rest.substr(close + 1);
    }
    if (auto span = SpanReader(folded).whole()) return span;
    return century(folded);
}

} // namespace planum::strat
