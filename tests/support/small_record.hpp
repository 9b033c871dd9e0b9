// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/uuid.hpp"
#include "core/model/record.hpp"
#include "strat/checks/check.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::test {

/// A few units and relations written down in one line each: `SmallRecord().covers("1", "2").cut("3")`.
/// Units come into being when they are named.
class SmallRecord {
  public:
    SmallRecord() {
        source_.id = model::SourceId{ids_.next()};
        source_.name = "sheets.csv";
        record_.sources.push_back(source_);
    }

    enum class Sides { Subject, Object, Both };

    model::StratigraphicUnit& unit(std::string_view number, std::string_view area = {}) {
        const model::AreaId area_id = area.empty() ? model::AreaId{} : this->area(area).id;
        for (model::StratigraphicUnit& u : record_.units) {
            if (u.number == number && u.area == area_id) return u;
        }
        model::StratigraphicUnit u;
        u.id = model::UnitId{ids_.next()};
        u.number = number;
        u.area = area_id;
        record_.units.push_back(u);
        return record_.units.back();
    }

    model::Area& area(std::string_view name) {
        for (model::Area& a : record_.areas) {
            if (a.name == name) return a;
        }
        model::Area a;
        a.id = model::AreaId{ids_.next()};
        a.name = name;
        record_.areas.push_back(a);
        return record_.areas.back();
    }

    SmallRecord& kind(std::string_view number, model::UnitKind kind, model::UnitForm form = model::UnitForm::None) {
        unit(number).kind = kind;
        unit(number).form = form;
        return *this;
    }

    SmallRecord& relate(std::string_view subject, model::RelationKind kind, std::string_view object,
                        Sides sides = Sides::Both) {
        const model::UnitId subject_id = unit(subject).id; // naming the other may move this one
        const model::UnitId object_id = unit(object).id;
        return relate(subject_id, kind, object_id, sides);
    }

    SmallRecord& relate(model::UnitId subject, model::RelationKind kind, model::UnitId object,
                        Sides sides = Sides::Both) {
        model::PhysicalRelation r;
        r.id = model::RelationId{ids_.next()};
        r.subject = subject;
        r.kind = kind;
        r.object = object;
        record_.relations.push_back(r);
        if (sides != Sides::Object) state(r.id, model::StatementSide::Subject);
        if (sides != Sides::Subject) state(r.id, model::StatementSide::Object);
        return *this;
    }

    SmallRecord& covers(std::string_view subject, std::string_view object, Sides sides = Sides::Both) {
        return relate(subject, model::RelationKind::Covers, object, sides);
    }

    SmallRecord& level(std::string_view number, model::LevelRole role, double z, std::optional<double> x = {},
                       std::optional<double> y = {}) {
        model::Level level;
        level.id = model::LevelId{ids_.next()};
        level.unit = unit(number).id;
        level.role = role;
        level.x = x;
        level.y = y;
        level.z = z;
        record_.levels.push_back(level);
        return *this;
    }

    SmallRecord& dating(std::string_view number, model::DatingKind kind, model::Year from, model::Year to) {
        model::Dating dating;
        dating.id = model::DatingId{ids_.next()};
        dating.unit = unit(number).id;
        dating.kind = kind;
        dating.from = from;
        dating.to = to;
        record_.datings.push_back(dating);
        return *this;
    }

    [[nodiscard]] model::Record& record() { return record_; }

    [[nodiscard]] strat::CheckResult check(const strat::CheckOptions& options = {}) {
        model::sort_record(record_);
        return strat::check(record_, strat::HarrisMatrix::build(record_), options, {}, Progress::none());
    }

    /// All diagnostics with one code.
    [[nodiscard]] std::vector<model::Diagnostic> said(std::string_view code) {
        std::vector<model::Diagnostic> found;
        for (model::Diagnostic& d : check().diagnostics) {
            if (d.code == code) found.push_back(std::move(d));
        }
        return found;
    }

    [[nodiscard]] std::string name(model::UnitId id) const {
        for (const model::StratigraphicUnit& u : record_.units) {
            if (u.id == id) return u.number;
        }
        return "?";
    }

    [[nodiscard]] std::vector<std::string> names(const std::vector<model::UnitId>& ids) const {
        std::vector<std::string> result;
        for (const model::UnitId id : ids) result.push_back(name(id));
        std::sort(result.begin(), result.end());
        return result;
    }

  private:
    SeededUuids ids_{1};
    model::Record record_;
    model::Source source_;
    std::int64_t line_ = 0;

    void state(model::RelationId relation, model::StatementSide side) {
        model::RelationStatement s;
        s.id = model::StatementId{ids_.next()};
        s.relation = relation;
        s.side = side;
        s.source = source_.id;
        s.line = ++line_;
        record_.statements.push_back(s);
    }
};

} // namespace planum::test
