// SPDX-License-Identifier: MIT
#include "app/demo/dig_record.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "app/demo/simulator_random.hpp"
#include "core/model/relation.hpp"

namespace planum::app::demo {

namespace {

using model::LevelRole;
using model::UnitForm;
using model::UnitKind;
using model::UnitStatus;

constexpr std::array kPeople = {"A. Berger", "M. Rossi", "J. Clarke", "S. Lefevre"};
constexpr double kSeen = 0.02; ///< contacts smaller than this nobody writes down [m²]

struct FindType {
    const char* type;
    const char* material;
    double weight; ///< typical [g]
};

constexpr std::array kFindTypes = {FindType{"sherd", "pottery", 25}, FindType{"animal bone", "bone", 60},
                                   FindType{"nail", "iron", 12},     FindType{"vessel fragment", "glass", 5},
                                   FindType{"tile", "ceramic", 180}, FindType{"coin", "copper alloy", 4}};

std::string person(Draw& draw) {
    return kPeople[static_cast<std::size_t>(draw.below(static_cast<int>(kPeople.size())))];
}

// Where a unit begins and ends, and when it went.
struct Extent {
    Vec3 highest{0, 0, -1e9};
    Vec3 lowest{0, 0, 1e9};
    Vec3 lowest_top{0, 0, 1e9};
    SurfaceNo first_gone = kNever;
    SurfaceNo last_gone = -1;
    bool left = false; ///< some of it was never dug
};

class Recorder {
  public:
    Recorder(const Formation& formation, const DigPlan& plan, const ColumnGrid& grid, const DugGrid& dug,
             const std::vector<Contact>& contacts)
        : formation_(formation), plan_(plan), grid_(grid), dug_(dug), contacts_(contacts), draw_(plan.seed, 5000),
          extents_(formation.units().size()) {}

    DigRecord keep() {
        measure();
        units();
        relations();
        levels();
        finds();
        phases();
        return std::move(record_);
    }

  private:
    [[nodiscard]] const std::string& number(UnitNo unit) const {
        return formation_.units()[static_cast<std::size_t>(unit)].number;
    }

    [[nodiscard]] Vec3 where(std::size_t index, float z) const {
        return {grid_.x_of(index % grid_.columns()), grid_.y_of(index / grid_.columns()), static_cast<double>(z)};
    }

    void measure() {
        for (std::size_t index = 0; index < grid_.size(); ++index) {
            const auto runs = dug_.at(index);
            for (std::size_t i = 0; i < runs.size(); ++i) {
                const DugRun& run = runs[i];
                const bool is_top = i == 0 || runs[i - 1].unit != run.unit;
                note(extents_[static_cast<std::size_t>(run.unit)], run, where(index, run.high), where(index, run.low),
                     is_top);
                // The cut that the run lies in: its bottom where something older follows below.
                if (run.cut == kAir || run.gone == kSide) continue;
                const bool on_side = i + 1 == runs.size() || runs[i + 1].unit < run.cut;
                Extent& hollow = extents_[static_cast<std::size_t>(run.cut)];
                note(hollow, run, where(index, run.high), on_side ? where(index, run.low) : hollow.lowest, false);
            }
        }
    }

    void note(Extent& extent, const DugRun& run, const Vec3& high, const Vec3& low, bool is_top) const {
        if (run.gone == kSide) return;
        if (high.z > extent.highest.z) extent.highest = high;
        if (low.z < extent.lowest.z) extent.lowest = low;
        if (is_top && high.z < extent.lowest_top.z) extent.lowest_top = high;
        if (run.gone >= plan_.surfaces) {
            extent.left = true;
        } else if (run.due == run.gone) { // a baulk is noted on the sheet, but does not keep it open
            extent.first_gone = std::min(extent.first_gone, static_cast<SurfaceNo>(run.gone));
            extent.last_gone = std::max(extent.last_gone, static_cast<SurfaceNo>(run.gone));
        }
    }

    void units() {
        for (std::size_t u = 0; u < formation_.units().size(); ++u) {
            const FormedUnit& formed = formation_.units()[u];
            const Extent& extent = extents_[u];
            RecordedUnit unit;
            unit.number = formed.number;
            unit.kind = formed.kind;
            unit.form = formed.form;
            unit.title = formed.title;
            unit.recorded_by = person(draw_);
            if (formed.kind != UnitKind::Natural) unit.phase = fmt::format("P{}", formed.phase + 1);
            if (formed.feature >= 0) unit.group = fmt::format("F{}", formed.feature + 1);
            const bool touched = extent.last_gone >= 0;
            unit.status = !touched      ? UnitStatus::NotExcavated
                          : extent.left ? UnitStatus::PartlyExcavated
                                        : UnitStatus::Excavated;
            if (touched)
                unit.excavated_from =
                    plan_.days[static_cast<std::size_t>(std::min(extent.first_gone, plan_.surfaces - 1))];
            if (touched && !extent.left) unit.excavated_on = plan_.days[static_cast<std::size_t>(extent.last_gone)];
            record_.units.push_back(std::move(unit));
        }
        std::map<std::string, RecordedGroup> groups;
        for (std::size_t u = 0; u < formation_.units().size(); ++u) {
            const FormedUnit& formed = formation_.units()[u];
            if (formed.kind != UnitKind::Cut) continue;
            const std::string of =
                formed.title.rfind("cut of ", 0) == 0 ? formed.title.substr(7) : "wall in a foundation trench";
            groups.try_emplace(record_.units[u].group, RecordedGroup{record_.units[u].group, "feature", of});
        }
        for (const auto& [name, group] : groups) record_.groups.push_back(group);
    }

    void relations() {
        for (const Contact& contact : contacts_) {
            const double area = contact.plan_area + contact.side_area;
            const bool overlooked = area < 0.5 && draw_.chance(0.04);
            const bool from_later = draw_.chance(0.92);
            const bool from_earlier = !from_later || draw_.chance(0.92);
            const bool uncertain = area < 0.2 && draw_.chance(0.1);
            if (area < kSeen || overlooked) continue;
            const auto state = [&](UnitNo unit, UnitNo other, std::string_view words) {
                record_.relations.push_back({number(unit), std::string{words}, number(other), uncertain,
                                             record_.units[static_cast<std::size_t>(unit)].recorded_by, contact.later,
                                             contact.earlier});
            };
            const auto& bare =
                model::is_symmetric(contact.kind) ? model::phrase(contact.kind) : model::to_word(contact.kind);
            if (from_later) state(contact.later, contact.earlier, bare);
            if (from_earlier) {
                state(contact.earlier, contact.later,
                      model::is_symmetric(contact.kind) ? bare : model::inverse_phrase(contact.kind));
            }
        }
    }

    void level(UnitNo unit, Vec3 at, LevelRole role, const char* label) {
        at.z = std::round(at.z * 1e3) / 1e3;
        record_.levels.push_back({number(unit), at, role, label});
    }

    void levels() {
        for (std::size_t u = 0; u < extents_.size(); ++u) {
            const Extent& extent = extents_[u];
            const auto unit = static_cast<UnitNo>(u);
            if (extent.highest.z < extent.lowest.z) continue;
            const FormedUnit& formed = formation_.units()[u];
            level(unit, extent.highest, LevelRole::Top, formed.kind == UnitKind::Cut ? "rim" : "highest point");
            if (formed.kind != UnitKind::Cut && extent.lowest_top.z < extent.highest.z) {
                level(unit, extent.lowest_top, LevelRole::Top, "lowest point of the top");
            }
            if (formed.kind == UnitKind::Natural || extent.last_gone < 0) continue;
            // Of fills, a hair above the bottom of the cut: measured before the last scraping.
            Vec3 base = extent.lowest;
            if (formed.kind != UnitKind::Cut) base.z = std::min(base.z + 0.004, extent.highest.z);
            level(unit, base, LevelRole::Base, "lowest point");
        }
    }

    void finds() {
        std::vector<std::vector<std::pair<std::size_t, DugRun>>> bodies(extents_.size());
        for (std::size_t index = 0; index < grid_.size(); index += 7) {
            for (const DugRun& run : dug_.at(index)) {
                if (run.gone < plan_.surfaces && run.high - run.low > 0.01F)
                    bodies[static_cast<std::size_t>(run.unit)].emplace_back(index, run);
            }
        }
        int next = 1;
        for (std::size_t u = 0; u < bodies.size(); ++u) {
            const FormedUnit& formed = formation_.units()[u];
            if (bodies[u].empty() || formed.kind != UnitKind::Deposit) continue;
            const int count = formed.thin ? 1 : 2 + draw_.below(4);
            for (int i = 0; i < count; ++i) add_find(static_cast<UnitNo>(u), bodies[u], next++);
        }
    }

    void add_find(UnitNo unit, const std::vector<std::pair<std::size_t, DugRun>>& body, int running) {
        const auto& [index, run] = body[static_cast<std::size_t>(draw_.below(static_cast<int>(body.size())))];
        const FindType& type = kFindTypes[static_cast<std::size_t>(draw_.below(static_cast<int>(kFindTypes.size())))];
        RecordedFind find;
        find.number = fmt::format("{}", running);
        find.unit = number(unit);
        find.at = where(index, run.low);
        find.at.z =
            std::round((find.at.z + draw_.between(0.1, 0.9) * static_cast<double>(run.high - run.low)) * 1e3) / 1e3;
        find.type = type.type;
        find.material = type.material;
        find.count = find.material == "pottery" || find.material == "bone" ? 1 + draw_.below(12) : 1;
        find.weight = std::round(type.weight * find.count * draw_.between(0.4, 1.8));
        find.found_on = plan_.days[run.gone];
        if (find.type == "coin") {
            // Struck before it was lost: somewhere in the phase or up to a lifetime before.
            const auto [from, to] = years(formation_.units()[static_cast<std::size_t>(unit)].phase);
            const int struck = from - 60 + draw_.below(to - from + 40);
            record_.datings.push_back({fmt::format("coin {}", find.number), find.unit, find.number,
                                       model::DatingKind::Coin, struck, struck + 25});
        }
        record_.finds.push_back(std::move(find));
    }

    [[nodiscard]] std::pair<int, int> years(int phase) const {
        constexpr int kFirst = 60;
        constexpr int kLast = 1900;
        const int span = (kLast - kFirst) / (plan_.site.phases + 1);
        return {kFirst + phase * span, kFirst + (phase + 1) * span};
    }

    void phases() {
        record_.periods = {
            {"R", "Roman", "", 1, 450}, {"M", "medieval", "", 450, 1500}, {"PM", "post-medieval", "", 1500, 1950}};
        for (int phase = 0; phase <= plan_.site.phases; ++phase) {
            const auto [from, to] = years(phase);
            const std::string period = from < 450 ? "R" : from < 1500 ? "M" : "PM";
            const std::string title =
                phase == plan_.site.phases ? "modern soil" : fmt::format("occupation {}", phase + 1);
            record_.phases.push_back({fmt::format("P{}", phase + 1), title, period, from, to});
        }
        for (const FormedUnit& formed : formation_.units()) {
            if (formed.form != UnitForm::Layer || formed.thin || !draw_.chance(0.5)) continue;
            const auto [from, to] = years(formed.phase);
            record_.datings.push_back(
                {fmt::format("pottery of {}", formed.number), formed.number, "", model::DatingKind::Typed, from, to});
        }
    }

    const Formation& formation_;
    const DigPlan& plan_;
    const ColumnGrid& grid_;
    const DugGrid& dug_;
    const std::vector<Contact>& contacts_;
    Draw draw_;
    std::vector<Extent> extents_;
    DigRecord record_;
};

} // namespace

void number_units(Formation& formation, const DigPlan& plan, const std::vector<SurfaceMap>& maps) {
    std::vector<SurfaceNo> met(formation.units().size(), kNever);
    for (std::size_t s = 0; s < maps.size(); ++s) {
        for (const SurfaceCell& cell : maps[s]) {
            if (cell.unit == kAir) continue;
            SurfaceNo& first = met[static_cast<std::size_t>(cell.unit)];
            first = std::min(first, static_cast<SurfaceNo>(s));
        }
    }
    for (std::size_t u = 0; u < met.size(); ++u) met[u] = std::min(met[u], plan.out[u]);
    std::vector<std::size_t> order(met.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return met[a] != met[b] ? met[a] < met[b] : a > b; // what is later is met first
    });
    for (std::size_t i = 0; i < order.size(); ++i) formation.units()[order[i]].number = fmt::format("{}", 1001 + i);
}

DigRecord keep_record(const Formation& formation, const DigPlan& plan, const ColumnGrid& grid, const DugGrid& dug,
                      const std::vector<Contact>& contacts) {
    return Recorder(formation, plan, grid, dug, contacts).keep();
}

} // namespace planum::app::demo
