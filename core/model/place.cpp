// SPDX-License-Identifier: MIT
#include "core/model/place.hpp"

#include <utility>

#include "core/model/words.hpp"

namespace planum::model {

namespace {

constexpr std::array kMethodWords = {
    std::pair{DigMethod::Stratigraphic, std::string_view{"stratigraphic"}},
    std::pair{DigMethod::Planum, std::string_view{"planum"}},
    std::pair{DigMethod::Mixed, std::string_view{"mixed"}},
};

constexpr std::array kShowsWords = {
    std::pair{RegionShows::Top, std::string_view{"top"}},
    std::pair{RegionShows::Level, std::string_view{"level"}},
    std::pair{RegionShows::Cut, std::string_view{"cut"}},
    std::pair{RegionShows::Overdug, std::string_view{"overdug"}},
    std::pair{RegionShows::Machine, std::string_view{"machine"}},
    std::pair{RegionShows::Face, std::string_view{"face"}},
    std::pair{RegionShows::Nothing, std::string_view{"nothing"}},
};

constexpr std::array kCategoryWords = {
    std::pair{RegionCategory::Unit, std::string_view{"unit"}},
    std::pair{RegionCategory::Spoil, std::string_view{"spoil"}},
    std::pair{RegionCategory::Slump, std::string_view{"slump"}},
    std::pair{RegionCategory::Backfill, std::string_view{"backfill"}},
    std::pair{RegionCategory::Water, std::string_view{"water"}},
    std::pair{RegionCategory::Equipment, std::string_view{"equipment"}},
    std::pair{RegionCategory::Baulk, std::string_view{"baulk"}},
    std::pair{RegionCategory::Unexcavated, std::string_view{"unexcavated"}},
};

} // namespace

const std::string& last_day_of(const Surface& surface) noexcept {
    return surface.last_day.empty() ? surface.first_day : surface.last_day;
}

std::string_view to_word(DigMethod method) noexcept { return detail::word_of(kMethodWords, method); }

std::string_view to_word(RegionShows shows) noexcept { return detail::word_of(kShowsWords, shows); }

std::string_view to_word(RegionCategory category) noexcept { return detail::word_of(kCategoryWords, category); }

std::optional<DigMethod> dig_method_from_word(std::string_view word) noexcept {
    return detail::value_of(kMethodWords, word);
}

std::optional<RegionShows> region_shows_from_word(std::string_view word) noexcept {
    return detail::value_of(kShowsWords, word);
}

std::optional<RegionCategory> region_category_from_word(std::string_view word) noexcept {
    return detail::value_of(kCategoryWords, word);
}

} // namespace planum::model
