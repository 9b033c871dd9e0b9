// SPDX-License-Identifier: MIT
#include "core/base/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

#include "core/base/utf8.hpp"

namespace planum::text {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD"; // U+FFFD

bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

bool is_blank(char c) noexcept { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f'; }

char ascii_lower(char c) noexcept { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

struct Decoded {
    char32_t code = 0;
    std::size_t length = 0; ///< 0: not valid here
};

// Table 3-7 of the Unicode standard: which second bytes may follow which first byte.
Decoded decode(std::string_view s) noexcept {
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(s[i]); };
    const auto tail = [&](std::size_t i) { return i < s.size() && (at(i) & 0xC0U) == 0x80U; };
    const unsigned char b0 = at(0);
    if (b0 < 0x80U) return {b0, 1};
    if (b0 >= 0xC2U && b0 <= 0xDFU && tail(1)) {
        return {(static_cast<char32_t>(b0 & 0x1FU) << 6U) | (at(1) & 0x3FU), 2};
    }
    if (b0 >= 0xE0U && b0 <= 0xEFU && tail(1) && tail(2)) {
        const char32_t code =
            (static_cast<char32_t>(b0 & 0x0FU) << 12U) | (static_cast<char32_t>(at(1) & 0x3FU) << 6U) | (at(2) & 0x3FU);
        if (code >= 0x800U && (code < 0xD800U || code > 0xDFFFU)) return {code, 3};
    }
    if (b0 >= 0xF0U && b0 <= 0xF4U && tail(1) && tail(2) && tail(3)) {
        const char32_t code = (static_cast<char32_t>(b0 & 0x07U) << 18U) |
                              (static_cast<char32_t>(at(1) & 0x3FU) << 12U) |
                              (static_cast<char32_t>(at(2) & 0x3FU) << 6U) | (at(3) & 0x3FU);
        if (code >= 0x10000U && code <= 0x10FFFFU) return {code, 4};
    }
    return {};
}

// Windows-1252 for the 32 codes that ISO-8859-1 leaves to control characters.
constexpr std::array<char32_t, 32> kWindows1252 = {0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                                   0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD,
                                                   0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                                   0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};

char32_t lower(char32_t code) noexcept {
    if (code >= U'A' && code <= U'Z') return code + 32;
    if (code >= 0xC0 && code <= 0xDE && code != 0xD7) return code + 32; // Latin-1 letters
    if (code == 0x1E9E) return 0xDF;                                    // capital sharp s
    if (code >= 0x100 && code <= 0x17F && code != 0x130 && code != 0x131 && code != 0x138) {
        const bool odd_is_upper = (code >= 0x139 && code <= 0x148) || (code >= 0x179 && code <= 0x17E);
        if (code == 0x178) return 0xFF;
        if (code == 0x17F || code == 0x149) return code;
        return (code % 2 == 1) == odd_is_upper ? code + 1 : code;
    }
    return code;
}

// Compares two runs of digits as numbers of any length.
std::strong_ordering compare_digits(std::string_view a, std::string_view b) noexcept {
    while (a.size() > 1 && a.front() == '0') a.remove_prefix(1);
    while (b.size() > 1 && b.front() == '0') b.remove_prefix(1);
    if (a.size() != b.size()) return a.size() <=> b.size();
    return a.compare(b) <=> 0;
}

std::string_view digits_from(std::string_view s, std::size_t at) noexcept {
    std::size_t end = at;
    while (end < s.size() && is_digit(s[end])) ++end;
    return s.substr(at, end - at);
}

} // namespace

void append_utf8(std::string& out, char32_t code) {
    const auto put = [&](char32_t byte) { out.push_back(static_cast<char>(byte)); };
    if (code < 0x80U) {
        put(code);
    } else if (code < 0x800U) {
        put(0xC0U | (code >> 6U));
        put(0x80U | (code & 0x3FU));
    } else if (code < 0x10000U) {
        put(0xE0U | (code >> 12U));
        put(0x80U | ((code >> 6U) & 0x3FU));
        put(0x80U | (code & 0x3FU));
    } else {
        put(0xF0U | (code >> 18U));
        put(0x80U | ((code >> 12U) & 0x3FU));
        put(0x80U | ((code >> 6U) & 0x3FU));
        put(0x80U | (code & 0x3FU));
    }
}

std::string_view trim(std::string_view s) noexcept {
    while (!s.empty() && is_blank(s.front())) s.remove_prefix(1);
    while (!s.empty() && is_blank(s.back())) s.remove_suffix(1);
    return s;
}

std::string fold_case(std::string_view utf8) {
    std::string out;
    out.reserve(utf8.size());
    for (std::size_t i = 0; i < utf8.size();) {
        const Decoded d = decode(utf8.substr(i));
        if (d.length == 0) {
            out.push_back(utf8[i++]);
            continue;
        }
        append_utf8(out, lower(d.code));
        i += d.length;
    }
    return out;
}

std::vector<std::string_view> split(std::string_view s, char separator) {
    std::vector<std::string_view> parts;
    std::size_t from = 0;
    while (true) {
        const std::size_t to = s.find(separator, from);
        if (to == std::string_view::npos) break;
        parts.push_back(s.substr(from, to - from));
        from = to + 1;
    }
    parts.push_back(s.substr(from));
    return parts;
}

std::string join(const std::vector<std::string>& parts, std::string_view separator) {
    std::string out;
    for (const std::string& part : parts) {
        if (&part != &parts.front()) out += separator;
        out += part;
    }
    return out;
}

std::string replace_all(std::string_view s, std::string_view from, std::string_view to) {
    std::string out;
    std::size_t at = 0;
    while (!from.empty()) {
        const std::size_t hit = s.find(from, at);
        if (hit == std::string_view::npos) break;
        out.append(s.substr(at, hit - at));
        out.append(to);
        at = hit + from.size();
    }
    out.append(s.substr(at));
    return out;
}

std::strong_ordering natural_order(std::string_view a, std::string_view b) noexcept {
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() && j < b.size()) {
        if (is_digit(a[i]) && is_digit(b[j])) {
            const std::string_view da = digits_from(a, i);
            const std::string_view db = digits_from(b, j);
            if (const auto order = compare_digits(da, db); order != 0) return order;
            i += da.size();
            j += db.size();
            continue;
        }
        const auto ca = static_cast<unsigned char>(ascii_lower(a[i]));
        const auto cb = static_cast<unsigned char>(ascii_lower(b[j]));
        if (ca != cb) return ca <=> cb;
        ++i;
        ++j;
    }
    if (const auto order = (a.size() - i) <=> (b.size() - j); order != 0) return order;
    return a.compare(b) <=> 0;
}

bool is_valid_utf8(std::string_view s) noexcept {
    for (std::size_t i = 0; i < s.size();) {
        const Decoded d = decode(s.substr(i));
        if (d.length == 0) return false;
        i += d.length;
    }
    return true;
}

std::string from_latin1(std::string_view bytes) {
    std::string out;
    out.reserve(bytes.size() + bytes.size() / 8);
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        const bool windows = byte >= 0x80U && byte < 0xA0U;
        append_utf8(out, windows ? kWindows1252.at(byte - 0x80U) : static_cast<char32_t>(byte));
    }
    return out;
}

std::string to_latin1(std::string_view utf8, std::size_t* lost) {
    std::string out;
    out.reserve(utf8.size());
    for (std::size_t i = 0; i < utf8.size();) {
        const Decoded d = decode(utf8.substr(i));
        const bool fits = d.length > 0 && d.code < 0x100U && (d.code < 0x80U || d.code >= 0xA0U);
        out.push_back(fits ? static_cast<char>(d.code) : '?');
        if (!fits && lost != nullptr) ++*lost;
        i += std::max<std::size_t>(d.length, 1);
    }
    return out;
}

Cleaned clean_utf8(std::string_view bytes) {
    Cleaned result;
    result.text.reserve(bytes.size());
    for (std::size_t i = 0; i < bytes.size();) {
        const Decoded d = decode(bytes.substr(i));
        const bool carriage = d.length == 1 && d.code == U'\r';
        if (carriage && i + 1 < bytes.size() && bytes[i + 1] == '\n') {
            ++i;
            continue;
        }
        const bool control = (d.code < 0x20U && d.code != U'\t' && d.code != U'\n') || d.code == 0x7FU ||
                             (d.code >= 0x80U && d.code < 0xA0U);
        if (d.length == 0 || control) {
            result.text += carriage ? std::string_view{"\n"} : kReplacement;
            if (!carriage) ++result.replaced;
        } else {
            result.text.append(bytes.substr(i, d.length));
        }
        i += std::max<std::size_t>(d.length, 1);
    }
    return result;
}

Cleaned on_one_line(std::string_view bytes) {
    Cleaned result = clean_utf8(trim(bytes));
    std::string line;
    line.reserve(result.text.size());
    for (std::size_t i = 0; i < result.text.size();) {
        const Decoded d = decode(std::string_view(result.text).substr(i));
        const bool breaks = d.code == U'\t' || d.code == U'\n' || d.code == 0x2028U || d.code == 0x2029U;
        const bool turns = (d.code >= 0x202AU && d.code <= 0x202EU) || (d.code >= 0x2066U && d.code <= 0x2069U);
        if (breaks) line += ' ';
        if (turns) line += kReplacement;
        if (breaks || turns) {
            ++result.replaced;
        } else {
            line.append(result.text, i, d.length);
        }
        i += std::max<std::size_t>(d.length, 1);
    }
    result.text = std::move(line);
    return result;
}

std::string counted(std::int64_t count, std::string_view one, std::string_view many) {
    std::string words = std::to_string(count) + ' ';
    words += count == 1 || many.empty() ? one : many;
    if (count != 1 && many.empty()) words += 's';
    return words;
}

std::optional<double> parse_double(std::string_view s) noexcept {
    s = trim(s);
    if (s.empty() || s.size() > 60) return std::nullopt;
    std::array<char, 64> buffer{};
    std::copy(s.begin(), s.end(), buffer.begin());
    std::replace(buffer.begin(), buffer.end(), ',', '.');
    const char* first = buffer.data();
    const char* last = first + s.size();
    if (*first == '+') ++first;
    double value = 0.0;
    const auto [end, problem] = std::from_chars(first, last, value);
    if (problem != std::errc{} || end != last) return std::nullopt;
    return value;
}

std::optional<long long> parse_integer(std::string_view s) noexcept {
    s = trim(s);
    if (!s.empty() && s.front() == '+') s.remove_prefix(1);
    long long value = 0;
    const auto [end, problem] = std::from_chars(s.data(), s.data() + s.size(), value);
    if (s.empty() || problem != std::errc{} || end != s.data() + s.size()) return std::nullopt;
    return value;
}

} // namespace planum::text
