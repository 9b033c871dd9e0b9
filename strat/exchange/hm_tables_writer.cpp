// SPDX-License-Identifier: MIT
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "strat/exchange/delimited_table.hpp"
#include "strat/exchange/write_support.hpp"
#include "strat/exchange/writers.hpp"

namespace planum::strat {

namespace {

using model::RelationKind;
using Cells = std::vector<std::string>;

/// Rows of one table; the header is its first.
class Table {
  public:
    explicit Table(const Cells& header) { add(header); }

    void add(const Cells& cells) {
        text_ += writer_.write(cells);
        ++rows_;
    }

    [[nodiscard]] bool has_rows() const { return rows_ > 1; }

    [[nodiscard]] const std::string& text() const { return text_; }

  private:
    RowWriter writer_;
    std::string text_;
    std::size_t rows_ = 0;
};

bool keeps_kind(const model::StratigraphicUnit& unit) {
    const bool known = unit.kind == model::UnitKind::Deposit || unit.kind == model::UnitKind::Interface;
    return known && unit.form == model::UnitForm::None;
}

std::string position_of(const model::StratigraphicUnit& unit) {
    const auto it = unit.details.find("position");
    const bool known = it != unit.details.end() && (it->second == "surface" || it->second == "basal");
    return known ? it->second : "other";
}

Table contexts(const RecordNames& names) {
    Table table({"label", "unit-type", "position", "period", "phase", "url"});
    for (const model::StratigraphicUnit& unit : names.record().units) {
        const bool interface = unit.kind == model::UnitKind::Interface || unit.kind == model::UnitKind::Cut;
        table.add({names.unit(unit.id), interface ? "interface" : "deposit", position_of(unit),
                   names.period(unit.period), names.phase(unit.phase), ""});
    }
    return table;
}

std::pair<Table, Table> relations(const RecordNames& names) {
    std::pair<Table, Table> tables{Table({"younger", "older", "url"}), Table({"first", "second"})};
    for (const std::size_t i : complete_relations(names)) {
        const model::PhysicalRelation& r = names.record().relations[i];
        const std::string subject = names.unit(r.subject);
        const std::string object = names.unit(r.object);
        if (model::time_meaning(r.kind) == model::TimeMeaning::SubjectLater) tables.first.add({subject, object, ""});
        if (r.kind == RelationKind::SameAs) tables.second.add({subject, object});
    }
    return tables;
}

Table events(const RecordNames& names, std::vector<std::string>& lost) {
    Table table({"theta", "context", "lab", "association"});
    std::size_t left_out = 0;
    std::size_t theta = 0;
    for (const model::Dating& dating : names.record().datings) {
        const bool radiocarbon = dating.kind == model::DatingKind::Radiocarbon;
        const bool later = dating.kind == model::DatingKind::AnteQuem && dating.association == "disparate";
        if (!names.has(dating.unit) || !(radiocarbon || later)) {
            ++left_out;
            continue;
        }
        const std::string association = dating.association == "disparate" || dating.association == "disjunct"
                                            ? dating.association
                                            : std::string{"direct"};
        table.add({std::to_string(++theta), names.unit(dating.unit), dating.label, association});
    }
    add_loss(lost, left_out, "datings not written, as they are no radiocarbon dates of a unit");
    add_loss(lost, theta, "radiocarbon dates written without their years");
    return table;
}

template<class Values, class NumberOf>
Table chronology(const Values& values, NumberOf number_of) {
    Table table({"id", "label", "attribute", "description"});
    for (const auto& value : values) table.add({number_of(value), value.title, "", value.description});
    return table;
}

std::string configuration(const std::vector<std::pair<std::string, std::string>>& tables) {
    std::string files = "[Input files]\n";
    std::string headers = "\n[Input file headers]\n";
    for (const auto& [role, file] : tables) {
        files += fmt::format("{} = {}\n", role, file);
        headers += fmt::format("{} = yes\n", role);
    }
    return files + headers;
}

} // namespace

Written write_hm_tables(const model::Record& record, const WriteOptions& options) {
    Carries carries;
    carries.kind = keeps_kind;
    carries.phases = true;
    carries.periods = true;
    carries.same_as = true;
    carries.datings = true;
    Written written;
    written.lost = losses(record, carries);
    const RecordNames names(record);
    std::size_t nested = 0;
    for (const model::Phase& phase : record.phases) nested += phase.period.is_nil() ? 0U : 1U;
    add_loss(written.lost, nested, "phases whose period is written only with their units");
    auto [observations, inferences] = relations(names);
    const std::array tables = {
        std::pair{std::string{"contexts"}, contexts(names)},
        std::pair{std::string{"observations"}, std::move(observations)},
        std::pair{std::string{"inferences"}, std::move(inferences)},
        std::pair{std::string{"periods"}, chronology(record.periods, [](const model::Period& p) { return p.number; })},
        std::pair{std::string{"phases"},
                  chronology(record.phases, [&](const model::Phase& p) { return names.phase(p.id); })},
        std::pair{std::string{"events"}, events(names, written.lost)},
    };
    std::vector<std::pair<std::string, std::string>> listed;
    for (const auto& [role, table] : tables) {
        // The first two always, so that the folder is known for what it is.
        if (!table.has_rows() && role != "contexts" && role != "observations") continue;
        listed.emplace_back(role, options.prefix + role + ".csv");
        written.files.push_back({role + ".csv", table.text()});
    }
    written.files.push_back({"hm.ini", configuration(listed)});
    return written;
}

} // namespace planum::strat
