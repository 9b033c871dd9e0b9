// SPDX-License-Identifier: MIT
#include "core/model/measured.hpp"

#include <array>
#include <utility>

#include "core/model/words.hpp"

namespace planum::model {

namespace {

constexpr std::array kRoleWords = {
    std::pair{LevelRole::Top, std::string_view{"top"}},
    std::pair{LevelRole::Base, std::string_view{"base"}},
    std::pair{LevelRole::Cut, std::string_view{"cut"}},
    std::pair{LevelRole::Other, std::string_view{"other"}},
};

} // namespace

std::string_view to_word(LevelRole role) noexcept { return detail::word_of(kRoleWords, role); }

std::optional<LevelRole> level_role_from_word(std::string_view word) noexcept {
    return detail::value_of(kRoleWords, word);
}

} // namespace planum::model
