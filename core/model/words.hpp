// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace planum::model::detail {

/// Looks a word up in a table of {enumerator, word}; the tables are short, so a line scan is quickest.
template<class Enum, std::size_t N>
[[nodiscard]] constexpr std::string_view word_of(const std::array<std::pair<Enum, std::string_view>, N>& table,
                                                 Enum value) noexcept {
    for (const auto& [candidate, word] : table) {
        if (candidate == value) return word;
    }
    return {};
}

template<class Enum, std::size_t N>
[[nodiscard]] constexpr std::optional<Enum> value_of(const std::array<std::pair<Enum, std::string_view>, N>& table,
                                                     std::string_view word) noexcept {
    for (const auto& [value, candidate] : table) {
        if (candidate == word) return value;
    }
    return std::nullopt;
}

} // namespace planum::model::detail
