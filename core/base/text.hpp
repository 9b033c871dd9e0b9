// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace planum::text {

/// Without blanks, tabs and line ends at both ends.
[[nodiscard]] std::string_view trim(std::string_view s) noexcept;

/// Lower case for ASCII and the Latin letters of our four languages; for matching, not for showing.
[[nodiscard]] std::string fold_case(std::string_view utf8);

[[nodiscard]] std::vector<std::string_view> split(std::string_view s, char separator);
[[nodiscard]] std::string join(const std::vector<std::string>& parts, std::string_view separator);
[[nodiscard]] std::string replace_all(std::string_view s, std::string_view from, std::string_view to);

/// Order in which people count: 9 before 10, `12` before `12a`, `B. 9` before `B. 36`; runs of digits
/// compare as numbers of any length, letters without case, ties by bytes, so the order is total.
[[nodiscard]] std::strong_ordering natural_order(std::string_view a, std::string_view b) noexcept;

struct NaturalLess {
    using is_transparent = void;

    [[nodiscard]] bool operator()(std::string_view a, std::string_view b) const noexcept {
        return natural_order(a, b) < 0;
    }
};

[[nodiscard]] bool is_valid_utf8(std::string_view s) noexcept;

/// ISO-8859-1 (Windows-1252 in 0x80…0x9F) to UTF-8; never fails.
[[nodiscard]] std::string from_latin1(std::string_view bytes);

/// UTF-8 to ISO-8859-1; letters it lacks become '?', and `*lost` counts them.
[[nodiscard]] std::string to_latin1(std::string_view utf8, std::size_t* lost);

struct Cleaned {
    std::string text;
    std::size_t replaced = 0; ///< bytes or characters that had to be replaced
};

/// Valid UTF-8 without control characters other than tab and line feed; what is neither becomes
/// U+FFFD and is counted, so that the caller can report it. CR LF becomes LF.
[[nodiscard]] Cleaned clean_utf8(std::string_view bytes);

/// As clean_utf8, for names and what else stands on one line: tabs and line ends become blanks, signs that turn
/// the direction of what follows (U+202A…202E, U+2066…2069) become U+FFFD; both are counted. Trimmed.
[[nodiscard]] Cleaned on_one_line(std::string_view bytes);

/// How many of what: `1 unit`, `2 units`, `0 units`. What takes no s is given as `many`.
[[nodiscard]] std::string counted(std::int64_t count, std::string_view one, std::string_view many = {});

template<std::unsigned_integral Count>
[[nodiscard]] std::string counted(Count count, std::string_view one, std::string_view many = {}) {
    return counted(static_cast<std::int64_t>(count), one, many);
}

/// A whole decimal number with '.' or ',' as point; nothing else around it but blanks.
[[nodiscard]] std::optional<double> parse_double(std::string_view s) noexcept;
[[nodiscard]] std::optional<long long> parse_integer(std::string_view s) noexcept;

} // namespace planum::text
