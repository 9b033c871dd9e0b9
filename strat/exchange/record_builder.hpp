// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "strat/exchange/delimited_table.hpp"
#include "strat/exchange/imported_record.hpp"
#include "strat/exchange/reader.hpp"

namespace planum::strat {

/// Where something stands in the files, and what stands there.
struct Place {
    std::string_view file;
    std::int64_t line = 0;
    std::string_view raw_text;
};

/// What all readers do alike while they gather a record: one sheet for each unit, relations turned to
/// the younger side, notes, and in the end the phases and periods that units name but no table lists.
class RecordBuilder {
  public:
    explicit RecordBuilder(const ReadOptions& options) : area_(options.area) {}

    ImportedRecord record;
    std::vector<ReadNote> notes;

    /// Trims; `AREA::NUMBER` is taken apart; without an area of its own it gets that of the options. Names stay whole
    /// however long they are: two that differ only at their ends are two units.
    [[nodiscard]] UnitName name(std::string_view text) const;
    [[nodiscard]] UnitName name(std::string_view area, std::string_view number) const;

    /// The sheet of that unit; made at the first call. The reference holds until the next call.
    ImportedUnit& unit(const UnitName& name, const Place& place);

    /// Whether unit() was called for it.
    [[nodiscard]] bool has_unit(const UnitName& name) const { return unit_at_.contains(key(name)); }

    /// Writes a text field of a sheet: fills an empty one, reports a differing one (code
    /// conflicting-value) and keeps the first.
    void fill(std::string& field, std::string_view value, std::string_view what, const Place& place);

    /// `subject kind object` as written on the subject's sheet; `inverse` turns it round. Returns the
    /// relation for further marks; nullptr, with a note, when a name is empty.
    StatedRelation* relate(const UnitName& subject, model::DirectedKind kind, const UnitName& object,
                           const Place& place);

    /// A group by its number, made at the first call; members are kept distinct.
    ImportedGroup& group(std::string_view number);
    void add_member(std::string_view group_number, const UnitName& unit);

    void note(const Place& place, std::string_view code, std::string message);

    /// Adds the notes of a table or text.
    void add_notes(std::vector<ReadNote> more);

    /// Adds periods and phases that units name and no table lists; hands the record over.
    [[nodiscard]] Imported<ImportedRecord> finish();

  private:
    [[nodiscard]] static std::string key(const UnitName& name);

    std::string area_;
    std::unordered_map<std::string, std::size_t> unit_at_;
    std::map<std::string, std::size_t, std::less<>> group_at_;
    std::set<std::pair<std::string, std::string>> members_;
    std::size_t dropped_notes_ = 0;
};

/// Splits a list on commas (and on blanks, where asked), trimmed, without empty parts.
enum class ListSeparator { Comma, CommaOrBlank, CommaOrSemicolon };
[[nodiscard]] std::vector<std::string> split_list(std::string_view list, ListSeparator separator);

/// No zero bytes among the first ones, unless a UTF-16 mark says why.
[[nodiscard]] bool is_probably_text(std::string_view bytes);

/// Throws BadInput naming the file when it is empty, a database or no text; `what` was looked for.
void require_text(const InputFile& file, std::string_view what);

/// The first rows of a file as a table; what recognising looks at.
[[nodiscard]] DelimitedTable glimpse_table(const InputFile& file);

} // namespace planum::strat
