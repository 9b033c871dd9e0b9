// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/base/text.hpp"
#include "core/base/utf8.hpp"
#include "strat/exchange/delimited_table.hpp"

namespace planum::strat {

namespace {

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
constexpr std::string_view kLittleEndianMark = "\xFF\xFE";
constexpr std::string_view kBigEndianMark = "\xFE\xFF";

// A half surrogate or an odd last byte becomes a byte that is no UTF-8, so that cleaning counts it.
std::string from_utf16(std::string_view bytes, bool little_endian) {
    const auto unit_at = [&](std::size_t i) {
        const auto first = static_cast<unsigned char>(bytes[i]);
        const auto second = static_cast<unsigned char>(bytes[i + 1]);
        return static_cast<char32_t>(little_endian ? first | (second << 8U) : second | (first << 8U));
    };
    std::string out;
    out.reserve(bytes.size() / 2);
    std::size_t i = 0;
    for (; i + 1 < bytes.size(); i += 2) {
        const char32_t code = unit_at(i);
        const bool high = code >= 0xD800U && code < 0xDC00U;
        if (high && i + 3 < bytes.size() && unit_at(i + 2) >= 0xDC00U && unit_at(i + 2) < 0xE000U) {
            text::append_utf8(out, 0x10000U + ((code - 0xD800U) << 10U) + (unit_at(i + 2) - 0xDC00U));
            i += 2;
        } else if (code >= 0xD800U && code < 0xE000U) {
            out.push_back('\xFF');
        } else {
            text::append_utf8(out, code);
        }
    }
    if (i < bytes.size()) out.push_back('\xFF');
    return out;
}

// UTF-8, or UTF-8 cut off within its last character.
bool looks_like_utf8(std::string_view bytes) {
    if (text::is_valid_utf8(bytes)) return true;
    const auto is_tail = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
    std::size_t cut = bytes.size();
    while (cut > 0 && bytes.size() - cut < 3 && is_tail(bytes[cut - 1])) --cut;
    if (cut == 0 || static_cast<unsigned char>(bytes[cut - 1]) < 0xC2U) return false;
    // Something before the cut must prove the encoding: one lone Latin-1 letter at the end does not.
    const std::string_view before = bytes.substr(0, cut - 1);
    const bool has_letters = std::any_of(before.begin(), before.end(), [](char c) { return (c & 0x80) != 0; });
    return has_letters && text::is_valid_utf8(before);
}

std::int64_t line_of_first_replacement(std::string_view text) {
    const std::size_t at = text.find("\xEF\xBF\xBD");
    if (at == std::string_view::npos) return 0;
    return 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
}

} // namespace

DecodedText decode_text(std::string_view bytes, std::string_view file_name, std::string_view encoding) {
    DecodedText result;
    std::string raw;
    if (bytes.starts_with(kLittleEndianMark) || bytes.starts_with(kBigEndianMark)) {
        result.encoding = "utf-16";
        raw = from_utf16(bytes.substr(2), bytes.starts_with(kLittleEndianMark));
    } else if (bytes.starts_with(kUtf8Mark)) {
        result.encoding = "utf-8";
        raw = bytes.substr(kUtf8Mark.size());
    } else if (encoding == "utf-8" || (encoding.empty() && looks_like_utf8(bytes))) {
        result.encoding = "utf-8";
        raw = bytes;
    } else {
        result.encoding = "windows-1252";
        raw = text::from_latin1(bytes);
    }
    text::Cleaned cleaned = text::clean_utf8(raw);
    result.text = std::move(cleaned.text);
    if (cleaned.replaced > 0) {
        result.notes.push_back(
            {std::string{file_name},
             line_of_first_replacement(result.text),
             "replaced-characters",
             {},
             fmt::format("{} characters are no text in {} and were replaced", cleaned.replaced, result.encoding)});
    }
    return result;
}

} // namespace planum::strat
