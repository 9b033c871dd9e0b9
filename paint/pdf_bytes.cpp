// SPDX-License-Identifier: MIT
#include "paint/pdf_bytes.hpp"

#include <charconv>
#include <cstddef>
#include <optional>

#include <fmt/format.h>

#include "core/base/error.hpp"

namespace planum::paint {

namespace {

std::optional<std::size_t> number_at(std::string_view pdf, std::size_t at) {
    std::size_t value = 0;
    if (at >= pdf.size()) return std::nullopt;
    const auto [end, trouble] = std::from_chars(pdf.data() + at, pdf.data() + pdf.size(), value);
    return trouble == std::errc{} && end != pdf.data() + at ? std::optional(value) : std::nullopt;
}

// Moves the places of all objects behind `from` by `shift` in the table at the end (ISO 32000-1, 7.5.4: lines of
// 20 bytes, the place in the first ten), and the place of the table itself.
bool move_objects(std::string& pdf, std::size_t from, std::ptrdiff_t shift) {
    constexpr std::string_view kStart = "startxref\n";
    constexpr std::string_view kTable = "xref\n0 ";
    constexpr std::size_t kLine = 20;
    constexpr std::size_t kDigits = 10;
    const auto moved = [shift](std::size_t place) {
        return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(place) + shift);
    };
    const std::size_t start = pdf.rfind(kStart);
    if (start == std::string::npos) return false;
    const auto table = number_at(pdf, start + kStart.size());
    if (!table || moved(*table) >= pdf.size() || pdf.compare(moved(*table), kTable.size(), kTable) != 0) return false;
    const auto count = number_at(pdf, moved(*table) + kTable.size());
    std::size_t line = pdf.find('\n', moved(*table) + kTable.size());
    if (!count || line == std::string::npos || line + *count * kLine > start) return false;
    for (++line; line + kLine <= start && number_at(pdf, line) && pdf[line + kDigits] == ' '; line += kLine) {
        const std::size_t place = *number_at(pdf, line);
        if (place > from) pdf.replace(line, kDigits, fmt::format("{:010}", moved(place)));
    }
    pdf.replace(start + kStart.size(), fmt::format("{}", *table).size(), fmt::format("{}", moved(*table)));
    return true;
}

} // namespace

void set_creation_date(std::string& pdf, std::string_view created_at) {
    std::string digits;
    for (const char ch : created_at) {
        if (ch >= '0' && ch <= '9' && digits.size() < 14) digits += ch;
    }
    if (digits.size() < 14) digits = "19700101000000";
    constexpr std::string_view kKey = "/CreationDate (D:";
    const std::size_t key = pdf.find(kKey);
    const std::size_t end = key == std::string::npos ? key : pdf.find(')', key);
    if (end == std::string::npos) throw Error(ErrorCode::Internal, "the PDF has no date where Qt writes it");
    const std::size_t at = key + kKey.size();
    const std::string date = digits + "Z";
    const auto shift = static_cast<std::ptrdiff_t>(date.size()) - static_cast<std::ptrdiff_t>(end - at);
    pdf.replace(at, end - at, date);
    if (shift != 0 && !move_objects(pdf, at, shift)) {
        throw Error(ErrorCode::Internal, "the PDF has no table of objects where Qt writes it");
    }
}

} // namespace planum::paint
