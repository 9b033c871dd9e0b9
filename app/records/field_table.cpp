// SPDX-License-Identifier: MIT
#include "app/records/field_table.hpp"

#include <array>

namespace planum::app {

std::string text_of(const std::optional<double>& value) { return value ? fmt::format("{}", *value) : std::string{}; }

std::string text_of(const std::optional<std::int64_t>& value) {
    return value ? fmt::format("{}", *value) : std::string{};
}

std::optional<double> number_from(const std::string& field, const std::string& text) {
    if (text::trim(text).empty()) return std::nullopt;
    const auto value = text::parse_double(text);
    if (!value) throw Error(ErrorCode::BadInput, fmt::format("{}: {} is no number", field, text));
    return value;
}

std::optional<std::int64_t> integer_from(const std::string& field, const std::string& text) {
    if (text::trim(text).empty()) return std::nullopt;
    const auto value = text::parse_integer(text);
    if (!value) throw Error(ErrorCode::BadInput, fmt::format("{}: {} is no whole number", field, text));
    return *value;
}

std::string date_from(const std::string& field, const std::string& text) {
    const std::string date{text::trim(text)};
    if (date.empty()) return date;
    const auto part = [&](std::size_t at, std::size_t length) {
        return text::parse_integer(std::string_view(date).substr(at, length)).value_or(-1);
    };
    constexpr std::array<int, 12> kDays = {31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const bool shaped = date.size() == 10 && date[4] == '-' && date[7] == '-' && part(0, 4) >= 0;
    const auto month = shaped ? part(5, 2) : -1;
    const bool good =
        month >= 1 && month <= 12 && part(8, 2) >= 1 && part(8, 2) <= kDays.at(static_cast<std::size_t>(month - 1));
    if (!good) throw Error(ErrorCode::BadInput, fmt::format("{}: {} is no day; write YYYY-MM-DD", field, text));
    return date;
}

std::string day_from(const std::string& field, const std::string& text) { return date_from(field, text); }

std::span<const std::unique_ptr<RecordKind>> record_kinds() {
    static const std::vector<std::unique_ptr<RecordKind>> kinds = [] {
        std::vector<std::unique_ptr<RecordKind>> all;
        all.push_back(make_unit_kind());
        all.push_back(make_relation_kind());
        add_chronology_kinds(all);
        add_measured_kinds(all);
        add_place_kinds(all);
        add_interpretation_kind(all);
        return all;
    }();
    return kinds;
}

const RecordKind& record_kind(std::string_view word) {
    for (const auto& kind : record_kinds()) {
        if (kind->word() == word) return *kind;
    }
    throw Error(ErrorCode::Usage, fmt::format("nothing in the record is called {}", word));
}

} // namespace planum::app
