// SPDX-License-Identifier: MIT
#include "strat/exchange/unit_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/base/text.hpp"

namespace planum::strat {

namespace {

// Words of single programs that the digger's words do not know.
struct OtherWord {
    std::string_view word;
    model::KindAndForm meaning;
};

constexpr std::array kOtherWords = {
    OtherWord{"structural", {model::UnitKind::Structure, model::UnitForm::None}},
    OtherWord{"positive", {model::UnitKind::Deposit, model::UnitForm::None}},
    OtherWord{"fills", {model::UnitKind::Deposit, model::UnitForm::Fill}},
    OtherWord{"packing", {model::UnitKind::Deposit, model::UnitForm::Fill}},
    OtherWord{"post hole", {model::UnitKind::Cut, model::UnitForm::None}},
    OtherWord{"post-hole", {model::UnitKind::Cut, model::UnitForm::None}},
    OtherWord{"posthole", {model::UnitKind::Cut, model::UnitForm::None}},
    OtherWord{"ditch", {model::UnitKind::Cut, model::UnitForm::None}},
    OtherWord{"earthwork", {model::UnitKind::Feature, model::UnitForm::None}},
};

std::optional<model::KindAndForm> kind_of_word(std::string_view word) {
    word = text::trim(word);
    if (word.empty()) return std::nullopt;
    if (const auto kind = model::kind_from_any_word(word)) return kind;
    const std::string folded = text::fold_case(word);
    for (const OtherWord& other : kOtherWords) {
        if (other.word == folded) return other.meaning;
    }
    return std::nullopt;
}

} // namespace

void add_custom_field(ImportedUnit& unit, std::string_view name, std::string_view value) {
    if (value.empty()) return;
    std::string line(value);
    std::replace(line.begin(), line.end(), '\n', ' ');
    std::string& custom = unit.values.details["custom"];
    custom += fmt::format("{}{}={}", custom.empty() ? "" : "\n", name, line);
}

std::optional<model::KindAndForm> kind_from_definition(std::string_view definition) {
    definition = text::trim(definition);
    if (definition.empty() || definition.size() > 200) return std::nullopt;
    if (const auto kind = kind_of_word(definition)) return kind;
    if (const std::size_t colon = definition.find(':'); colon != std::string_view::npos) {
        if (const auto kind = kind_of_word(definition.substr(colon + 1))) return kind;
        return kind_of_word(definition.substr(0, colon));
    }
    if (const auto kind = kind_of_word(definition.substr(0, definition.find(' ')))) return kind;
    const std::size_t last = definition.rfind(' ');
    return last == std::string_view::npos ? std::nullopt : kind_of_word(definition.substr(last + 1));
}

void set_kind(ImportedUnit& unit, std::string_view definition) {
    definition = text::trim(definition);
    if (definition.empty()) return;
    if (unit.values.title.empty()) unit.values.title = definition;
    if (const auto kind = kind_from_definition(definition)) {
        unit.values.kind = kind->kind;
        unit.values.form = kind->form;
    } else if (unit.values.title != definition) {
        add_custom_field(unit, "type", definition);
    }
}

std::optional<model::Year> year_from_text(std::string_view text) {
    const auto number = text::parse_double(text);
    if (!number || !(std::abs(*number) <= 1e6)) return std::nullopt;
    return static_cast<model::Year>(std::llround(*number));
}

} // namespace planum::strat
