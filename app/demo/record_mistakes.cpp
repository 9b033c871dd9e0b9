// SPDX-License-Identifier: MIT
#include "app/demo/record_mistakes.hpp"

#include <algorithm>
#include <unordered_map>
#include <vector>

#include <fmt/format.h>

#include "app/demo/random.hpp"
#include "core/base/uuid.hpp"

namespace planum::app {

namespace {

using model::RelationKind;
using model::StatementSide;
using model::TimeMeaning;
using model::UnitIndex;

constexpr std::pair<UnitIndex, UnitIndex> kNothing = {model::kNoUnit, model::kNoUnit};

class Seeder {
  public:
    Seeder(GeneratedRecord& generated, MistakeKind kind, const MistakeOptions& options)
        : g_(generated), kind_(kind), o_(options), random_(options.seed), ids_(options.seed ^ 0x5EEDULL),
          index_(generated.record) {
        below_.resize(g_.record.units.size());
        for (const model::PhysicalRelation& r : g_.record.relations) {
            if (model::time_meaning(r.kind) == TimeMeaning::SubjectLater)
                below_[index_.find(r.subject)].push_back(index_.find(r.object));
        }
    }

    std::optional<Mistake> run() {
        for (std::size_t i = 0; i < o_.tries; ++i) {
            std::optional<Mistake> made;
            switch (kind_) {
            case MistakeKind::Reversed:
            case MistakeKind::Transposed:
            case MistakeKind::Mistyped: made = wrong_statement(); break;
            case MistakeKind::WrongSameAs: made = wrong_same_as(); break;
            case MistakeKind::NumberUsedTwice: made = number_used_twice(); break;
            case MistakeKind::SwappedLevels: made = swapped_levels(); break;
            }
            if (made) {
                made->kind = kind_;
                resort();
                return made;
            }
        }
        return std::nullopt;
    }

  private:
    GeneratedRecord& g_;
    MistakeKind kind_;
    const MistakeOptions& o_;
    Random random_;
    SeededUuids ids_;
    model::RecordIndex index_;
    std::vector<std::vector<UnitIndex>> below_;

    model::Record& record() { return g_.record; }

    // Steps from one unit down to another; 0 when there is no way. `not_by` is left out once.
    [[nodiscard]] std::size_t steps_down(UnitIndex from, UnitIndex to, std::pair<UnitIndex, UnitIndex> not_by) const {
        std::vector<std::size_t> steps(below_.size(), 0);
        std::vector<UnitIndex> queue = {from};
        steps[from] = 1;
        for (std::size_t at = 0; at < queue.size(); ++at) {
            for (const UnitIndex next : below_[queue[at]]) {
                if (not_by.first == queue[at] && not_by.second == next) continue;
                if (steps[next] != 0) continue;
                steps[next] = steps[queue[at]] + 1;
                if (next == to) return steps[next] - 1;
                queue.push_back(next);
            }
        }
        return 0;
    }

    [[nodiscard]] bool cycle_is_as_asked(std::size_t cycle) const {
        return o_.least_cycle == 0 || cycle >= o_.least_cycle;
    }

    [[nodiscard]] std::vector<std::string> slips(const std::string& number) const {
        std::vector<std::string> texts;
        for (std::size_t i = 0; i < number.size(); ++i) {
            std::string text = number;
            if (kind_ == MistakeKind::Transposed) {
                if (i + 1 == number.size() || number[i] == number[i + 1]) continue;
                std::swap(text[i], text[i + 1]);
                texts.push_back(text);
                continue;
            }
            for (char digit = '0'; digit <= '9'; ++digit) {
                text[i] = digit;
                if (digit != number[i]) texts.push_back(text);
            }
        }
        return texts;
    }

    // The unit that a slip in the number of `unit` names; kNoUnit when there is none.
    [[nodiscard]] UnitIndex slipped(UnitIndex unit) {
        const std::vector<std::string> texts = slips(record().units[unit].number);
        if (texts.empty()) return model::kNoUnit;
        const auto found = index_.named(texts[random_.below(texts.size())]);
        return found.size() == 1 ? found.front() : model::kNoUnit;
    }

    std::optional<Mistake> wrong_statement() {
        const std::size_t s = random_.below(record().statements.size());
        const model::RelationStatement statement = record().statements[s];
        const std::size_t r = place_of(statement.relation);
        const model::PhysicalRelation right = record().relations[r];
        if (model::time_meaning(right.kind) != TimeMeaning::SubjectLater) return std::nullopt;
        const bool on_subject = statement.side == StatementSide::Subject;
        const UnitIndex subject = index_.find(right.subject);
        const UnitIndex object = index_.find(right.object);
        UnitIndex later = subject;
        UnitIndex earlier = object;
        StatementSide side = statement.side;
        if (kind_ == MistakeKind::Reversed) {
            std::swap(later, earlier);
            side = on_subject ? StatementSide::Object : StatementSide::Subject;
        } else {
            UnitIndex& slipping = on_subject ? earlier : later;
            slipping = slipped(slipping);
            if (slipping == model::kNoUnit) return std::nullopt;
        }
        if (later == earlier) return std::nullopt;
        const bool stated_elsewhere = is_stated_besides(right.id, s);
        // The right relation goes with its only statement, so it must not be part of the cycle.
        const std::pair gone = stated_elsewhere ? kNothing : std::pair(subject, object);
        const std::size_t path = steps_down(earlier, later, gone);
        const std::size_t cycle = path == 0 ? 0 : path + 1;
        if (!cycle_is_as_asked(cycle)) return std::nullopt;
        return write_wrong(right, s, stated_elsewhere, later, earlier, side, cycle);
    }

    Mistake write_wrong(const model::PhysicalRelation& right, std::size_t statement, bool stated_elsewhere,
                        UnitIndex later, UnitIndex earlier, StatementSide side, std::size_t cycle) {
        Mistake mistake;
        mistake.cycle = cycle;
        mistake.what = fmt::format("{} {} {} instead of {} {} {}", index_.name(later), model::to_word(right.kind),
                                   index_.name(earlier), index_.name(right.subject), model::to_word(right.kind),
                                   index_.name(right.object));
        model::PhysicalRelation wrong = right;
        wrong.subject = record().units[later].id;
        wrong.object = record().units[earlier].id;
        const auto known =
            std::find_if(record().relations.begin(), record().relations.end(), [&](const model::PhysicalRelation& r) {
                return r.subject == wrong.subject && r.object == wrong.object && r.kind == wrong.kind;
            });
        wrong.id = known != record().relations.end() ? known->id : model::RelationId{ids_.next()};
        record().statements[statement].relation = wrong.id;
        record().statements[statement].side = side;
        if (known == record().relations.end()) record().relations.push_back(wrong);
        if (!stated_elsewhere)
            std::erase_if(record().relations, [&](const model::PhysicalRelation& r) { return r.id == right.id; });
        mistake.relation = wrong.id;
        return mistake;
    }

    std::optional<Mistake> wrong_same_as() {
        const auto a = static_cast<UnitIndex>(random_.below(record().units.size()));
        const auto b = static_cast<UnitIndex>(random_.below(record().units.size()));
        if (a >= b || record().units[a].kind != record().units[b].kind) return std::nullopt;
        const std::size_t cycle = std::max(steps_down(a, b, kNothing), steps_down(b, a, kNothing));
        if (!cycle_is_as_asked(cycle)) return std::nullopt;
        Mistake mistake;
        mistake.cycle = cycle;
        mistake.what = fmt::format("{} same as {}", index_.name(a), index_.name(b));
        model::PhysicalRelation wrong{
            model::RelationId{ids_.next()}, record().units[a].id, RelationKind::SameAs, record().units[b].id, {}, true};
        model::RelationStatement statement;
        statement.id = model::StatementId{ids_.next()};
        statement.relation = mistake.relation = wrong.id;
        statement.source = record().sources.front().id;
        record().relations.push_back(wrong);
        record().statements.push_back(statement);
        return mistake;
    }

    // The second unit gets the number of the first; a record that knows units by number has then one unit
    // with the relations of both.
    std::optional<Mistake> number_used_twice() {
        const auto first = static_cast<UnitIndex>(random_.below(record().units.size()));
        const auto second = static_cast<UnitIndex>(random_.below(record().units.size()));
        if (first == second || record().units[first].area != record().units[second].area) return std::nullopt;
        const std::size_t cycle = steps_down(first, second, kNothing);
        if (!cycle_is_as_asked(cycle)) return std::nullopt;
        Mistake mistake;
        mistake.cycle = cycle;
        mistake.unit = record().units[first].id;
        mistake.what = fmt::format("number {} also given to {}", index_.name(first), index_.name(second));
        const model::UnitId gone = record().units[second].id;
        const auto rename = [&](model::UnitId& id) {
            if (id == gone) id = mistake.unit;
        };
        for (model::PhysicalRelation& r : record().relations) {
            rename(r.subject);
            rename(r.object);
        }
        std::erase_if(record().relations, [](const model::PhysicalRelation& r) { return r.subject == r.object; });
        for (model::Level& level : record().levels) rename(level.unit);
        for (model::Dating& dating : record().datings) rename(dating.unit);
        record().units.erase(record().units.begin() + static_cast<std::ptrdiff_t>(second));
        g_.formed.erase(g_.formed.begin() + static_cast<std::ptrdiff_t>(second));
        return mistake;
    }

    std::optional<Mistake> swapped_levels() {
        const model::PhysicalRelation& r = record().relations[random_.below(record().relations.size())];
        if (model::time_meaning(r.kind) != TimeMeaning::SubjectLater) return std::nullopt;
        const auto has_levels = [&](model::UnitId unit) {
            return std::any_of(record().levels.begin(), record().levels.end(),
                               [&](const model::Level& l) { return l.unit == unit; });
        };
        if (!has_levels(r.subject) || !has_levels(r.object)) return std::nullopt;
        Mistake mistake;
        mistake.unit = r.subject;
        mistake.what = fmt::format("levels of {} and {} exchanged", index_.name(r.subject), index_.name(r.object));
        for (model::Level& level : record().levels) {
            if (level.unit == r.subject) {
                level.unit = r.object;
            } else if (level.unit == r.object) {
                level.unit = r.subject;
            }
        }
        return mistake;
    }

    [[nodiscard]] std::size_t place_of(model::RelationId id) {
        if (places_.empty()) {
            for (std::size_t i = 0; i < record().relations.size(); ++i) places_.emplace(record().relations[i].id, i);
        }
        return places_.at(id);
    }

    [[nodiscard]] bool is_stated_besides(model::RelationId id, std::size_t but) const {
        for (std::size_t i = 0; i < g_.record.statements.size(); ++i) {
            if (i != but && g_.record.statements[i].relation == id) return true;
        }
        return false;
    }

    void resort() {
        std::unordered_map<model::UnitId, double> formed;
        for (std::size_t u = 0; u < record().units.size(); ++u) formed.emplace(record().units[u].id, g_.formed[u]);
        const auto living = [&](model::RelationId id) {
            return std::any_of(record().relations.begin(), record().relations.end(),
                               [&](const auto& r) { return r.id == id; });
        };
        if (kind_ == MistakeKind::NumberUsedTwice) {
            std::erase_if(record().statements, [&](const model::RelationStatement& s) { return !living(s.relation); });
        }
        model::sort_record(record());
        for (std::size_t u = 0; u < record().units.size(); ++u) g_.formed[u] = formed.at(record().units[u].id);
    }

    std::unordered_map<model::RelationId, std::size_t> places_;
};

} // namespace

std::optional<Mistake> seed_mistake(GeneratedRecord& generated, MistakeKind kind, const MistakeOptions& options) {
    return Seeder(generated, kind, options).run();
}

} // namespace planum::app
