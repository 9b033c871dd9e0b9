// SPDX-License-Identifier: MIT

// PolyChron: up to five small tables, told apart by their headers.

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/readers.hpp"
#include "strat/exchange/record_builder.hpp"

namespace planum::strat {

namespace {

enum class Kind { Order, GroupOrder, Dates, Groups, Equality };

struct Table {
    Kind kind = Kind::Order;
    std::string file;
    std::vector<TableRow> rows; ///< without the header
};

std::optional<Kind> kind_of(const TableHeader& header, std::string_view file) {
    const auto has = [&header](std::string_view name) { return header.has(name); };
    if (has("above") && has("below") && !has("context")) {
        if (has("relationship")) return Kind::GroupOrder;
        if (header.names().size() > 2) return std::nullopt;
        // The two tables of pairs look alike; reading settles it by the names in the table of groups.
        return text::fold_case(file).find("group") != std::string::npos ? Kind::GroupOrder : Kind::Order;
    }
    if (has("context") && has("date") && has("error")) return Kind::Dates;
    if (has("context") && has("group") && header.names().size() == 2) return Kind::Groups;
    if (has("context_1") && has("context_2")) return Kind::Equality;
    return std::nullopt;
}

class PolychronReader {
  public:
    explicit PolychronReader(const ReadOptions& options) : builder_(options) {}

    void add(const InputFile& file) {
        require_text(file, "a PolyChron table");
        DelimitedTable table = parse_table(file.bytes, file.name);
        builder_.add_notes(std::move(table.notes));
        const auto kind = table.rows.empty() ? std::nullopt : kind_of(TableHeader(table.rows.front()), file.name);
        if (!kind) {
            throw Error(ErrorCode::BadInput,
                        file.name + ": the first line is none of PolyChron's (above,below; context,date,error; "
                                    "context,Group; above,below,relationship; context_1,context_2)");
        }
        header_[file.name] = table.rows.front();
        table.rows.erase(table.rows.begin());
        tables_.push_back({*kind, file.name, std::move(table.rows)});
    }

    Imported<ImportedRecord> finish() {
        for (const Table& table : tables_) {
            if (table.kind == Kind::Groups) read_groups(table);
        }
        for (Table& table : tables_) {
            if (table.kind == Kind::Order && names_groups(table)) table.kind = Kind::GroupOrder;
        }
        for (const Table& table : tables_) {
            switch (table.kind) {
            case Kind::Order: read_order(table); break;
            case Kind::Dates: read_dates(table); break;
            case Kind::Equality: read_equality(table); break;
            case Kind::GroupOrder: read_group_order(table); break;
            case Kind::Groups: break;
            }
        }
        rank_phases();
        return builder_.finish();
    }

  private:
    [[nodiscard]] std::string_view get(const Table& table, const TableRow& row, std::string_view column) const {
        return cell(row, TableHeader(header_.at(table.file)).find(column));
    }

    // Every name of the table is a group's, and not all of them are units' as well.
    [[nodiscard]] bool names_groups(const Table& table) const {
        bool all_units = true;
        for (const TableRow& row : table.rows) {
            for (const std::size_t column : {0U, 1U}) {
                const std::string name(cell(row, column));
                if (name.empty()) continue;
                if (!phases_.contains(name)) return false;
                all_units = all_units && builder_.has_unit(builder_.name(name));
            }
        }
        return !table.rows.empty() && !all_units;
    }

    void read_groups(const Table& table) {
        const TableHeader header(header_.at(table.file));
        for (const TableRow& row : table.rows) {
            const UnitName name = builder_.name(cell(row, header.find("context")));
            const std::string group(cell(row, header.find("group")));
            const Place place{table.file, row.line, group};
            if (name.number.empty() || group.empty()) {
                builder_.note(place, "unparsed", "a row without context or group; left out");
                continue;
            }
            ImportedUnit& unit = builder_.unit(name, place);
            builder_.fill(unit.phase, group, "the group of unit " + name.number, place);
            add_phase(group);
        }
    }

    void add_phase(const std::string& group) {
        if (!phases_.insert(group).second) return;
        builder_.record.phases.emplace_back().values.number = group;
    }

    void read_order(const Table& table) {
        const TableHeader header(header_.at(table.file));
        for (const TableRow& row : table.rows) {
            const std::string_view above = cell(row, header.find("above"));
            const std::string_view below = cell(row, header.find("below"));
            const std::string raw = fmt::format("{},{}", above, below);
            const Place place{table.file, row.line, raw};
            // A blank on one side is how a unit without relations is written.
            if (!above.empty()) builder_.unit(builder_.name(above), place);
            if (!below.empty()) builder_.unit(builder_.name(below), place);
            if (above.empty() || below.empty()) continue;
            StatedRelation* made = builder_.relate(builder_.name(above), {model::RelationKind::Covers, false},
                                                   builder_.name(below), place);
            if (made != nullptr) made->side = model::StatementSide::Neither;
        }
    }

    void read_dates(const Table& table) {
        const TableHeader header(header_.at(table.file));
        for (const TableRow& row : table.rows) {
            const UnitName name = builder_.name(cell(row, header.find("context")));
            const std::string_view date = cell(row, header.find("date"));
            const Place place{table.file, row.line, date};
            const auto age = text::parse_double(date);
            if (name.number.empty() || !age || !(*age >= 0.0 && *age < 1e6)) {
                builder_.note(place, "unparsed", "a date without context or without years before present; left out");
                continue;
            }
            builder_.unit(name, place);
            ImportedDating& dating = builder_.record.datings.emplace_back();
            dating.unit = name;
            dating.values.kind = model::DatingKind::Radiocarbon;
            dating.values.bp = age;
            dating.values.bp_error = text::parse_double(cell(row, header.find("error")));
            if (!dating.values.bp_error) builder_.note(place, "unparsed", "a date without error; kept without one");
        }
    }

    void read_equality(const Table& table) {
        for (const TableRow& row : table.rows) {
            const std::string_view first = get(table, row, "context_1");
            const std::string_view second = get(table, row, "context_2");
            const std::string raw = fmt::format("{},{}", first, second);
            StatedRelation* made = builder_.relate(builder_.name(first), {model::RelationKind::SameAs, false},
                                                   builder_.name(second), {table.file, row.line, raw});
            if (made != nullptr) made->side = model::StatementSide::Neither;
        }
    }

    void read_group_order(const Table& table) {
        for (const TableRow& row : table.rows) {
            const std::string above(get(table, row, "above"));
            const std::string below(get(table, row, "below"));
            if (!above.empty()) add_phase(above);
            if (!below.empty()) add_phase(below);
            if (above.empty() || below.empty()) continue;
            if (above == below) {
                builder_.note({table.file, row.line, above}, "self-relation",
                              fmt::format("group {} is said to be above itself; left out", above));
                continue;
            }
            later_groups_[below].insert(above);
            if (const std::string_view how = get(table, row, "relationship"); !how.empty()) {
                joins_[above] += fmt::format("{}{} {}", joins_[above].empty() ? "" : ", ", how, below);
            }
        }
    }

    // Ranks count up from the earliest group: one more than the highest of those below.
    void rank_phases() {
        std::map<std::string, std::int64_t> rank;
        std::map<std::string, int> open; // groups below that have no rank yet
        for (const auto& [below, aboves] : later_groups_) {
            open.try_emplace(below, 0);
            for (const std::string& above : aboves) ++open[above];
        }
        std::vector<std::string> ready;
        for (const auto& [group, count] : open) {
            if (count == 0) ready.push_back(group);
        }
        while (!ready.empty()) {
            const std::string group = ready.back();
            ready.pop_back();
            rank.try_emplace(group, 1);
            for (const std::string& above : later_groups_[group]) {
                rank[above] = std::max(rank[above], rank[group] + 1);
                if (--open[above] == 0) ready.push_back(above);
            }
        }
        const bool cycle = std::any_of(open.begin(), open.end(), [](const auto& entry) { return entry.second > 0; });
        if (cycle) {
            builder_.note({tables_.empty() ? std::string_view{} : std::string_view(tables_.back().file), 0, {}},
                          "group-cycle", "the order of the groups runs in a circle; they were left without ranks");
        }
        for (ImportedPhase& phase : builder_.record.phases) {
            if (const auto found = rank.find(phase.values.number); !cycle && found != rank.end()) {
                phase.values.rank = found->second;
            }
            phase.values.description = joins_[phase.values.number];
        }
    }

    RecordBuilder builder_;
    std::vector<Table> tables_;
    std::map<std::string, TableRow> header_;
    std::set<std::string> phases_;
    std::map<std::string, std::set<std::string>> later_groups_; ///< groups above each group
    std::map<std::string, std::string> joins_;                  ///< "abutting 1", by the upper group
};

Recognition recognise(std::span<const InputFile> files) {
    Recognition out;
    bool companions = false;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const DelimitedTable table = glimpse_table(files[i]);
        if (table.rows.empty()) continue;
        const auto kind = kind_of(TableHeader(table.rows.front()), files[i].name);
        if (!kind) continue;
        companions = companions || *kind != Kind::Order;
        out.files.push_back(i);
    }
    if (out.files.empty()) return out;
    out.confidence = companions ? Confidence::Certain : Confidence::Likely;
    out.why = companions ? "tables above,below; context,date,error; context,Group; context_1,context_2"
                         : "columns above, below";
    return out;
}

Imported<ImportedRecord> read(std::span<const InputFile* const> files, const ReadOptions& options, Progress& progress) {
    PolychronReader reader(options);
    for (const InputFile* file : files) {
        progress.check();
        reader.add(*file);
    }
    return reader.finish();
}

} // namespace

const Reader& polychron_reader() {
    static const Reader reader = {"polychron", "PolyChron tables (.csv)", recognise, read};
    return reader;
}

} // namespace planum::strat
