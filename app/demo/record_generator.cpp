// SPDX-License-Identifier: MIT
#include "app/demo/record_generator.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include <fmt/format.h>

#include "app/demo/digging.hpp"
#include "app/demo/random.hpp"
#include "app/demo/trench_history.hpp"
#include "core/base/error.hpp"
#include "core/base/uuid.hpp"

namespace planum::app {

namespace {

using model::RelationKind;
using model::StatementSide;
using model::UnitKind;

constexpr std::size_t kTrenchUnits = 120;
constexpr model::Year kFirstYear = -300;
constexpr model::Year kLastYear = 1200;
constexpr std::size_t kPhases = 6;

class Generator {
  public:
    explicit Generator(const RecordOptions& options) : o_(options), random_(options.seed), ids_(options.seed) {}

    GeneratedRecord run() {
        begin();
        std::size_t left = o_.units;
        const std::size_t trenches = std::max<std::size_t>(1, (o_.units + kTrenchUnits / 2) / kTrenchUnits);
        for (std::size_t t = 0; t < trenches; ++t) {
            const std::size_t share = left / (trenches - t);
            add_trench(t, share);
            left -= share;
        }
        return sorted();
    }

  private:
    const RecordOptions& o_;
    Random random_;
    SeededUuids ids_;
    GeneratedRecord out_;
    std::unordered_map<model::UnitId, double> formed_;
    model::SourceId source_;
    std::int64_t line_ = 1;

    template<class AnyId>
    AnyId id() {
        return AnyId{ids_.next()};
    }

    model::Record& record() { return out_.record; }

    void begin() {
        record().settings.name = "Generated record";
        model::Source source;
        source.id = source_ = id<model::SourceId>();
        source.name = "sheets.csv";
        source.format = "csv";
        source.states_both_sides = o_.both_sheets >= 0.5;
        record().sources.push_back(source);
        for (std::size_t p = 0; p < kPhases; ++p) {
            model::Phase phase;
            phase.id = id<model::PhaseId>();
            phase.number = std::to_string(p + 1);
            phase.rank = static_cast<std::int64_t>(p + 1);
            record().phases.push_back(phase);
        }
    }

    void add_trench(std::size_t trench, std::size_t units) {
        model::Area area;
        area.id = id<model::AreaId>();
        area.name = fmt::format("T{}", trench + 1);
        const std::size_t block = 1000 * (trench + 1);
        area.first_number = std::to_string(block + 1);
        area.last_number = std::to_string(block + 999);
        // Pits take some units away altogether; what is missing is simulated again with a few more.
        TrenchHistory history;
        for (std::size_t more = 0; history.units.size() < units; more += 4) {
            Random again(random_.next());
            history = simulate_trench(again, units + more);
        }
        cut_short(history, units);
        const Digging digging = dig(random_, history, block + 1, o_.number_blur);
        std::vector<model::UnitId> unit_ids;
        for (std::size_t u = 0; u < history.units.size(); ++u) {
            unit_ids.push_back(add_unit(area.id, history, u, digging));
            add_levels(unit_ids[u], history.units[u], static_cast<double>(trench) * 20.0);
            add_dating(unit_ids[u], relative_time(history, u));
        }
        add_relations(history, unit_ids);
        add_second_numbers(area, history, unit_ids, digging);
        record().areas.push_back(std::move(area));
    }

    // The last units to form are the uppermost; leaving them out harms no contact below.
    static void cut_short(TrenchHistory& history, std::size_t units) {
        history.units.resize(std::min(history.units.size(), units));
        std::erase_if(history.contacts, [&](const TrenchContact& c) {
            return c.later >= history.units.size() || c.earlier >= history.units.size();
        });
    }

    static double relative_time(const TrenchHistory& history, std::size_t u) {
        return static_cast<double>(u) / static_cast<double>(history.units.size());
    }

    model::UnitId add_unit(model::AreaId area, const TrenchHistory& history, std::size_t u, const Digging& digging) {
        const TrenchUnit& source = history.units[u];
        model::StratigraphicUnit unit;
        unit.id = id<model::UnitId>();
        unit.number = std::to_string(digging.number[u]);
        unit.area = area;
        const bool known = !random_.chance(o_.unknown_kind);
        unit.kind = known ? source.kind : UnitKind::Unknown;
        unit.form = known ? source.form : model::UnitForm::None;
        unit.status = model::UnitStatus::Excavated;
        unit.title = std::string{known ? model::to_word(source.kind) : std::string_view{"unit"}};
        unit.recorded_by = "A. N. Other";
        if (random_.chance(o_.dug_dates)) {
            const std::int64_t slip = random_.chance(0.02) ? static_cast<std::int64_t>(random_.below(21)) - 10 : 0;
            unit.excavated_on = iso_day(std::max<std::int64_t>(0, digging.day[u] + slip));
        }
        if (random_.chance(o_.phased)) {
            auto slice = static_cast<std::int64_t>(relative_time(history, u) * static_cast<double>(kPhases));
            if (random_.chance(0.02)) slice += random_.chance(0.5) ? 1 : -1;
            slice = std::clamp<std::int64_t>(slice, 0, static_cast<std::int64_t>(kPhases) - 1);
            unit.phase = record().phases[static_cast<std::size_t>(slice)].id;
        }
        formed_[unit.id] = source.formed;
        record().units.push_back(unit);
        return unit.id;
    }

    void add_levels(model::UnitId unit, const TrenchUnit& source, double offset_x) {
        if (!random_.chance(o_.levelled)) return;
        const std::size_t spots = 1 + random_.below(3);
        const bool with_position = random_.chance(o_.positioned);
        const bool is_cut = source.kind == UnitKind::Cut;
        for (std::size_t i = 0; i < spots; ++i) {
            // The staff goes to the deepest point of a cut first, elsewhere to wherever it stands best.
            const TrenchCell& cell =
                is_cut && i == 0 ? deepest(source) : source.cells[random_.below(source.cells.size())];
            add_level(unit, cell, is_cut ? model::LevelRole::Cut : model::LevelRole::Top, offset_x, with_position);
            if (!is_cut && random_.chance(0.4)) add_level(unit, cell, model::LevelRole::Base, offset_x, with_position);
        }
    }

    static const TrenchCell& deepest(const TrenchUnit& unit) {
        return *std::min_element(unit.cells.begin(), unit.cells.end(),
                                 [](const TrenchCell& a, const TrenchCell& b) { return a.top < b.top; });
    }

    void add_level(model::UnitId unit, const TrenchCell& cell, model::LevelRole role, double offset_x,
                   bool with_position) {
        model::Level level;
        level.id = id<model::LevelId>();
        level.unit = unit;
        level.role = role;
        const double z = (role == model::LevelRole::Base ? cell.base : cell.top) + o_.level_noise * random_.normal();
        const double misread = !random_.chance(1.0 / 150.0) ? 0.0 : random_.chance(0.5) ? 1.0 : -0.1;
        level.z = std::round((z + misread) * 100.0) / 100.0;
        if (with_position) {
            level.x = offset_x + cell.x + random_.between(-0.2, 0.2);
            level.y = cell.y + random_.between(-0.2, 0.2);
        }
        record().levels.push_back(level);
    }

    void add_dating(model::UnitId unit, double time) {
        if (!random_.chance(o_.dated)) return;
        const double span = static_cast<double>(kLastYear - kFirstYear);
        double year = static_cast<double>(kFirstYear) + time * span - random_.exponential(0.08 * span);
        if (random_.chance(0.02))
            year = random_.between(static_cast<double>(kFirstYear), static_cast<double>(kLastYear));
        model::Dating dating;
        dating.id = id<model::DatingId>();
        dating.unit = unit;
        const bool typed = random_.chance(0.3);
        dating.kind = typed ? model::DatingKind::Typed : model::DatingKind::Find;
        dating.label = typed ? "pottery" : "sherd";
        dating.from = static_cast<model::Year>(std::lround(year));
        // Somebody who dates the unit itself leaves room for its finds being old.
        dating.to = *dating.from + (typed ? 500 : 100);
        record().datings.push_back(dating);
    }

    void add_relations(const TrenchHistory& history, const std::vector<model::UnitId>& units) {
        for (const TrenchContact& contact : recorded_contacts(random_, history, o_.relations_per_unit, o_.redundant)) {
            add_relation(units[contact.later], contact.kind, units[contact.earlier], false);
        }
    }

    void add_relation(model::UnitId subject, RelationKind kind, model::UnitId object, bool correlation) {
        model::PhysicalRelation relation;
        relation.id = id<model::RelationId>();
        relation.subject = subject;
        relation.kind = kind;
        relation.object = object;
        relation.correlation = correlation;
        if (random_.chance(o_.uncertain)) relation.certainty = model::Certainty::Uncertain;
        const bool both = random_.chance(o_.both_sheets);
        const bool on_subject = both || random_.chance(0.6);
        if (on_subject) state(relation.id, StatementSide::Subject);
        if (both || !on_subject) state(relation.id, StatementSide::Object);
        record().relations.push_back(relation);
    }

    void state(model::RelationId relation, StatementSide side) {
        model::RelationStatement statement;
        statement.id = id<model::StatementId>();
        statement.relation = relation;
        statement.side = side;
        statement.source = source_;
        statement.line = ++line_;
        record().statements.push_back(statement);
    }

    // A layer met on both sides of a baulk gets two sheets; the second knows only what lies right above.
    void add_second_numbers(model::Area& area, const TrenchHistory& history, const std::vector<model::UnitId>& units,
                            const Digging& digging) {
        std::size_t next = digging.next_number;
        for (std::size_t u = 0; u < history.units.size(); ++u) {
            if (history.units[u].form != model::UnitForm::Layer || !random_.chance(o_.same_as)) continue;
            const auto above =
                std::find_if(history.contacts.begin(), history.contacts.end(),
                             [&](const TrenchContact& c) { return c.earlier == u && c.kind == RelationKind::Covers; });
            if (above == history.contacts.end() || next > static_cast<std::size_t>(std::stoul(area.last_number)))
                continue;
            model::StratigraphicUnit unit;
            unit.id = id<model::UnitId>();
            unit.number = std::to_string(next++);
            unit.area = area.id;
            unit.kind = UnitKind::Deposit;
            unit.form = model::UnitForm::Layer;
            unit.status = model::UnitStatus::Excavated;
            unit.title = "deposit";
            formed_[unit.id] = history.units[u].formed;
            record().units.push_back(unit);
            add_relation(units[u], RelationKind::SameAs, unit.id, random_.chance(0.5));
            add_relation(units[above->later], RelationKind::Covers, unit.id, false);
        }
    }

    GeneratedRecord sorted() {
        model::sort_record(record());
        for (const model::StratigraphicUnit& unit : record().units) out_.formed.push_back(formed_.at(unit.id));
        return std::move(out_);
    }
};

} // namespace

GeneratedRecord generate_record(const RecordOptions& options) {
    if (options.units < 50 || options.units > 20'000) {
        throw Error(ErrorCode::Usage, fmt::format("a generated record has 50 to 20000 units, not {}", options.units));
    }
    if (options.relations_per_unit < 1.0 || options.relations_per_unit > 6.0) {
        throw Error(ErrorCode::Usage,
                    fmt::format("a generated record has 1 to 6 relations a unit, not {}", options.relations_per_unit));
    }
    return Generator(options).run();
}

} // namespace planum::app
