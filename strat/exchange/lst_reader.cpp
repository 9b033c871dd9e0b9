// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/readers.hpp"
#include "strat/exchange/record_builder.hpp"

namespace planum::strat {

namespace {

using model::DirectedKind;
using model::RelationKind;

struct Key {
    std::string_view word;
    DirectedKind kind;
};

// Under unit U, `below: X` says that X lies below U; `above: X` that X lies above it.
constexpr std::array kRelationKeys = {
    Key{"below", {RelationKind::Covers, false}},
    Key{"above", {RelationKind::Covers, true}},
    Key{"contemporary with", {RelationKind::Contemporary, false}},
    Key{"equal to", {RelationKind::SameAs, false}},
};

bool is_blank(char c) { return c == ' ' || c == '\t'; }

// The colon that ends a key: the first one that is not half of `::`.
std::size_t colon_after_key(std::string_view line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] != ':') continue;
        if (i + 1 < line.size() && line[i + 1] == ':') {
            ++i;
            continue;
        }
        return i;
    }
    return std::string_view::npos;
}

struct Entry {
    std::string key; ///< folded
    std::string_view list;
};

std::optional<Entry> parse_entry(std::string_view line) {
    const std::size_t colon = colon_after_key(line);
    if (colon == std::string_view::npos) return std::nullopt;
    return Entry{text::fold_case(text::trim(line.substr(0, colon))), text::trim(line.substr(colon + 1))};
}

/// Reads one file: remembers under which unit it is.
class LstParser {
  public:
    LstParser(RecordBuilder& builder, std::string_view file) : builder_(builder), file_(file) {}

    void parse(std::string_view text) {
        std::int64_t number = 0;
        while (!text.empty()) {
            const std::size_t end = text.find('\n');
            const std::string_view line = text.substr(0, end);
            text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
            ++number;
            if (number <= 3) {
                read_header(line);
                continue;
            }
            if (text::trim(line).empty()) continue;
            const Place place{file_, number, text::trim(line)};
            if (is_blank(line.front())) {
                read_entry(place);
            } else {
                read_unit(place);
            }
        }
        for (const auto& [group, member] : parts_) put_into_group(member, group);
    }

  private:
    void read_header(std::string_view line) {
        constexpr std::string_view kTitle = "stratigraphic dataset";
        const std::string_view trimmed = text::trim(line);
        if (!text::fold_case(trimmed).starts_with(kTitle)) return;
        const std::string_view name = text::trim(trimmed.substr(kTitle.size()));
        if (builder_.record.project_name.empty()) builder_.record.project_name = name;
    }

    // `12   Floor`, `12,Floor`, `SITE::12`.
    void read_unit(const Place& place) {
        const std::size_t end = place.raw_text.find_first_of(" \t,");
        const std::string_view name = place.raw_text.substr(0, end);
        const std::string_view label =
            end == std::string_view::npos ? std::string_view{} : text::trim(place.raw_text.substr(end + 1));
        current_ = builder_.name(name);
        current_text_ = name;
        if (current_->number.empty()) {
            builder_.note(place, "unparsed", "a unit without a number; what stands under it was left out");
            current_.reset();
            return;
        }
        ImportedUnit& unit = builder_.unit(*current_, place);
        builder_.fill(unit.values.title, label, "the label of " + unit.name.number, place);
    }

    void read_entry(const Place& place) {
        const auto entry = parse_entry(place.raw_text);
        if (!entry || !current_) {
            builder_.note(place, "unparsed",
                          current_ ? "no `key: list` under a unit; left out" : "an entry before any unit; left out");
            return;
        }
        for (const Key& key : kRelationKeys) {
            if (entry->key == key.word) return read_list(key.kind, entry->list, place);
        }
        if (entry->key == "part of") {
            for (std::string& group : split_list(entry->list, ListSeparator::CommaOrBlank)) {
                parts_.emplace_back(std::move(group), current_text_);
            }
        } else if (entry->key == "unit class") {
            read_class(entry->list, place);
        } else {
            builder_.note(place, "unknown-key", fmt::format("the key {} is not known; left out", entry->key));
        }
    }

    void read_list(DirectedKind kind, std::string_view list, const Place& place) {
        for (const std::string& other : split_list(list, ListSeparator::CommaOrBlank)) {
            builder_.relate(*current_, kind, builder_.name(other), place);
        }
    }

    // A group has a record like a unit; it is one all the same only if something else calls it so.
    void read_class(std::string_view word, const Place& place) {
        const std::string folded = text::fold_case(word);
        if (folded == "group") {
            builder_.group(current_text_).values.type = "group";
            groups_.emplace(*current_, current_text_);
        } else if (folded != "context" && !folded.empty()) {
            builder_.note(place, "unknown-class", fmt::format("the class {} is not known; taken as context", word));
        }
    }

    void put_into_group(const std::string& member, const std::string& group) {
        const UnitName name = builder_.name(member);
        if (groups_.contains(name)) {
            builder_.group(group); // make it exist before its part refers to it
            builder_.group(member).parent = group;
        } else {
            builder_.add_member(group, name);
        }
    }

  public:
    /// Records of class group, which are no units, with their names as written.
    [[nodiscard]] const std::map<UnitName, std::string>& groups() const { return groups_; }

  private:
    RecordBuilder& builder_;
    std::string_view file_;
    std::optional<UnitName> current_;
    std::string current_text_;
    std::map<UnitName, std::string> groups_;
    std::vector<std::pair<std::string, std::string>> parts_; ///< group, member
};

// Groups leave the units, and keep their label.
void take_groups_out(RecordBuilder& builder, const std::map<UnitName, std::string>& groups) {
    for (const ImportedUnit& unit : builder.record.units) {
        const auto group = groups.find(unit.name);
        if (group != groups.end()) builder.group(group->second).values.title = unit.values.title;
    }
    std::erase_if(builder.record.units, [&](const ImportedUnit& unit) { return groups.contains(unit.name); });
    std::erase_if(builder.record.relations, [&](const StatedRelation& relation) {
        if (!groups.contains(relation.subject) && !groups.contains(relation.object)) return false;
        builder.note({relation.file, relation.line, relation.raw_text}, "group-relation",
                     "a relation of a group of units was left out; only units have relations");
        return true;
    });
}

bool is_lst(const InputFile& file) {
    if (file.is_database || !is_probably_text(file.bytes)) return false;
    const std::string head = text::fold_case(std::string_view{file.bytes}.substr(0, 20'000));
    if (head.find("stratigraphic dataset") != std::string::npos) return true;
    // Without its title: unit lines in the first column and indented keys under them.
    std::size_t keys = 0;
    std::size_t line_number = 0;
    for (const std::string_view line : text::split(head, '\n')) {
        if (++line_number <= 3 || line.empty() || !is_blank(line.front())) continue;
        const auto entry = parse_entry(line);
        if (!entry) continue;
        keys += std::any_of(kRelationKeys.begin(), kRelationKeys.end(),
                            [&](const Key& key) { return key.word == entry->key; })
                    ? 1U
                    : 0U;
    }
    return keys > 0;
}

Recognition recognise(std::span<const InputFile> files) {
    Recognition result;
    result.why = "a title `Stratigraphic Dataset`, or indented above: and below: lists";
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (!is_lst(files[i])) continue;
        result.files.push_back(i);
        const bool named_so = text::fold_case(files[i].path.extension().string()) == ".lst";
        result.confidence = std::max(result.confidence, named_so ? Confidence::Certain : Confidence::Likely);
    }
    return result;
}

Imported<ImportedRecord> read(std::span<const InputFile* const> files, const ReadOptions& options, Progress& progress) {
    RecordBuilder builder(options);
    std::map<UnitName, std::string> groups;
    for (const InputFile* file : files) {
        progress.check();
        require_text(*file, "a .lst dataset");
        DecodedText decoded = decode_text(file->bytes, file->name);
        builder.add_notes(std::move(decoded.notes));
        LstParser parser(builder, file->name);
        parser.parse(decoded.text);
        groups.insert(parser.groups().begin(), parser.groups().end());
    }
    if (!groups.empty()) take_groups_out(builder, groups);
    if (builder.record.units.empty()) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("{}: no unit found; a .lst dataset has three lines of title, then unit numbers in "
                                "the first column with indented above: and below: lists",
                                files.empty() ? "" : files.front()->name));
    }
    return builder.finish();
}

} // namespace

const Reader& lst_reader() {
    static const Reader reader{"lst", "BASP, ArchEd, Stratify dataset (.lst)", recognise, read};
    return reader;
}

} // namespace planum::strat
