// SPDX-License-Identifier: MIT
#include "strat/exchange/json_support.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace planum::strat {

namespace {

constexpr int kMaxDepth = 100;
constexpr std::size_t kMaxValues = 10'000'000; // about 1 GB in memory

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
            throw Error(ErrorCode::BadInput, fmt::format("JSON nested more than {} deep at byte {}", kMaxDepth, i));
        }
    }
}

} // namespace

Json parse_json(std::string_view utf8) {
    check_size(utf8);
    try {
        return Json::parse(utf8);
    } catch (const Json::parse_error& e) {
        throw Error(ErrorCode::BadInput, fmt::format("not valid JSON at byte {}", e.byte));
    } catch (const Json::exception&) {
        throw Error(ErrorCode::BadInput, "JSON with a number that is too large");
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
