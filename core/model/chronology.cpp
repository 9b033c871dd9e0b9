// SPDX-License-Identifier: MIT
#include "core/model/chronology.hpp"

#include <array>
#include <utility>

#include "core/model/words.hpp"

namespace planum::model {

namespace {

constexpr std::array kDatingWords = {
    std::pair{DatingKind::Typed, std::string_view{"typed"}},
    std::pair{DatingKind::Find, std::string_view{"find"}},
    std::pair{DatingKind::Coin, std::string_view{"coin"}},
    std::pair{DatingKind::Radiocarbon, std::string_view{"radiocarbon"}},
    std::pair{DatingKind::PostQuem, std::string_view{"post-quem"}},
    std::pair{DatingKind::AnteQuem, std::string_view{"ante-quem"}},
};

} // namespace

std::string_view to_word(DatingKind kind) noexcept { return detail::word_of(kDatingWords, kind); }

std::optional<DatingKind> dating_kind_from_word(std::string_view word) noexcept {
    return detail::value_of(kDatingWords, word);
}

} // namespace planum::model
