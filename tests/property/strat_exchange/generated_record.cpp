// SPDX-License-Identifier: MIT
#include "tests/property/strat_exchange/generated_record.hpp"

#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/uuid.hpp"

namespace planum::test {

namespace {

using Texts = std::vector<std::string>;

const Texts kNumbers = {"1", "2", "3", "12", "12a", "1297+", "+", "-", "41/61", "B.36", "ü7", "99999999999999999999"};
const Texts kWildNumbers = {"B. 36", "101/1C or 111/1C", "=1+1", "@x", "'5", "Σ8", "a\"b", "<1>&2", "T;U"};
const Texts kCommaNumbers = {"7,8"};
const Texts kPlainTexts = {"", "floor", "Küche", "a - dash", "=1+1 is two", "'s"};
const Texts kWildTexts = {"a \"b\"",        "semi; colon, comma", "two\nlines",   "Ω ≥ 5",
                          "<&> ' \" &amp;", "'=not a formula",    "-5",           "+x",
                          "@home",          "tab\there",          "back\\slash\\"};

/// Draws everything from rapidcheck, so that failures shrink.
class Drawer {
  public:
    explicit Drawer(const RecordShape& shape) : shape_(shape) {}

    model::Record draw() {
        record_.settings.name = text(kPlainTexts);
        draw_areas();
        draw_chronology();
        draw_units();
        if (!record_.units.empty()) {
            draw_relations();
            draw_groups();
            draw_measured();
        }
        model::sort_record(record_);
        return std::move(record_);
    }

  private:
    [[nodiscard]] static std::size_t below(std::size_t limit) { return *rc::gen::inRange<std::size_t>(0, limit); }

    [[nodiscard]] static bool chance(std::size_t one_in) { return below(one_in) == 0; }

    [[nodiscard]] static const std::string& text(const Texts& pool) { return pool[below(pool.size())]; }

    [[nodiscard]] static std::string wild() { return chance(3) ? text(kWildTexts) : text(kPlainTexts); }

    [[nodiscard]] std::string title() const { return shape_.plain_titles ? text(kPlainTexts) : wild(); }

    [[nodiscard]] static std::string day() { return chance(2) ? "" : "2025-06-0" + std::to_string(1 + below(9)); }

    template<class Id>
    [[nodiscard]] Id id() {
        return Id{uuids_.next()};
    }

    [[nodiscard]] static std::optional<double> number() {
        if (chance(2)) return std::nullopt;
        return static_cast<double>(*rc::gen::inRange(-99999, 99999)) / 1000.0;
    }

    [[nodiscard]] static std::optional<std::int64_t> year() {
        if (chance(2)) return std::nullopt;
        return *rc::gen::inRange(-4000, 2000);
    }

    [[nodiscard]] model::UnitId some_unit() const { return record_.units[below(record_.units.size())].id; }

    [[nodiscard]] model::UnitId maybe_unit() const { return chance(4) ? model::UnitId{} : some_unit(); }

    std::string unit_number() const {
        if (shape_.plain_names || !chance(3)) return text(kNumbers);
        if (!shape_.comma_free && chance(4)) return text(kCommaNumbers);
        return text(kWildNumbers);
    }

    void draw_areas() {
        for (std::size_t i = 0, n = below(3); i < n; ++i) {
            model::Area area{id<model::AreaId>(), i == 0 ? "A" : "Süd", title(), model::DigMethod::Mixed, "", "100"};
            record_.areas.push_back(std::move(area));
        }
    }

    void draw_chronology() {
        for (std::size_t i = 0, n = below(3); i < n; ++i) {
            record_.periods.push_back(
                {id<model::PeriodId>(), "P" + std::to_string(i), wild(), wild(), year(), year(), {}});
        }
        for (std::size_t i = 0, n = below(4); i < n; ++i) {
            model::Phase phase{
                id<model::PhaseId>(), i == 3 ? "I" : std::string(i + 1, 'I'), wild(), wild(), {}, year(), year(), 7};
            if (!record_.periods.empty() && chance(2)) phase.period = record_.periods[below(record_.periods.size())].id;
            record_.phases.push_back(std::move(phase));
        }
    }

    void draw_units() {
        std::set<std::pair<std::string, model::AreaId>> used;
        for (std::size_t i = 0, n = below(9); i < n; ++i) {
            model::StratigraphicUnit unit;
            unit.id = id<model::UnitId>();
            unit.number = unit_number();
            if (!record_.areas.empty()) unit.area = record_.areas[below(record_.areas.size())].id;
            if (!used.emplace(unit.number, unit.area).second) continue;
            if (!chance(6)) fill_sheet(unit);
            record_.units.push_back(std::move(unit));
        }
    }

    void fill_sheet(model::StratigraphicUnit& unit) {
        unit.kind = static_cast<model::UnitKind>(below(9));
        unit.form = static_cast<model::UnitForm>(chance(2) ? 0 : below(6));
        unit.status = static_cast<model::UnitStatus>(below(5));
        unit.title = title();
        unit.description = wild();
        unit.interpretation = wild();
        unit.excavated_from = day();
        unit.excavated_on = day();
        unit.recorded_by = wild();
        if (!record_.phases.empty() && chance(2)) {
            const model::Phase& phase = record_.phases[below(record_.phases.size())];
            unit.phase = phase.id;
            unit.period = phase.period;
        } else if (!record_.periods.empty() && chance(2)) {
            unit.period = record_.periods[below(record_.periods.size())].id;
        }
        for (const char* field : {"colour", "base", "custom", "position"}) {
            const std::string value = wild();
            if (!value.empty() && value != "-5") unit.details[field] = value;
        }
        if (!record_.units.empty() && chance(4) && record_.units.back().area == unit.area) {
            unit.parent = record_.units.back().id;
        }
        if (chance(5)) {
            model::StratigraphicUnit mentioned;
            mentioned.id = unit.id;
            mentioned.number = unit.number;
            mentioned.area = unit.area;
            mentioned.origin = model::UnitOrigin::Mentioned;
            unit = std::move(mentioned);
        }
    }

    void draw_relations() {
        std::set<std::tuple<model::UnitId, model::RelationKind, model::UnitId>> used;
        for (std::size_t i = 0, n = below(12); i < n; ++i) {
            model::PhysicalRelation relation;
            relation.id = id<model::RelationId>();
            relation.subject = some_unit();
            relation.kind = static_cast<model::RelationKind>(below(9));
            relation.object = some_unit();
            relation.certainty = chance(3) ? model::Certainty::Uncertain : model::Certainty::Certain;
            relation.correlation = relation.kind == model::RelationKind::SameAs && chance(2);
            const bool known = used.contains({relation.object, relation.kind, relation.subject});
            if (known || !used.emplace(relation.subject, relation.kind, relation.object).second) continue;
            for (std::size_t s = 0, m = 1 + below(2); s < m; ++s) {
                model::RelationStatement statement;
                statement.id = id<model::StatementId>();
                statement.relation = relation.id;
                statement.side = static_cast<model::StatementSide>(below(3));
                statement.person = wild();
                record_.statements.push_back(std::move(statement));
            }
            record_.relations.push_back(relation);
        }
    }

    void draw_groups() {
        std::set<model::UnitId> taken;
        for (std::size_t i = 0, n = below(3); i < n; ++i) {
            model::UnitGroup group;
            group.id = id<model::GroupId>();
            group.number = "G" + std::to_string(i);
            group.type = "group";
            group.title = title();
            group.description = wild();
            if (i > 0 && chance(2)) group.parent = record_.groups.front().id;
            std::set<model::UnitId> members;
            for (std::size_t m = 0, k = below(4); m < k; ++m) {
                const model::UnitId unit = some_unit();
                if (shape_.one_group_each && !taken.insert(unit).second) continue;
                if (members.insert(unit).second) group.members.push_back(unit);
            }
            record_.groups.push_back(std::move(group));
        }
    }

    void draw_measured() {
        for (std::size_t i = 0, n = below(3); i < n; ++i) {
            record_.levels.push_back({id<model::LevelId>(), some_unit(), number(), number(), number().value_or(0.0),
                                      static_cast<model::LevelRole>(below(4)), wild()});
            model::Find find;
            find.id = id<model::FindId>();
            find.number = "F" + std::to_string(i);
            find.unit = maybe_unit();
            find.z = number();
            find.type = wild();
            find.count = year();
            find.found_on = day();
            find.description = wild();
            record_.finds.push_back(std::move(find));
            model::Sample sample;
            sample.id = id<model::SampleId>();
            sample.number = "S" + std::to_string(i);
            sample.unit = some_unit();
            sample.volume = number();
            sample.type = wild();
            record_.samples.push_back(std::move(sample));
            record_.documents.push_back({id<model::DocumentId>(), "D" + std::to_string(i), "photo", wild(),
                                         maybe_unit(), wild(), day(), wild()});
            model::Dating dating;
            dating.id = id<model::DatingId>();
            dating.label = "OxA-" + std::to_string(i);
            dating.unit = some_unit();
            dating.kind = static_cast<model::DatingKind>(below(6));
            dating.from = year();
            dating.to = year();
            dating.bp = number();
            dating.association = chance(2) ? "direct" : "";
            dating.notes = wild();
            if (chance(2)) dating.find = record_.finds.front().id;
            record_.datings.push_back(std::move(dating));
        }
    }

    RecordShape shape_;
    SeededUuids uuids_{42};
    model::Record record_;
};

} // namespace

rc::Gen<model::Record> generated_record(const RecordShape& shape) {
    return rc::gen::exec([shape] { return Drawer(shape).draw(); });
}

} // namespace planum::test
