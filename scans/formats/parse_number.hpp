// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <cstdint>

namespace planum::scans {

/// Powers of ten that a double holds exactly.
inline constexpr std::array<double, 23> kExactPowersOfTen = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                             1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                             1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// Reads the number that starts at `p`, correctly rounded; returns where it ends, or nullptr when
/// there is none or it is too big for a double. `*end` must be readable and no part of a number (the
/// line end); `point` is the decimal sign.
///
/// Up to 19 digits without exponent are read as one integer m and divided by a power of ten: both are
/// exact below 2^53 and 10^22, so one division rounds correctly (Clinger 1990). The rest goes the
/// library's slower way.
[[nodiscard]] inline const char* parse_number(const char* p, const char* end, double& out, char point = '.') noexcept {
    const char* const first = p;
    const bool negative = *p == '-';
    if (negative || *p == '+') ++p;
    const char* const digits_from = p;
    std::uint64_t mantissa = 0;
    unsigned digit = 0;
    while ((digit = static_cast<unsigned>(*p) - static_cast<unsigned>('0')) < 10U) {
        mantissa = mantissa * 10U + digit;
        ++p;
    }
    std::ptrdiff_t digits = p - digits_from;
    std::ptrdiff_t decimals = 0;
    if (*p == point) {
        const char* const decimals_from = ++p;
        while ((digit = static_cast<unsigned>(*p) - static_cast<unsigned>('0')) < 10U) {
            mantissa = mantissa * 10U + digit;
            ++p;
        }
        decimals = p - decimals_from;
        digits += decimals;
    }
    const bool simple = (*p | 0x20) != 'e' && digits > 0 && digits <= 19 && mantissa <= (1ULL << 53U);
    if (simple) {
        const double value = static_cast<double>(mantissa) / kExactPowersOfTen[static_cast<std::size_t>(decimals)];
        out = negative ? -value : value;
        return p;
    }
    if (point != '.' && digits > 0) return nullptr; // nobody writes exponents with a decimal comma
    const auto [after, problem] = std::from_chars(*first == '+' ? first + 1 : first, end, out);
    return problem == std::errc{} ? after : nullptr;
}

[[nodiscard]] inline bool is_blank(char c) noexcept { return c == ' ' || c == '\t'; }

/// Reads up to `wanted` numbers with blanks between them. Returns how many there were when the line
/// holds nothing else, or -1 - (index of the field that is no number); wanted + 1: there are more.
[[nodiscard]] inline int parse_row(const char* p, const char* end, double* out, int wanted) noexcept {
    for (int i = 0;; ++i) {
        while (is_blank(*p)) ++p;
        if (p >= end) return i;
        if (i == wanted) return wanted + 1;
        const char* const after = parse_number(p, end, out[i]);
        if (after == nullptr || (after < end && !is_blank(*after))) return -1 - i;
        p = after;
    }
}

} // namespace planum::scans
