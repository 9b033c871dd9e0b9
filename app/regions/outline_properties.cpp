// SPDX-License-Identifier: MIT
#include "app/regions/outline_properties.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "app/records/field_table.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace planum::app {

namespace {

using strat::Json;

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorCode::BadInput, message); }

// Property names as people write them: case, blanks, hyphens and underscores do not matter.
std::string key_of(std::string_view name) {
    std::string key = text::fold_case(name);
    std::erase_if(key, [](char c) { return c == ' ' || c == '_' || c == '-'; });
    return key;
}

void read_category(DrawnOutline& outline, const std::string& word) {
    if (word.empty()) return;
    if (const auto category = model::region_category_from_word(text::fold_case(word))) {
        outline.category = *category;
    } else if (const auto kind = model::kind_from_any_word(word)) {
        outline.kind = *kind;
    } else {
        refuse(
            fmt::format("category {} is neither unit, spoil, slump, backfill, water, equipment, baulk, unexcavated nor "
                        "a kind of unit",
                        word));
    }
}

std::array<double, 2> place_from(const Json& value) {
    if (!value.is_array() || value.size() < 2 || !value[0].is_number() || !value[1].is_number()) {
        refuse("section: from and to are [x, y] in site coordinates");
    }
    return {value[0].get<double>(), value[1].get<double>()};
}

SectionWish section_from(const Json& value) {
    SectionWish wish;
    wish.name = value.is_object() ? strat::json_text(value, "name") : strat::json_scalar_text(value);
    if (wish.name.empty()) refuse("section: it has no name");
    const Json* from = strat::json_member(value, "from");
    const Json* to = strat::json_member(value, "to");
    if (from != nullptr && to != nullptr) wish.line = {place_from(*from), place_from(*to)};
    return wish;
}

// Tables of some programs keep whole numbers as 1017.0.
std::string word_of(const Json& value) {
    const std::string word = strat::json_scalar_text(value);
    return value.is_number_float() && word.ends_with(".0") ? word.substr(0, word.size() - 2) : word;
}

// All but the section are one word or number.
constexpr std::array<std::string_view, 11> kPlainProperties = {
    "unit", "area", "day", "surface", "category", "notes", "seenin", "drawnon", "onplane", "sigma", "shows"};

void refuse_list(std::string_view key, const Json& value) {
    if (!value.is_structured()) return;
    if (std::find(kPlainProperties.begin(), kPlainProperties.end(), key) == kPlainProperties.end()) return;
    refuse(fmt::format("{} is {} and not one word or number", key, value.is_array() ? "a list" : "an object"));
}

bool read_property(DrawnOutline& outline, const std::string& key, const Json& value) {
    refuse_list(key, value);
    const std::string word = word_of(value);
    const std::string trimmed{text::trim(word)};
    if (key == "unit")
        outline.unit = trimmed;
    else if (key == "area")
        outline.area = trimmed;
    else if (key == "day")
        outline.day = date_from("day", trimmed);
    else if (key == "surface")
        outline.surface = trimmed;
    else if (key == "category")
        read_category(outline, trimmed);
    else if (key == "notes")
        outline.notes = word;
    else if (key == "seenin")
        outline.seen_in = trimmed;
    else if (key == "drawnon")
        outline.drawn_on = trimmed.empty() ? outline.drawn_on : trimmed;
    else if (key == "onplane")
        outline.on_plane = trimmed == "true";
    else if (key == "section") {
        if (!value.is_null()) outline.section = section_from(value);
    } else if (key == "sigma") {
        outline.sigma = number_from("sigma", trimmed);
    } else if (key == "shows") {
        if (trimmed.empty()) return true;
        outline.shows = model::region_shows_from_word(text::fold_case(trimmed));
        if (!outline.shows)
            refuse("shows: " + trimmed + " is none of top, level, cut, overdug, machine, face, nothing");
    } else {
        return false;
    }
    return true;
}

} // namespace

bool read_outline_property(DrawnOutline& outline, std::string_view name, const Json& value) {
    return read_property(outline, key_of(name), value);
}

geometry::Line3 ring_from_json(const Json& points) {
    if (!points.is_array()) refuse("a ring is no list of points");
    geometry::Line3 ring;
    for (const Json& point : points) {
        if (!point.is_array() || point.size() < 2 || point.size() > 4) refuse("a point is not [x, y] or [x, y, z]");
        geometry::Point3 p = {0.0, 0.0, std::numeric_limits<double>::quiet_NaN()};
        for (std::size_t i = 0; i < std::min<std::size_t>(point.size(), 3); ++i) {
            if (!point[i].is_number()) refuse("a coordinate is no number");
            p[i] = point[i].get<double>();
        }
        ring.push_back(p);
    }
    if (ring.size() > 1 && ring.front()[0] == ring.back()[0] && ring.front()[1] == ring.back()[1]) ring.pop_back();
    return ring;
}

} // namespace planum::app
