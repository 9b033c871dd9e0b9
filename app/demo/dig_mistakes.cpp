// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "app/demo/dig_record.hpp"
#include "app/demo/simulator_random.hpp"
#include "core/model/relation.hpp"

namespace planum::app::demo {

namespace {

std::string sentence(const RecordedRelation& r) { return fmt::format("{} {} {}", r.unit, r.relation, r.other); }

class Spoiler {
  public:
    Spoiler(DigRecord& record, const DigPlan& plan, const SeenContacts& seen)
        : record_(record), seen_(seen), draw_(plan.seed, 6000), each_(plan.site.units < 20    ? 1
                                                                      : plan.site.units < 100 ? 3
                                                                                              : 10) {}

    std::vector<Mistake> spoil() {
        for (int i = 0; i < each_; ++i) {
            reverse_relation(i % 2 == 0);
            retype_number(i % 2 == 0);
            swap_heights();
            misplace_find();
        }
        use_number_twice();
        return std::move(mistakes_);
    }

  private:
    // A row that no mistake has touched yet, or nothing.
    template<class Rows, class Fits>
    auto* choose(Rows& rows, std::set<std::size_t>& touched, Fits fits) {
        for (int attempt = 0; attempt < 200 && !rows.empty(); ++attempt) {
            const auto i = static_cast<std::size_t>(draw_.below(static_cast<int>(rows.size())));
            if (touched.contains(i) || !fits(rows[i])) continue;
            touched.insert(i);
            return &rows[i];
        }
        return static_cast<typename Rows::value_type*>(nullptr);
    }

    // Both sheets say it the wrong way round, as when it was misunderstood in the trench.
    void reverse_relation(bool shown) {
        const auto area = [&](const RecordedRelation& r) {
            const auto seen = seen_.find({r.later, r.earlier});
            return seen == seen_.end() ? 0.0 : seen->second.area;
        };
        const auto orders = [](const RecordedRelation& r) {
            return r.relation == "covers" || r.relation == "cuts" || r.relation == "fills";
        };
        // Best one that surfaces show to be wrong and that closes a cycle; else what there is.
        const RecordedRelation* chosen = choose(record_.relations, relations_touched_, [&](const RecordedRelation& r) {
            return orders(r) && (!shown || area(r) >= 0.1) && has_way_around(r);
        });
        if (chosen == nullptr) chosen = choose(record_.relations, relations_touched_, orders);
        if (chosen == nullptr) return;
        const RecordedRelation model = *chosen;
        Mistake mistake{"reversed-relation", "relations.csv", model.unit, sentence(model), "", area(model) >= 0.1};
        for (std::size_t i = 0; i < record_.relations.size(); ++i) {
            RecordedRelation& r = record_.relations[i];
            if (r.later != model.later || r.earlier != model.earlier) continue;
            relations_touched_.insert(i);
            std::swap(r.unit, r.other);
            if (r.relation == model.relation) mistake.is = sentence(r);
        }
        mistakes_.push_back(std::move(mistake));
    }

    // Somebody in between that the later one is above and that is above the earlier one.
    [[nodiscard]] bool has_way_around(const RecordedRelation& r) const {
        std::set<UnitNo> below;
        for (const RecordedRelation& other : record_.relations) {
            if (other.later == r.later && other.earlier != r.earlier) below.insert(other.earlier);
        }
        return std::any_of(record_.relations.begin(), record_.relations.end(), [&](const RecordedRelation& other) {
            return other.earlier == r.earlier && below.contains(other.later);
        });
    }

    // On one sheet only; the other sheet still has it right.
    void retype_number(bool transpose) {
        RecordedRelation* r = choose(record_.relations, relations_touched_, [](const RecordedRelation& row) {
            return row.other.size() >= 4 && row.other[2] != row.other[3];
        });
        if (r == nullptr) return;
        Mistake mistake{
            transpose ? "transposed-number" : "mistyped-number", "relations.csv", r->unit, sentence(*r), "", false};
        if (transpose) {
            std::swap(r->other[2], r->other[3]);
        } else {
            char& digit = r->other[3];
            digit = static_cast<char>('0' + (digit - '0' + 1 + draw_.below(8)) % 10);
        }
        mistake.is = sentence(*r);
        mistakes_.push_back(std::move(mistake));
    }

    void swap_heights() {
        RecordedLevel* base = choose(record_.levels, levels_touched_,
                                     [](const RecordedLevel& l) { return l.role == model::LevelRole::Base; });
        if (base == nullptr) return;
        const auto top = std::find_if(record_.levels.begin(), record_.levels.end(), [&](const RecordedLevel& l) {
            return l.unit == base->unit && l.role == model::LevelRole::Top;
        });
        if (top == record_.levels.end()) return;
        Mistake mistake{"swapped-heights",
                        "levels.csv",
                        base->unit,
                        fmt::format("top {:.3f}, base {:.3f}", top->at.z, base->at.z),
                        "",
                        false};
        std::swap(top->at.z, base->at.z);
        for (RecordedLevel& l : record_.levels) { // the other heights of the top were read off the same line
            if (l.unit == base->unit && l.role == model::LevelRole::Top) l.at.z = std::min(l.at.z, top->at.z);
        }
        mistake.is = fmt::format("top {:.3f}, base {:.3f}", top->at.z, base->at.z);
        mistakes_.push_back(std::move(mistake));
    }

    void misplace_find() {
        RecordedFind* find = choose(record_.finds, finds_touched_, [](const RecordedFind&) { return true; });
        if (find == nullptr) return;
        std::vector<std::string> others;
        for (const RecordedUnit& unit : record_.units) {
            if (unit.number != find->unit && unit.kind == model::UnitKind::Deposit) others.push_back(unit.number);
        }
        if (others.empty()) return;
        const std::string wrong = others[static_cast<std::size_t>(draw_.below(static_cast<int>(others.size())))];
        mistakes_.push_back({"find-in-wrong-unit", "finds.csv", find->number, find->unit, wrong, false});
        find->unit = wrong;
    }

    // Two diggers took the same number: the second one's sheet, relations and levels carry the first's.
    void use_number_twice() {
        if (record_.units.size() < 4) return;
        const auto first = static_cast<std::size_t>(draw_.below(static_cast<int>(record_.units.size())));
        const std::size_t second = (first + record_.units.size() / 2) % record_.units.size();
        const std::string taken = record_.units[first].number;
        const std::string lost = record_.units[second].number;
        mistakes_.push_back({"number-used-twice", "units.csv", lost, lost, taken, false});
        record_.units[second].number = taken;
        for (RecordedRelation& r : record_.relations) {
            if (r.unit == lost) r.unit = taken;
            if (r.other == lost) r.other = taken;
        }
        std::erase_if(record_.relations, [](const RecordedRelation& r) { return r.unit == r.other; });
        for (RecordedLevel& l : record_.levels) l.unit = l.unit == lost ? taken : l.unit;
        for (RecordedFind& f : record_.finds) f.unit = f.unit == lost ? taken : f.unit;
        for (RecordedDating& d : record_.datings) d.unit = d.unit == lost ? taken : d.unit;
    }

    DigRecord& record_;
    const SeenContacts& seen_;
    Draw draw_;
    int each_;
    std::vector<Mistake> mistakes_;
    std::set<std::size_t> relations_touched_;
    std::set<std::size_t> levels_touched_;
    std::set<std::size_t> finds_touched_;
};

} // namespace

std::vector<Mistake> make_mistakes(DigRecord& record, const DigPlan& plan, const SeenContacts& seen) {
    return Spoiler(record, plan, seen).spoil();
}

} // namespace planum::app::demo
