// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/readers.hpp"
#include "strat/exchange/record_builder.hpp"
#include "strat/exchange/table_reader.hpp"

namespace planum::strat {

namespace {

using model::DirectedKind;
using model::RelationKind;

struct Verb {
    std::string_view word;
    DirectedKind kind;
};

// The words of the excavation books. What rests on or overlies something lies above it and is younger;
// what sits in something fills it; what intrudes cuts it.
constexpr std::array kVerbs = {
    Verb{"covers", {RelationKind::Covers, false}},
    Verb{"overlies", {RelationKind::Covers, false}},
    Verb{"overlays", {RelationKind::Covers, false}},
    Verb{"rests on", {RelationKind::Covers, false}},
    Verb{"cuts", {RelationKind::Cuts, false}},
    Verb{"intrudes into", {RelationKind::Cuts, false}},
    Verb{"intrudes", {RelationKind::Cuts, false}},
    Verb{"sits in", {RelationKind::Fills, false}},
    Verb{"fills", {RelationKind::Fills, false}},
    Verb{"abuts", {RelationKind::Abuts, false}},
    Verb{"bonds with", {RelationKind::BondsWith, false}},
    Verb{"is covered by", {RelationKind::Covers, true}},
    Verb{"is cut by", {RelationKind::Cuts, true}},
};

struct Sentence {
    std::string subject;
    DirectedKind kind;
    std::string object;
};

// `f68 covers f118`: a number, a verb, a number.
std::optional<Sentence> parse_sentence(std::string_view text) {
    const std::size_t first = text.find(' ');
    const std::size_t last = text.rfind(' ');
    if (first == std::string_view::npos || first >= last) return std::nullopt;
    const std::string verb = text::fold_case(text::trim(text.substr(first, last - first)));
    const auto it = std::find_if(kVerbs.begin(), kVerbs.end(), [&](const Verb& v) { return v.word == verb; });
    if (it == kVerbs.end()) return std::nullopt;
    return Sentence{std::string{text.substr(0, first)}, it->kind, std::string{text.substr(last + 1)}};
}

// The definition's first words say the kind: `lens type d`, `fill (upper)`, `wall`.
model::KindAndForm kind_of(std::string_view definition) {
    const std::string folded = text::fold_case(definition);
    for (std::size_t end = folded.size(); end > 0;) {
        if (const auto kind = model::kind_from_any_word(std::string_view{folded}.substr(0, end))) return *kind;
        const std::size_t blank = folded.find_last_of(" (", end - 1);
        if (blank == std::string::npos) break;
        end = blank;
    }
    if (folded.starts_with("hole")) return {model::UnitKind::Cut, model::UnitForm::None};
    return {};
}

/// Reads one transcription; the columns that hold words only go to the free fields.
class Transcription {
  public:
    Transcription(const DelimitedTable& table, std::string_view file, RecordBuilder& builder)
        : table_(table), header_(table.rows.front()), file_(file), builder_(builder) {}

    void read() {
        for (std::size_t i = 1; i < table_.rows.size(); ++i) read_row(table_.rows[i]);
    }

  private:
    [[nodiscard]] std::string value(const TableRow& row, std::string_view column) const {
        return std::string{cell(row, header_.find(column))};
    }

    void read_row(const TableRow& row) {
        const std::string book = value(row, "book");
        const UnitName name = builder_.name(book, value(row, "feature"));
        const Place place{file_, row.line, {}};
        if (name.number.empty()) {
            builder_.note(place, "unparsed", "a line without a feature number was left out");
            return;
        }
        ImportedUnit& unit = builder_.unit(name, place);
        const std::string definition = value(row, "definition");
        builder_.fill(unit.values.title, definition, "the definition of " + name.number, place);
        const model::KindAndForm kind = kind_of(definition);
        unit.values.kind = kind.kind;
        unit.values.form = kind.form;
        builder_.fill(unit.values.details["square"], value(row, "locus"), "the locus", place);
        if (unit.values.details["square"].empty()) unit.values.details.erase("square");
        add_custom(unit, row);
        add_chronology(unit, row);
        add_level(row, name, "elev_top_cm", model::LevelRole::Top);
        add_level(row, name, "elev_bottom_cm", model::LevelRole::Base);
        const std::string relations = value(row, "relations");
        for (const std::string_view sentence : text::split(relations, '|')) {
            add_relation(text::trim(sentence), name, place);
        }
        const std::string equals = value(row, "equals");
        for (const std::string_view other : text::split(equals, '|')) add_equal(text::trim(other), name, place);
    }

    void add_custom(ImportedUnit& unit, const TableRow& row) {
        constexpr std::array<std::string_view, 3> kKept = {"other_elev_cm", "known_problem", "url"};
        std::string custom;
        for (const std::string_view column : kKept) {
            const std::string text = value(row, column);
            if (!text.empty()) custom += fmt::format("{}{}={}", custom.empty() ? "" : "\n", column, text);
        }
        if (!custom.empty()) unit.values.details["custom"] = custom;
    }

    // A stratum is a phase, a phase of the books a period: strata follow each other within phases.
    void add_chronology(ImportedUnit& unit, const TableRow& row) {
        const std::string stratum = value(row, "stratum");
        const std::string phase = value(row, "phase");
        for (const std::string& text : {stratum, phase}) {
            if (text.find('|') == std::string::npos) continue;
            builder_.note({file_, row.line, text}, "conflicting-value",
                          fmt::format("{} is given {} at once; the first is kept", unit.name.number, text));
        }
        unit.phase = stratum.substr(0, stratum.find('|'));
        unit.period = phase.substr(0, phase.find('|'));
    }

    void add_level(const TableRow& row, const UnitName& name, std::string_view column, model::LevelRole role) {
        const std::string text = value(row, column);
        if (text.empty()) return;
        const auto centimetres = text::parse_double(text);
        if (!centimetres) {
            builder_.note({file_, row.line, text}, "unparsed", fmt::format("{} is no height in cm; left out", text));
            return;
        }
        ImportedLevel level;
        level.unit = name;
        level.values.z = *centimetres / 100.0; // [m]
        level.values.role = role;
        builder_.record.levels.push_back(std::move(level));
    }

    void add_relation(std::string_view text, const UnitName& sheet, const Place& at) {
        if (text.empty()) return;
        const Place place{at.file, at.line, text};
        const auto sentence = parse_sentence(text);
        if (!sentence) {
            builder_.note(place, "unknown-relation", "no sentence `f1 covers f2` with a known verb; left out");
            return;
        }
        const UnitName subject = builder_.name(sheet.area, sentence->subject);
        const UnitName object = builder_.name(sheet.area, sentence->object);
        StatedRelation* relation = builder_.relate(subject, sentence->kind, object, place);
        if (relation == nullptr) return;
        // The sentence stands on one sheet, of whichever unit it is about.
        relation->side = relation->subject == sheet  ? model::StatementSide::Subject
                         : relation->object == sheet ? model::StatementSide::Object
                                                     : model::StatementSide::Neither;
    }

    // `f117 in k84 and f118 in k85 (text)`, `J4f136 (same pit in another book)`.
    void add_equal(std::string_view text, const UnitName& sheet, const Place& at) {
        if (text.empty()) return;
        const Place place{at.file, at.line, text};
        std::vector<UnitName> others;
        const std::string spaced = text::replace_all(text.substr(0, text.find('(')), ",", " ");
        for (const std::string_view word : text::split(spaced, ' ')) {
            const std::size_t f = word.rfind('f');
            const bool numbered = f != std::string_view::npos && f + 1 < word.size() &&
                                  std::all_of(word.begin() + static_cast<std::ptrdiff_t>(f) + 1, word.end(),
                                              [](char c) { return c >= '0' && c <= '9'; });
            if (!numbered) continue;
            const std::string_view book = word.substr(0, f);
            others.push_back(builder_.name(book.empty() ? std::string_view{sheet.area} : book, word.substr(f)));
        }
        if (others.empty()) {
            builder_.note(place, "unparsed", "no feature number found in `equals`; left out");
        }
        for (const UnitName& other : others) builder_.relate(sheet, {RelationKind::SameAs, false}, other, place);
    }

    const DelimitedTable& table_;
    TableHeader header_;
    std::string_view file_;
    RecordBuilder& builder_;
};

bool has_columns(const DelimitedTable& table) {
    if (table.rows.empty()) return false;
    const TableHeader header(table.rows.front());
    return header.has("book") && header.has("feature") && header.has("relations");
}

void read_table(DelimitedTable& table, const InputFile& file, RecordBuilder& builder) {
    if (!has_columns(table)) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("{}: the columns book, feature and relations are missing", file.name));
    }
    Transcription(table, file.name, builder).read();
}

Recognition recognise(std::span<const InputFile> files) {
    return recognise_tables(files, has_columns, "columns book, feature, relations");
}

Imported<ImportedRecord> read(std::span<const InputFile* const> files, const ReadOptions& options, Progress& progress) {
    return read_tables(files, options, progress, "a transcription of excavation books", read_table);
}

} // namespace

const Reader& urkesh_reader() {
    static const Reader reader{"urkesh", "Transcription of excavation books (book, feature, relations)", recognise,
                               read};
    return reader;
}

} // namespace planum::strat
