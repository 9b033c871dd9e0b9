// SPDX-License-Identifier: MIT
#include "strat/exchange/json_support.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace planum::strat {

namespace {

constexpr int kMaxDepth = 100;
constexpr std::size_t kMaxValues = 10'000'000; // about 1 GB in memory

// `line 3, column 14`, as editors count.
std::string place_of(std::string_view text, std::size_t at) {
    const std::string_view before = text.substr(0, at);
    const std::size_t line = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    const auto is_letter = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; };
    return fmt::format("line {}, column {}", std::count(before.begin(), before.end(), '\n') + 1,
                       std::count_if(before.begin() + static_cast<std::ptrdiff_t>(line), before.end(), is_letter) + 1);
}

// Counted before parsing, so that neither depth nor number reaches the parser or the destructors.
void check_size(std::string_view text) {
    int depth = 0;
    std::size_t values = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\') ++i;
            if (c == '"') in_string = false;
            continue;
        }
        if (c == '"') in_string = true;
        if (c == '[' || c == '{') ++depth;
        if (c == ']' || c == '}') --depth;
        if (c == ',' && ++values > kMaxValues) {
            throw Error(ErrorCode::BadInput, fmt::format("JSON with more than {} values", kMaxValues));
        }
        if (depth > kMaxDepth) {
            throw Error(ErrorCode::BadInput,
                        fmt::format("JSON nested more than {} deep at {}", kMaxDepth, place_of(text, i)));
        }
    }
}

std::size_t first_line_not_utf8(std::string_view text) {
    const std::vector<std::string_view> lines = text::split(text, '\n');
    const auto bad = std::find_if_not(lines.begin(), lines.end(), text::is_valid_utf8);
    return static_cast<std::size_t>(bad - lines.begin()) + 1;
}

// Why a text is no JSON, as far as that can be told from where the parser stopped.
std::string reason_of(std::string_view text, std::size_t at) {
    if (text::trim(text).empty()) return "the file is empty";
    if (!text::is_valid_utf8(text))
        return fmt::format("line {} is not UTF-8: save the file as UTF-8", first_line_not_utf8(text));
    const auto is_word = [&](std::size_t i) { return std::isalpha(static_cast<unsigned char>(text[i])) != 0; };
    std::size_t begin = std::min(at, text.size());
    std::size_t end = begin;
    while (begin > 0 && is_word(begin - 1)) --begin;
    while (end < text.size() && is_word(end)) ++end;
    const std::string word = text::fold_case(text.substr(begin, end - begin));
    if (word == "nan" || word == "inf" || word == "infinity")
        return fmt::format("{}: JSON has no number {}; leave it out or write null", place_of(text, begin),
                           text.substr(begin, end - begin));
    return "not valid JSON at " + place_of(text, std::min(at, text.size()));
}

// The parser says which number it was, and not where.
std::string too_large(std::string_view text, std::string_view said) {
    const std::size_t open = said.find('\'');
    const std::size_t close = said.rfind('\'');
    if (open == std::string_view::npos || close <= open + 1) return "JSON with a number that is too large";
    const std::string_view number = said.substr(open + 1, close - open - 1);
    const std::size_t at = text.find(number);
    if (at == std::string_view::npos) return "JSON with a number that is too large";
    return fmt::format("{}: the number {} is too large", place_of(text, at), number.substr(0, 40));
}

} // namespace

Json parse_json(std::string_view utf8) {
    check_size(utf8);
    try {
        return Json::parse(utf8);
    } catch (const Json::parse_error& e) {
        throw Error(ErrorCode::BadInput, reason_of(utf8, e.byte == 0 ? 0 : e.byte - 1));
    } catch (const Json::exception& e) {
        throw Error(ErrorCode::BadInput, too_large(utf8, e.what()));
    }
}

const Json* json_member(const Json& value, std::string_view key) {
    if (!value.is_object()) return nullptr;
    const auto found = value.find(key);
    return found == value.end() ? nullptr : &*found;
}

std::string json_scalar_text(const Json& value) {
    if (value.is_string()) {
        const std::string clean = text::clean_utf8(value.get_ref<const std::string&>()).text;
        return std::string(text::trim(clean));
    }
    if (value.is_number() || value.is_boolean()) return value.dump();
    return {};
}

std::string json_text(const Json& value, std::string_view key) {
    const Json* member = json_member(value, key);
    return member == nullptr ? std::string{} : json_scalar_text(*member);
}

std::optional<double> json_number(const Json& value, std::string_view key) {
    const auto number = text::parse_double(json_text(value, key));
    return number && std::isfinite(*number) ? number : std::nullopt;
}

} // namespace planum::strat
