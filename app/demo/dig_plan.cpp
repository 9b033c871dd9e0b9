// SPDX-License-Identifier: MIT
#include "app/demo/dig_plan.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "app/demo/simulator_random.hpp"

namespace planum::app::demo {

namespace {

using model::DigMethod;
using model::RelationKind;
using model::UnitForm;
using model::UnitKind;

constexpr double kBatter = 0.05; ///< sides lean by this much for each metre of depth

// Longest chain of later units above each one; a cut goes with its last fill.
std::vector<int> ranks(const Formation& formation, const std::vector<Contact>& contacts) {
    std::vector<int> rank(formation.units().size(), 0);
    for (bool changed = true; changed;) {
        changed = false;
        const auto raise = [&](UnitNo unit, int to) {
            int& now = rank[static_cast<std::size_t>(unit)];
            if (now >= to) return;
            now = to;
            changed = true;
        };
        for (const Contact& contact : contacts) {
            const int above = rank[static_cast<std::size_t>(contact.later)];
            const bool together = contact.kind == RelationKind::SameAs || contact.kind == RelationKind::BondsWith;
            const bool of_cut = contact.kind == RelationKind::Fills;
            raise(contact.earlier, above + (together || of_cut ? 0 : 1));
            if (together) raise(contact.later, rank[static_cast<std::size_t>(contact.earlier)]);
        }
    }
    return rank;
}

void schedule_units(DigPlan& plan, const Formation& formation, const std::vector<Contact>& contacts) {
    const std::vector<int> rank = ranks(formation, contacts);
    int deepest = 0;
    for (std::size_t u = 0; u < rank.size(); ++u) {
        if (formation.units()[u].kind != UnitKind::Natural) deepest = std::max(deepest, rank[u]);
    }
    for (std::size_t u = 0; u < rank.size(); ++u) {
        const bool natural = formation.units()[u].kind == UnitKind::Natural;
        // The topsoil went before the first scan, as machines take it off.
        const SurfaceNo out = rank[u] == 0 ? 0 : 1 + (rank[u] - 1) * (plan.surfaces - 1) / std::max(deepest, 1);
        plan.out[u] = natural ? kNever : out;
    }
}

// Mean height of a level: from where the machine stopped, in or below the topsoil, to just inside the natural.
double level_height(const DigPlan& plan, SurfaceNo surface) {
    const double top = plan.site.trench.high.z - (plan.site.phases == 1 ? 0.32 : 0.2);
    const double bottom = plan.site.natural - 0.06;
    return top + (bottom - top) * surface / (plan.surfaces - 1);
}

void make_levels(DigPlan& plan) {
    for (SurfaceNo s = 0; s < plan.surfaces; ++s) {
        const double mean = level_height(plan, s);
        const std::uint64_t key = mix(plan.seed, static_cast<std::uint64_t>(700 + s));
        HeightTable level(plan.site.trench, plan.site.table_step);
        level.fill([&](double x, double y) {
            return mean + 0.012 * noise(key, x / 1.7, y / 1.7) + 0.004 * noise(mix(key, 1), x / 0.25, y / 0.25);
        });
        plan.levels.push_back(std::move(level));
    }
}

// First surface on which the unit shows: its highest body is above that level.
SurfaceNo first_seen(const DigPlan& plan, double highest) {
    for (SurfaceNo s = 0; s < plan.surfaces; ++s) {
        if (level_height(plan, s) < highest - 0.02) return s;
    }
    return plan.surfaces - 1;
}

std::vector<double> highest_points(const Formation& formation, const ColumnGrid& grid) {
    std::vector<double> highest(formation.units().size(), -1e9);
    for (std::size_t i = 0; i < grid.size(); ++i) {
        for (const Run& run : grid.at(i)) {
            double& now = highest[static_cast<std::size_t>(run.unit)];
            now = std::max(now, static_cast<double>(run.high));
        }
    }
    return highest;
}

// Mixed: what fills a hollow and thin floors go whole, soon after they show; the spreads go in levels.
void schedule_levels(DigPlan& plan, const Formation& formation, const ColumnGrid& grid) {
    const std::vector<double> highest = highest_points(formation, grid);
    for (std::size_t u = 0; u < plan.out.size(); ++u) {
        const FormedUnit& unit = formation.units()[u];
        plan.out[u] = kNever;
        const bool whole = plan.method == DigMethod::Mixed && (unit.form == UnitForm::Fill || unit.thin);
        if (!whole) continue;
        plan.out[u] = std::min(first_seen(plan, highest[u]) + 1, plan.surfaces - 1);
    }
    // A lower fill cannot go before the one above it; one that was recognised late goes a surface later.
    for (std::size_t u = plan.out.size(); u-- > 0;) {
        if (plan.out[u] == kNever || formation.units()[u].form != UnitForm::Fill) continue;
        const UnitNo cut = formation.units()[u].cut;
        if (std::find(plan.late.begin(), plan.late.end(), cut) != plan.late.end()) {
            plan.out[u] = std::min(plan.out[u] + 1, plan.surfaces - 1);
        }
        for (std::size_t v = u + 1; v < plan.out.size(); ++v) {
            if (formation.units()[v].cut == cut && formation.units()[v].form == UnitForm::Fill) {
                plan.out[u] = std::max(plan.out[u], plan.out[v]);
            }
        }
    }
}

void choose_late(DigPlan& plan, const Formation& formation, Draw& draw) {
    if (!plan.has_levels()) return;
    std::vector<UnitNo> pits;
    for (std::size_t u = 0; u < formation.units().size(); ++u) {
        const FormedUnit& unit = formation.units()[u];
        if (unit.kind == UnitKind::Cut && unit.title.find("pit") != std::string::npos)
            pits.push_back(static_cast<UnitNo>(u));
    }
    const std::size_t wanted = std::max<std::size_t>(1, pits.size() / 6);
    for (std::size_t i = 0; i < wanted && !pits.empty(); ++i) {
        const auto at = static_cast<std::size_t>(draw.below(static_cast<int>(pits.size())));
        plan.late.push_back(pits[at]);
        pits.erase(pits.begin() + static_cast<std::ptrdiff_t>(at));
    }
    std::sort(plan.late.begin(), plan.late.end());
}

// The surface on which the last fill of a pit is gone, if it were not for the half-section.
SurfaceNo emptied_on(const DigPlan& plan, const Formation& formation, UnitNo cut) {
    SurfaceNo last = 1;
    for (std::size_t u = 0; u < formation.units().size(); ++u) {
        if (formation.units()[u].cut == cut && plan.out[u] < kSide) last = std::max(last, plan.out[u]);
    }
    if (plan.method == DigMethod::Planum) return plan.surfaces - 2;
    return plan.has_levels() ? std::min(last, plan.surfaces - 2) : last;
}

// Can one half stay a surface longer without what the pit was cut into going first?
bool may_wait(const DigPlan& plan, const std::vector<Contact>& contacts, UnitNo cut, SurfaceNo second) {
    if (second >= plan.surfaces) return false;
    return plan.has_levels() || std::none_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
               return contact.later == cut && plan.out[static_cast<std::size_t>(contact.earlier)] < second;
           });
}

// Or can the other half go a surface earlier: is everything off that lay on the pit?
bool may_begin(const DigPlan& plan, const Formation& formation, const std::vector<Contact>& contacts, UnitNo cut,
               SurfaceNo first) {
    return first >= 1 && std::none_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
               const auto of_pit = [&](UnitNo unit) {
                   return unit == cut || formation.units()[static_cast<std::size_t>(unit)].cut == cut;
               };
               return of_pit(contact.earlier) && !of_pit(contact.later) &&
                      plan.out[static_cast<std::size_t>(contact.later)] > first;
           });
}

void choose_half(DigPlan& plan, const Formation& formation, const std::vector<Contact>& contacts, Draw& draw) {
    std::vector<std::pair<const FormationEvent*, SurfaceNo>> pits; // and when the first half is empty
    for (const FormationEvent& event : formation.events()) {
        if (event.type != FormationEvent::Type::Cut || event.cut.plan != Plan::Round || event.cut.radius < 0.3)
            continue;
        if (plan.late.size() > 1 && std::find(plan.late.begin(), plan.late.end(), event.unit) != plan.late.end())
            continue;
        const SurfaceNo emptied = emptied_on(plan, formation, event.unit);
        if (may_wait(plan, contacts, event.unit, emptied + 1)) {
            pits.emplace_back(&event, emptied);
        } else if (may_begin(plan, formation, contacts, event.unit, emptied - 1)) {
            pits.emplace_back(&event, emptied - 1);
        }
    }
    if (pits.empty()) return;
    const auto& [chosen, first] = pits[static_cast<std::size_t>(draw.below(static_cast<int>(pits.size())))];
    const FormationEvent& pit = *chosen;
    HalfSection& half = plan.half;
    half.cut = pit.unit;
    half.x = pit.cut.x;
    half.y = pit.cut.y;
    const double angle = draw.between(0.0, 2.0 * std::numbers::pi);
    half.normal_x = std::cos(angle);
    half.normal_y = std::sin(angle);
    half.first = first;
}

void choose_overdug(DigPlan& plan, const ColumnGrid& grid, Draw& draw) {
    if (plan.method != DigMethod::Stratigraphic) return;
    for (int attempt = 0; attempt < 400; ++attempt) {
        const auto column = static_cast<std::size_t>(draw.between(0.15, 0.85) * static_cast<double>(grid.columns()));
        const auto row = static_cast<std::size_t>(draw.between(0.15, 0.85) * static_cast<double>(grid.rows()));
        const double x = grid.x_of(column);
        if (plan.in_baulk(x - 0.45) || plan.in_baulk(x + 0.45) || plan.in_baulk(x)) continue;
        const auto runs = grid.at(row * grid.columns() + column);
        for (std::size_t i = 1; i < runs.size(); ++i) {
            const SurfaceNo above = plan.out[static_cast<std::size_t>(runs[i - 1].unit)];
            const SurfaceNo below = plan.out[static_cast<std::size_t>(runs[i].unit)];
            if (above >= below || above > plan.surfaces - 2 || runs[i].cut != kAir ||
                runs[i].high - runs[i].low < 0.15F)
                continue;
            const Vec3 centre{x, grid.y_of(row), static_cast<double>(runs[i].high)};
            plan.overdug = {
                true, above, centre, {draw.between(0.28, 0.4), draw.between(0.2, 0.3), draw.between(0.05, 0.08)}};
            return;
        }
    }
}

void choose_slump(DigPlan& plan, Draw& draw) {
    if (plan.surfaces < 4) return;
    Slump& slump = plan.slump;
    slump.fell = true;
    slump.surface = plan.surfaces / 2;
    const bool near_side = draw.chance(0.5);
    slump.x = plan.site.trench.low.x + draw.between(0.15, 0.3) * (plan.site.trench.high.x - plan.site.trench.low.x);
    slump.y = near_side ? plan.site.trench.low.y : plan.site.trench.high.y;
    slump.half_x = draw.between(0.5, 0.9);
    slump.half_y = draw.between(0.4, 0.7);
    slump.height = draw.between(0.2, 0.35);
}

} // namespace

bool OverdugPatch::holds(const Vec3& p) const noexcept {
    if (!made) return false;
    const double x = (p.x - centre.x) / radii.x;
    const double y = (p.y - centre.y) / radii.y;
    const double z = (p.z - centre.z) / radii.z;
    return x * x + y * y + z * z < 1.0;
}

bool Slump::holds(const Vec3& p) const noexcept {
    if (!fell || p.z > floor + height) return false;
    const double u = (p.x - x) / half_x;
    const double v = (p.y - y) / half_y;
    const double r2 = u * u + v * v;
    return r2 < 1.0 && p.z < floor + height * (1.0 - r2);
}

double DigPlan::side_height(double x, double y) const noexcept {
    const double from_x = std::min(x - site.trench.low.x, site.trench.high.x - x);
    const double from_y = std::min(y - site.trench.low.y, site.trench.high.y - y);
    return site.trench.high.z + 0.1 - std::min(from_x, from_y) / kBatter;
}

SurfaceNo DigPlan::dug_on(const FormedUnit& formed, UnitNo unit, const Vec3& p) const noexcept {
    SurfaceNo gone = out[static_cast<std::size_t>(unit)];
    if (half.cut != kAir && formed.cut == half.cut && formed.form == UnitForm::Fill) {
        const bool first = (p.x - half.x) * half.normal_x + (p.y - half.y) * half.normal_y > 0.0;
        const SurfaceNo emptied = first ? half.first : std::min(half.first + 1, surfaces - 1);
        gone = emptied;
    }
    if (has_levels() && formed.kind != UnitKind::Structure) {
        // What is still in a hollow below the last level is emptied on the last day.
        if (formed.form == UnitForm::Fill) gone = std::min(gone, surfaces - 1);
        for (SurfaceNo s = 0; s < std::min(surfaces, gone); ++s) {
            if (p.z > levels[static_cast<std::size_t>(s)].at(p.x, p.y)) {
                gone = s;
                break;
            }
        }
    }
    return overdug.holds(p) ? std::min(gone, overdug.surface) : gone;
}

SurfaceNo DigPlan::gone_without_baulk(const Formation& formation, UnitNo unit, const Vec3& p) const noexcept {
    const FormedUnit& formed = formation.units()[static_cast<std::size_t>(unit)];
    const SurfaceNo gone = dug_on(formed, unit, p);
    if (formed.kind == UnitKind::Structure) return gone;
    const UnitNo wall = formation.wall_over(p);
    return wall == kAir ? gone : std::max(gone, out[static_cast<std::size_t>(wall)]);
}

SurfaceNo DigPlan::gone_on(const Formation& formation, UnitNo unit, const Vec3& p) const noexcept {
    if (p.z < side_height(p.x, p.y)) return kSide;
    const SurfaceNo gone = gone_without_baulk(formation, unit, p);
    return in_baulk(p.x) && gone > 0 && gone < surfaces ? surfaces - 1 : gone;
}

std::string day_after(const std::string& first, int offset) {
    const auto part = [&](std::size_t at, std::size_t n) { return std::stoi(first.substr(at, n)); };
    const std::chrono::sys_days day = std::chrono::year(part(0, 4)) / part(5, 2) / part(8, 2);
    const std::chrono::year_month_day date(day + std::chrono::days(offset));
    return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                       static_cast<unsigned>(date.day()));
}

DigPlan plan_dig(const SiteShape& site, const Formation& formation, const ColumnGrid& grid,
                 const std::vector<Contact>& contacts, DigMethod method, std::uint64_t seed) {
    DigPlan plan;
    plan.method = method;
    plan.surfaces = site.days;
    plan.site = site;
    plan.seed = seed;
    plan.out.assign(formation.units().size(), kNever);
    Draw draw(seed, 300);
    for (int day = 0; day < site.days; ++day) plan.days.push_back(day_after("2025-06-01", day));
    choose_late(plan, formation, draw);
    if (plan.has_levels()) {
        make_levels(plan);
        schedule_levels(plan, formation, grid);
    } else {
        schedule_units(plan, formation, contacts);
    }
    const double width = site.trench.high.x - site.trench.low.x;
    if (site.days >= 4) {
        plan.baulk_low = site.trench.low.x + draw.between(0.08, 0.16) * width;
        plan.baulk_high = plan.baulk_low + std::min(0.5, 0.06 * width);
        choose_half(plan, formation, contacts, draw);
    }
    choose_overdug(plan, grid, draw);
    choose_slump(plan, draw);
    return plan;
}

} // namespace planum::app::demo
