// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/hm_tables_roles.hpp"
#include "strat/exchange/readers.hpp"
#include "strat/exchange/record_builder.hpp"

namespace planum::strat {

namespace {

using model::RelationKind;

/// One table with its columns found, by header or by place.
class HmTable {
  public:
    HmTable(const DelimitedTable& table, std::string_view file, const HmAssigned& assigned)
        : table_(&table), file_(file), role_(assigned.role) {
        const std::vector<std::string_view>& columns = hm_role_info(role_).columns;
        if (assigned.header != HeaderLine::No && !table.rows.empty()) {
            const TableHeader header(table.rows.front());
            if (header.has(columns.at(0)) && header.has(columns.at(1))) {
                first_row_ = 1;
                names_ = header.names();
                return;
            }
            first_row_ = assigned.header == HeaderLine::Yes ? 1 : 0; // a header in other words: by place
        }
        names_.assign(columns.begin(), columns.end());
    }

    [[nodiscard]] std::span<const TableRow> rows() const {
        return std::span{table_->rows}.subspan(std::min(first_row_, table_->rows.size()));
    }

    [[nodiscard]] std::string value(const TableRow& row, std::string_view column) const {
        const auto it = std::find(names_.begin(), names_.end(), column);
        if (it == names_.end()) return {};
        return std::string{cell(row, static_cast<std::size_t>(it - names_.begin()))};
    }

    /// `name=value; …` of the columns that are not among those given.
    [[nodiscard]] std::string others(const TableRow& row, std::span<const std::string_view> known) const {
        std::vector<std::string> parts;
        for (std::size_t i = 0; i < names_.size(); ++i) {
            if (std::find(known.begin(), known.end(), names_[i]) != known.end()) continue;
            const std::string_view text = cell(row, i);
            if (!text.empty()) parts.push_back(names_[i] + "=" + std::string{text});
        }
        return text::join(parts, "; ");
    }

    [[nodiscard]] Place place(const TableRow& row) const { return {file_, row.line, {}}; }

    [[nodiscard]] std::string_view file() const { return file_; }

    [[nodiscard]] HmRole role() const { return role_; }

  private:
    const DelimitedTable* table_;
    std::string_view file_;
    HmRole role_;
    std::size_t first_row_ = 0;
    std::vector<std::string> names_;
};

void read_contexts(const HmTable& table, RecordBuilder& builder) {
    for (const TableRow& row : table.rows()) {
        const UnitName name = builder.name(table.value(row, "label"));
        const Place place = table.place(row);
        if (name.number.empty()) {
            builder.note(place, "unparsed", "a context without a label was left out");
            continue;
        }
        ImportedUnit& unit = builder.unit(name, place);
        const std::string type = table.value(row, "unit_type");
        if (const auto kind = model::kind_from_any_word(type)) {
            unit.values.kind = kind->kind;
            unit.values.form = kind->form;
        } else if (!type.empty()) {
            builder.note({place.file, place.line, type}, "unknown-type",
                         fmt::format("the unit type {} of {} is not known", type, name.number));
        }
        const std::string position = table.value(row, "position");
        if (position != "other") builder.fill(unit.values.details["position"], position, "the position", place);
        if (position.empty() || position == "other") unit.values.details.erase("position");
        unit.period = table.value(row, "period");
        unit.phase = table.value(row, "phase");
        constexpr std::array<std::string_view, 5> kKnown = {"label", "unit_type", "position", "period", "phase"};
        const std::string others = table.others(row, kKnown);
        if (!others.empty()) unit.values.details["custom"] = text::replace_all(others, "; ", "\n");
    }
}

void read_pairs(const HmTable& table, RecordBuilder& builder) {
    const bool inference = table.role() == HmRole::Inferences;
    for (const TableRow& row : table.rows()) {
        const std::string first = table.value(row, inference ? "first" : "younger");
        const std::string second = table.value(row, inference ? "second" : "older");
        const std::string raw = first + "," + second;
        const RelationKind kind = inference ? RelationKind::SameAs : RelationKind::Covers;
        StatedRelation* relation =
            builder.relate(builder.name(first), {kind, false}, builder.name(second), {table.file(), row.line, raw});
        if (relation == nullptr) continue;
        relation->side = model::StatementSide::Neither; // a list beside the sheets
        relation->correlation = inference;              // one deposit, recorded in two places
    }
}

void read_chronology(const HmTable& table, RecordBuilder& builder) {
    bool styled = false;
    for (const TableRow& row : table.rows()) {
        const std::string id = table.value(row, "id");
        if (id.empty()) {
            builder.note(table.place(row), "unparsed", "a line without an id was left out");
            continue;
        }
        styled = styled || !table.value(row, "attribute").empty();
        std::string description = table.value(row, "description");
        if (description.empty()) description = table.value(row, "url");
        const auto set = [&](auto& values) {
            values.number = id;
            values.title = table.value(row, "label");
            values.description = std::move(description);
        };
        if (table.role() == HmRole::Periods) {
            builder.record.periods.emplace_back();
            set(builder.record.periods.back());
        } else {
            builder.record.phases.emplace_back();
            set(builder.record.phases.back().values);
        }
    }
    if (styled) {
        builder.note({table.file(), 0, {}}, "not-kept", "the column attribute styles a drawing and was not kept");
    }
}

/// The association in the words of the model; empty when it is none of them.
std::string association_of(std::string_view word) {
    const std::string folded = text::fold_case(word);
    if (folded == "direct" || folded == "associated" || folded == "association") return "direct";
    if (folded == "disjunct" || folded == "disjunction") return "disjunct";
    if (folded == "disparate" || folded == "disparity") return "disparate";
    return {};
}

/// Events by their number, so that an order between events finds them.
using EventPlaces = std::map<std::string, std::size_t>;

void read_events(const HmTable& table, RecordBuilder& builder, EventPlaces& events,
                 std::set<std::pair<std::string, std::string>>& seen) {
    constexpr std::array<std::string_view, 4> kKnown = {"theta", "context", "lab", "association"};
    std::size_t repeated = 0;
    for (const TableRow& row : table.rows()) {
        const UnitName unit = builder.name(table.value(row, "context"));
        const std::string lab = table.value(row, "lab");
        const std::string word = table.value(row, "association");
        const Place place{table.file(), row.line, word};
        if (unit.number.empty()) {
            builder.note(place, "empty-target", fmt::format("the event {} names no context; left out", lab));
            continue;
        }
        if (!seen.emplace(unit.number, lab).second) {
            ++repeated;
            continue;
        }
        const std::string association = association_of(word);
        if (association.empty() && !word.empty()) {
            builder.note(place, text::fold_case(word) == "rejected" ? "rejected-dating" : "unknown-association",
                         fmt::format("{} of {} is marked {}; left out", lab, unit.number, word));
            continue;
        }
        ImportedDating dating;
        dating.unit = unit;
        dating.values.label = lab;
        dating.values.kind = association == "disparate" ? model::DatingKind::AnteQuem : model::DatingKind::Radiocarbon;
        dating.values.association = association;
        dating.values.notes = table.others(row, kKnown);
        events.emplace(table.value(row, "theta"), builder.record.datings.size());
        builder.record.datings.push_back(std::move(dating));
    }
    if (repeated > 0) {
        builder.note(
            {table.file(), 0, {}}, "repeated",
            fmt::format("{} events stand here again, same laboratory number and context; the first count", repeated));
    }
}

// The record has no order between events; it is kept in words with the younger one.
void read_event_order(const HmTable& table, RecordBuilder& builder, const EventPlaces& events) {
    for (const TableRow& row : table.rows()) {
        const std::string older = table.value(row, "older");
        const std::string younger = table.value(row, "younger");
        const auto early = events.find(older);
        const auto late = events.find(younger);
        const std::string raw = older + "," + younger;
        if (early == events.end() || late == events.end()) {
            builder.note({table.file(), row.line, raw}, "empty-target", "the order names an event that is not listed");
            continue;
        }
        const ImportedDating& earlier = builder.record.datings[early->second];
        std::string& notes = builder.record.datings[late->second].values.notes;
        notes +=
            fmt::format("{}later than {} of {}", notes.empty() ? "" : "; ", earlier.values.label, earlier.unit.number);
        builder.note({table.file(), row.line, raw}, "kept-as-text",
                     "an order between two datings was kept as a remark of the later one");
    }
}

Recognition recognise(std::span<const InputFile> files) {
    Recognition result;
    HmConfiguration configuration;
    std::vector<std::size_t> weak;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (!is_hm_guide(files[i])) continue;
        read_hm_guide(files[i], configuration);
        weak.push_back(i);
    }
    result.why = "columns of hm tables (label, unit-type; younger, older; first, second)";
    for (std::size_t i = 0; i < files.size(); ++i) {
        const bool is_guide_file = std::find(weak.begin(), weak.end(), i) != weak.end();
        const DelimitedTable table = is_guide_file ? DelimitedTable{} : glimpse_table(files[i]);
        if (table.rows.empty()) continue;
        const auto by_header = hm_role_from_header(files[i], table);
        if (by_header == HmRole::Contexts || by_header == HmRole::Observations || by_header == HmRole::Events ||
            by_header == HmRole::EventOrder) {
            result.files.push_back(i);
            result.confidence = Confidence::Certain;
        } else if (configuration.files.contains(files[i].name)) {
            result.files.push_back(i);
            result.confidence = std::max(result.confidence, Confidence::Likely);
        } else if (by_header) {
            weak.push_back(i);
        }
    }
    // An ini, or a list of periods or inferences alone, is worth something only beside the others.
    if (result.confidence == Confidence::No && !weak.empty()) {
        std::erase_if(weak, [&](std::size_t i) { return is_hm_guide(files[i]); });
        if (!weak.empty()) result.confidence = Confidence::Possible;
    }
    result.files.insert(result.files.end(), weak.begin(), weak.end());
    std::sort(result.files.begin(), result.files.end());
    return result;
}

Imported<ImportedRecord> read(std::span<const InputFile* const> files, const ReadOptions& options, Progress& progress) {
    RecordBuilder builder(options);
    HmConfiguration configuration;
    for (const InputFile* file : files) {
        if (is_hm_guide(*file)) read_hm_guide(*file, configuration);
    }
    std::vector<DelimitedTable> parsed;
    parsed.reserve(files.size());
    std::vector<HmTable> tables;
    for (const InputFile* file : files) {
        progress.check();
        if (is_hm_guide(*file)) continue;
        require_text(*file, "a table of hm");
        parsed.push_back(parse_table(file->bytes, file->name));
        builder.add_notes(std::move(parsed.back().notes));
        const auto assigned = assign_hm_role(*file, parsed.back(), configuration);
        if (!assigned) {
            throw Error(ErrorCode::BadInput,
                        fmt::format("{}: no table of hm; looked for the columns label, unit-type or younger, older or "
                                    "first, second or theta, context or id, label, attribute, for an ini that names "
                                    "it, and for a telling file name",
                                    file->name));
        }
        tables.emplace_back(parsed.back(), file->name, *assigned);
    }
    if (tables.empty()) {
        throw Error(ErrorCode::BadInput, fmt::format("{}: no table beside it; give the tables it names too",
                                                     files.empty() ? "" : files.front()->name));
    }
    EventPlaces events;
    std::set<std::pair<std::string, std::string>> seen;
    for (const HmTable& table : tables) {
        switch (table.role()) {
        case HmRole::Contexts: read_contexts(table, builder); break;
        case HmRole::Observations:
        case HmRole::Inferences: read_pairs(table, builder); break;
        case HmRole::Periods:
        case HmRole::Phases: read_chronology(table, builder); break;
        case HmRole::Events: read_events(table, builder, events, seen); break;
        case HmRole::EventOrder: break;
        }
    }
    for (const HmTable& table : tables) {
        if (table.role() == HmRole::EventOrder) read_event_order(table, builder, events);
    }
    return builder.finish();
}

} // namespace

const Reader& hm_tables_reader() {
    static const Reader reader{"hm", "hm and HMDP tables (contexts, observations, …)", recognise, read};
    return reader;
}

} // namespace planum::strat
