// SPDX-License-Identifier: MIT
#include "strat/exchange/record_builder.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace planum::strat {

namespace {

constexpr std::size_t kMaxNotes = 20'000; // more than that says no more than that
constexpr std::size_t kMaxRawText = 200;
constexpr std::size_t kMaxUnits = 500'000; // the largest excavations have a tenth of that
constexpr std::size_t kMaxRelations = 4'000'000;
constexpr std::size_t kGlimpse = 1U << 16U;

// At most `limit` bytes, not cut within a character.
std::string shortened(std::string_view text, std::size_t limit) {
    if (text.size() <= limit) return std::string{text};
    std::size_t end = limit;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
    return std::string{text.substr(0, end)};
}

} // namespace

UnitName RecordBuilder::name(std::string_view text) const {
    const std::string_view trimmed = text::trim(text);
    const std::size_t colons = trimmed.find("::");
    if (colons == std::string_view::npos || colons == 0 || colons + 2 == trimmed.size()) return name({}, trimmed);
    return name(trimmed.substr(0, colons), trimmed.substr(colons + 2));
}

UnitName RecordBuilder::name(std::string_view area, std::string_view number) const {
    const std::string_view own = text::trim(area);
    return {own.empty() ? area_ : std::string{own}, std::string{text::trim(number)}};
}

std::string RecordBuilder::key(const UnitName& name) { return name.area + '\0' + name.number; }

ImportedUnit& RecordBuilder::unit(const UnitName& name, const Place& place) {
    const auto [it, is_new] = unit_at_.try_emplace(key(name), record.units.size());
    if (is_new) {
        if (record.units.size() >= kMaxUnits) {
            throw Error(ErrorCode::BadInput, fmt::format("{}: more than {} units", place.file, kMaxUnits));
        }
        ImportedUnit unit;
        unit.name = name;
        unit.values.number = name.number;
        unit.line = place.line;
        unit.file = place.file;
        record.units.push_back(std::move(unit));
    }
    return record.units[it->second];
}

void RecordBuilder::fill(std::string& field, std::string_view value, std::string_view what, const Place& place) {
    const std::string_view trimmed = text::trim(value);
    if (trimmed.empty() || field == trimmed) return;
    if (field.empty()) {
        field = trimmed;
        return;
    }
    note(place, "conflicting-value",
         fmt::format("{} is {} here and was {} before; the first is kept", what, shortened(trimmed, 60),
                     shortened(field, 60)));
}

StatedRelation* RecordBuilder::relate(const UnitName& subject, model::DirectedKind kind, const UnitName& object,
                                      const Place& place) {
    if (subject.number.empty() || object.number.empty()) {
        note(place, "empty-target",
             fmt::format("{} of {} names no other unit; the relation was left out", model::to_word(kind.kind),
                         subject.number.empty() ? "an empty number" : subject.number));
        return nullptr;
    }
    if (record.relations.size() >= kMaxRelations) {
        throw Error(ErrorCode::BadInput, fmt::format("{}: more than {} relations", place.file, kMaxRelations));
    }
    StatedRelation relation;
    relation.subject = kind.inverse ? object : subject;
    relation.object = kind.inverse ? subject : object;
    relation.kind = kind.kind;
    relation.side = kind.inverse ? model::StatementSide::Object : model::StatementSide::Subject;
    relation.line = place.line;
    relation.raw_text = shortened(place.raw_text, kMaxRawText);
    relation.file = place.file;
    record.relations.push_back(std::move(relation));
    return &record.relations.back();
}

ImportedGroup& RecordBuilder::group(std::string_view number) {
    const auto [it, is_new] = group_at_.try_emplace(std::string{number}, record.groups.size());
    if (is_new) {
        record.groups.emplace_back();
        record.groups.back().values.number = number;
    }
    return record.groups[it->second];
}

void RecordBuilder::add_member(std::string_view group_number, const UnitName& unit) {
    ImportedGroup& target = group(group_number);
    if (members_.emplace(std::string{group_number}, key(unit)).second) target.members.push_back(unit);
}

void RecordBuilder::note(const Place& place, std::string_view code, std::string message) {
    if (notes.size() >= kMaxNotes) {
        ++dropped_notes_;
        return;
    }
    notes.push_back({std::string{place.file}, place.line, std::string{code}, shortened(place.raw_text, kMaxRawText),
                     std::move(message)});
}

void RecordBuilder::add_notes(std::vector<ReadNote> more) {
    for (ReadNote& entry : more) notes.push_back(std::move(entry));
}

Imported<ImportedRecord> RecordBuilder::finish() {
    if (dropped_notes_ > 0) {
        notes.push_back({{}, 0, "too-many-notes", {}, fmt::format("{} further notes are not listed", dropped_notes_)});
    }
    std::set<std::string> periods;
    std::set<std::string> phases;
    for (const model::Period& period : record.periods) periods.insert(period.number);
    for (const ImportedPhase& phase : record.phases) phases.insert(phase.values.number);
    const auto add_period = [&](const std::string& number) {
        if (number.empty() || !periods.insert(number).second) return;
        record.periods.emplace_back();
        record.periods.back().number = number;
    };
    for (const ImportedPhase& phase : record.phases) add_period(phase.period);
    for (const ImportedUnit& unit : record.units) {
        add_period(unit.period);
        if (unit.phase.empty() || !phases.insert(unit.phase).second) continue;
        record.phases.emplace_back();
        record.phases.back().values.number = unit.phase;
        record.phases.back().period = unit.period;
    }
    return {std::move(record), std::move(notes)};
}

std::vector<std::string> split_list(std::string_view list, ListSeparator separator) {
    std::vector<std::string> parts;
    std::string part;
    const auto close = [&] {
        if (const std::string_view trimmed = text::trim(part); !trimmed.empty()) parts.emplace_back(trimmed);
        part.clear();
    };
    for (const char c : list) {
        const bool blank = c == ' ' || c == '\t' || c == '\n';
        const bool ends = c == ',' || (separator == ListSeparator::CommaOrBlank && blank) ||
                          (separator == ListSeparator::CommaOrSemicolon && c == ';');
        if (ends) {
            close();
        } else {
            part.push_back(c);
        }
    }
    close();
    return parts;
}

bool is_probably_text(std::string_view bytes) {
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return true;
    const std::string_view head = bytes.substr(0, kGlimpse);
    const auto strange = std::count_if(head.begin(), head.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20U && c != '\n' && c != '\r' && c != '\t' && c != '\f';
    });
    // A stray control character happens in typed records; a share of them is a binary file.
    return head.find('\0') == std::string_view::npos && strange * 50 <= std::ssize(head);
}

void require_text(const InputFile& file, std::string_view what) {
    if (file.is_database) {
        throw Error(ErrorCode::BadInput, fmt::format("{}: an SQLite database, not {}", file.name, what));
    }
    if (text::trim(file.bytes).empty()) throw Error(ErrorCode::BadInput, file.name + ": the file is empty");
    if (!is_probably_text(file.bytes)) {
        throw Error(ErrorCode::BadInput, fmt::format("{}: binary, not {}", file.name, what));
    }
}

DelimitedTable glimpse_table(const InputFile& file) {
    if (file.is_database || !is_probably_text(file.bytes)) return {};
    std::string_view head = std::string_view{file.bytes}.substr(0, kGlimpse);
    const bool wide = head.starts_with("\xFF\xFE") || head.starts_with("\xFE\xFF");
    if (head.size() < file.bytes.size() && !wide) {
        const std::size_t last = head.rfind('\n');
        if (last != std::string_view::npos) head = head.substr(0, last + 1);
    }
    return parse_table(head, file.name);
}

} // namespace planum::strat
