// SPDX-License-Identifier: MIT
#include "app/records/field_table.hpp"

#include "app/scans/days_surface.hpp"

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

std::vector<std::string> words_of(std::string_view list) {
    std::vector<std::string> words;
    for (const std::string_view word : text::split(list, ',')) words.emplace_back(text::trim(word));
    return words;
}

std::string date_from(const std::string& field, const std::string& text) {
    std::string date{text::trim(text)};
    if (date.empty()) return date;
    if (!is_day(date)) throw Error(ErrorCode::BadInput, fmt::format("{}: {} is no day; write YYYY-MM-DD", field, text));
    return date;
}

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
