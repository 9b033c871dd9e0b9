// SPDX-License-Identifier: MIT
#include "app/finds/assign_finds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "app/finds/bodies_at.hpp"
#include "app/regions/region_names.hpp"
#include "app/regions/region_points.hpp"
#include "app/scans/days_surface.hpp"
#include "app/scans/surface_scans.hpp"
#include "app/surfaces/recorded_surface.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/geometry/polygons.hpp"

namespace planum::app {

namespace {

constexpr double kReach = 0.05; ///< ground so far around the find gives its height [m]

// One find with what the surfaces of each area show at its place.
struct PlacedFind {
    const model::Find* find = nullptr;
    std::vector<std::vector<SeenThere>> areas; ///< those that show something there
};

std::optional<HeightRange> height_of_points(const model::Find& find, double ceiling,
                                            const std::vector<PlacedScan>& scans) {
    RegionGround ground;
    ground.shape = {{{{*find.x - kReach, *find.y - kReach, 0.0},
                      {*find.x + kReach, *find.y - kReach, 0.0},
                      {*find.x + kReach, *find.y + kReach, 0.0},
                      {*find.x - kReach, *find.y + kReach, 0.0}}}};
    ground.high = ceiling;
    std::vector<double> z;
    for_points_on(ground, scans, [&](const RegionPoint& point) { z.push_back(point.x_in_site.z()); });
    if (z.empty()) return std::nullopt;
    std::sort(z.begin(), z.end());
    const auto quantile = [&](double share) {
        return z[static_cast<std::size_t>(std::lround(share * static_cast<double>(z.size() - 1)))];
    };
    return HeightRange{quantile(0.16), quantile(0.84)};
}

// Without points the outline says between which heights its ground lies, where it has heights.
std::optional<HeightRange> height_of_outline(const model::Region& region) {
    if (!region.has_heights || region.outline.empty()) return std::nullopt;
    HeightRange range{1e300, -1e300};
    for (const model::Polygon& polygon : region.outline) {
        for (const auto& p : polygon.outer) {
            range.low = std::min(range.low, p[2]);
            range.high = std::max(range.high, p[2]);
        }
    }
    return range;
}

enum class DugOn { Yes, No, Unknown };

// Whether the record says that a unit was dug on a day.
DugOn dug_on(const model::StratigraphicUnit& unit, const std::string& day) {
    const std::string& from = unit.excavated_from.empty() ? unit.excavated_on : unit.excavated_from;
    if (day.empty() || from.empty()) return DugOn::Unknown;
    const bool within = from <= day && (unit.excavated_on.empty() || day <= unit.excavated_on);
    return within ? DugOn::Yes : DugOn::No;
}

class Assigner {
  public:
    Assigner(Project& project, Progress& progress)
        : project_(project), record_(project.record()), index_(project.index()), progress_(progress),
          grounds_(region_grounds(record_)) {}

    FindAssignment propose(const std::string& day) {
        std::vector<PlacedFind> finds;
        for (const model::Find& find : record_.finds) {
            if (find.unit.is_nil() && (day.empty() || find.found_on == day)) finds.push_back({&find, {}});
        }
        std::vector<model::AreaId> areas = {{}};
        for (const model::Area& area : record_.areas) areas.push_back(area.id);
        for (const model::AreaId area : areas) {
            for (PlacedFind& find : finds) find.areas.emplace_back();
            for (const model::Surface* surface : surfaces_in_time(record_, area)) look_at(*surface, finds);
            for (PlacedFind& find : finds) {
                if (find.areas.back().empty()) find.areas.pop_back();
            }
        }
        for (const PlacedFind& find : finds) result_.proposals.push_back(judge(find));
        return std::move(result_);
    }

  private:
    void look_at(const model::Surface& surface, std::vector<PlacedFind>& finds) {
        progress_.check();
        std::vector<PlacedFind*> there;
        for (std::size_t i = 0; i < record_.regions.size(); ++i) {
            const model::Region& region = record_.regions[i];
            if (region.surface != surface.id || grounds_[i].shape.empty()) continue;
            for (PlacedFind& placed : finds) {
                const model::Find& find = *placed.find;
                if (!find.x || !find.y || !geometry::contains(grounds_[i].shape, *find.x, *find.y)) continue;
                placed.areas.back().push_back({&surface, &region, {}});
                there.push_back(&placed);
            }
        }
        if (there.empty()) return;
        const std::vector<PlacedScan> scans = scans_of(surface);
        for (PlacedFind* placed : there) {
            SeenThere& seen = placed->areas.back().back();
            const auto at = static_cast<std::size_t>(seen.region - record_.regions.data());
            seen.face = height_of_points(*placed->find, grounds_[at].high, scans);
            if (!seen.face) seen.face = height_of_outline(*seen.region);
        }
    }

    std::vector<PlacedScan> scans_of(const model::Surface& surface) {
        std::vector<PlacedScan> placed;
        for (const model::Scan& scan : record_.scans) {
            if (!may_show(record_, scan, surface)) continue;
            try {
                auto one = placed_scans(
                    project_, [&](const model::Scan& other) { return other.id == scan.id; }, progress_);
                std::move(one.begin(), one.end(), std::back_inserter(placed));
            } catch (const Error& e) {
                if (e.code() == ErrorCode::Cancelled) throw;
                const std::string where = "scan " + scan.name;
                const bool said = std::any_of(result_.problems.begin(), result_.problems.end(),
                                              [&](const ScanProblem& problem) { return problem.where == where; });
                if (!said) result_.problems.push_back({where, e.what()});
            }
        }
        return placed;
    }

    [[nodiscard]] FindProposal judge(const PlacedFind& placed) const;
    void judge_height(const model::Find& find, const std::vector<BodyThere>& bodies, FindProposal& proposal) const;
    [[nodiscard]] const model::StratigraphicUnit* unit_of(const BodyThere& body) const;
    [[nodiscard]] std::vector<std::string> rivals_of(const BodyThere& body, const std::string& day) const;
    void judge_surface(const PlacedFind& placed, const std::vector<BodyThere>& bodies, FindProposal& proposal) const;
    [[nodiscard]] std::string name_of(const BodyThere& body) const;
    [[nodiscard]] std::string seen_text(const SeenThere& seen) const;
    [[nodiscard]] std::vector<std::string> names_of(const std::vector<const BodyThere*>& bodies) const;

    Project& project_;
    const model::Record& record_;
    const model::RecordIndex& index_;
    Progress& progress_;
    std::vector<RegionGround> grounds_;
    FindAssignment result_;
};

// Of the bodies at one place those that were to be seen between the last surface before the day and the first after it.
std::vector<BodyThere> bodies_of_day(const std::vector<BodyThere>& bodies, const std::string& day) {
    std::vector<BodyThere> kept;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const bool gone_before = i + 1 < bodies.size() && last_day_of(*bodies[i + 1].first->surface) < day;
        const bool bare_later = i > 0 && bodies[i - 1].last->surface->first_day > day;
        if (day.empty() || !(gone_before || bare_later)) kept.push_back(bodies[i]);
    }
    return kept;
}

FindProposal Assigner::judge(const PlacedFind& placed) const {
    const model::Find& find = *placed.find;
    FindProposal proposal;
    proposal.id = find.id;
    proposal.find = find.number;
    if (!find.x || !find.y) {
        proposal.reason = "it has no place: x and y are missing";
        return proposal;
    }
    std::vector<BodyThere> bodies;
    for (const auto& seen : placed.areas) {
        const std::vector<BodyThere> here = bodies_of_day(bodies_there(record_, seen), find.found_on);
        bodies.insert(bodies.end(), here.begin(), here.end());
    }
    if (bodies.empty()) {
        proposal.reason = "no region of a unit covers its place on any surface";
    } else if (find.z) {
        judge_height(find, bodies, proposal);
    } else {
        judge_surface(placed, bodies, proposal);
    }
    return proposal;
}

void Assigner::judge_height(const model::Find& find, const std::vector<BodyThere>& bodies,
                            FindProposal& proposal) const {
    const double z = *find.z;
    const double tolerance = record_.settings.tolerance;
    std::vector<const BodyThere*> possible;
    for (const BodyThere& body : bodies) {
        const bool above_it = body.top && z > body.top->high + tolerance;
        const bool below_it = body.bottom && z < body.bottom->low - tolerance;
        const model::StratigraphicUnit* unit = unit_of(body);
        const bool another_day = unit != nullptr && dug_on(*unit, find.found_on) == DugOn::No;
        if (!body.is_cut && !above_it && !below_it && !another_day) possible.push_back(&body);
    }
    const std::vector<std::string> names = names_of(possible);
    if (possible.empty()) {
        proposal.reason = fmt::format("at {:.2f} m it lies in no unit that lay bare there and was dug that day: {}", z,
                                      seen_text(*bodies.front().first));
        return;
    }
    if (names.size() > 1) {
        proposal.candidates = names;
        proposal.reason = fmt::format("at {:.2f} m it may lie in {}", z, text::join(names, " or "));
        return;
    }
    const BodyThere& body = *possible.front();
    if (body.unit.is_nil()) {
        proposal.reason = fmt::format("it lies in region {}, which has no unit yet",
                                      region_name(record_, index_, *body.first->region));
        return;
    }
    proposal.candidates = names;
    if (!body.top || !body.bottom) {
        const std::string lacks = !body.top               ? "its upper face has no height there"
                                  : body.below == nullptr ? "no later surface shows there what lies below it"
                                                          : "its lower face has no height there";
        proposal.reason = fmt::format("at {:.2f} m it lies in {} or below: {}", z, names.front(), lacks);
        return;
    }
    if (const auto rivals = rivals_of(body, find.found_on); !rivals.empty()) {
        proposal.candidates.insert(proposal.candidates.end(), rivals.begin(), rivals.end());
        proposal.reason = fmt::format("at {:.2f} m it lies in {} or in what no surface shows there: {}", z,
                                      names.front(), text::join(rivals, ", "));
        return;
    }
    proposal.unit = names.front();
    proposal.reason =
        fmt::format("at {:.2f} m it lies between {} and {}", z, seen_text(*body.first), seen_text(*body.below));
}

void Assigner::judge_surface(const PlacedFind& placed, const std::vector<BodyThere>& bodies,
                             FindProposal& proposal) const {
    std::vector<const BodyThere*> all;
    for (const BodyThere& body : bodies) all.push_back(&body);
    const std::vector<std::string> names = names_of(all);
    const std::string& day = placed.find->found_on;
    const SeenThere* its = nullptr; // the surface it was lifted from: of its day, else the last before
    if (placed.areas.size() == 1 && !day.empty()) {
        for (const SeenThere& seen : placed.areas.front()) {
            if (seen.surface->first_day <= day) its = &seen;
        }
    }
    if (its != nullptr && its->face) proposal.z = 0.5 * (its->face->low + its->face->high);
    const std::string height = proposal.z    ? fmt::format("it gets the height of {}", seen_text(*its))
                               : day.empty() ? std::string("it has no height and no day")
                                             : std::string("it has no height, and no surface of its day gives it one");
    proposal.candidates = names;
    if (names.size() > 1) {
        proposal.reason = fmt::format("{}; it may belong to {}", height, text::join(names, " or "));
        return;
    }
    const BodyThere& body = bodies.front();
    const model::StratigraphicUnit* unit = unit_of(body);
    if (unit != nullptr && dug_on(*unit, day) == DugOn::No) {
        proposal.candidates.clear();
        proposal.reason = fmt::format("{}; {} was dug on other days", height, names.front());
        return;
    }
    if (body.unit.is_nil() || body.is_cut || !proposal.z) {
        proposal.reason = body.is_cut ? height + "; a cut holds no find" : height;
        if (body.unit.is_nil() || body.is_cut) proposal.candidates.clear();
        return;
    }
    proposal.unit = names.front();
    proposal.reason = fmt::format("{}; all surfaces about its day show {} there", height, proposal.unit);
}

const model::StratigraphicUnit* Assigner::unit_of(const BodyThere& body) const {
    const model::UnitIndex at = index_.find(body.unit);
    return at == model::kNoUnit ? nullptr : &record_.units[at];
}

// Units that may have been dug at the place between two surfaces: drawn on no surface at all, not known to be dug on
// another day, and on stratigraphic surfaces in touch with the body by a relation. What was found and emptied within
// one level touches what the level shows only by chance.
std::vector<std::string> Assigner::rivals_of(const BodyThere& body, const std::string& day) const {
    std::vector<std::string> rivals;
    const auto is_level = [](const SeenThere* seen) {
        return seen != nullptr && seen->surface->method != model::DigMethod::Stratigraphic;
    };
    const bool by_levels = is_level(body.first) || is_level(body.below);
    for (const model::StratigraphicUnit& unit : record_.units) {
        const bool holds_nothing = unit.kind == model::UnitKind::Cut || unit.kind == model::UnitKind::Interface;
        if (unit.id == body.unit || holds_nothing || dug_on(unit, day) == DugOn::No) continue;
        const bool drawn =
            std::any_of(record_.regions.begin(), record_.regions.end(), [&](const model::Region& region) {
                return region.unit == unit.id && !region.surface.is_nil();
            });
        const bool touches =
            std::any_of(record_.relations.begin(), record_.relations.end(), [&](const model::PhysicalRelation& r) {
                return (r.subject == unit.id && r.object == body.unit) ||
                       (r.subject == body.unit && r.object == unit.id);
            });
        if ((touches || by_levels) && !drawn) rivals.push_back(index_.name(unit.id));
    }
    std::sort(rivals.begin(), rivals.end(), text::NaturalLess{});
    return rivals;
}

std::string Assigner::name_of(const BodyThere& body) const {
    return body.unit.is_nil() ? "region " + region_name(record_, index_, *body.first->region) : index_.name(body.unit);
}

std::vector<std::string> Assigner::names_of(const std::vector<const BodyThere*>& bodies) const {
    std::vector<std::string> names;
    for (const BodyThere* body : bodies) names.push_back(name_of(*body));
    std::sort(names.begin(), names.end(), text::NaturalLess{});
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

// `12 at 9.80 m on 2025-06-02`
std::string Assigner::seen_text(const SeenThere& seen) const {
    const std::string label = region_label(record_, index_, *seen.region);
    const std::string surface = surface_name(record_, *seen.surface);
    if (!seen.face) return fmt::format("{} on {}", label, surface);
    return fmt::format("{} at {:.2f} m on {}", label, 0.5 * (seen.face->low + seen.face->high), surface);
}

void apply(Project& project, FindAssignment& assignment) {
    std::vector<model::Find> changed;
    for (const FindProposal& proposal : assignment.proposals) {
        if (proposal.unit.empty() && !proposal.z) continue;
        for (const model::Find& find : project.record().finds) {
            if (find.id != proposal.id) continue;
            model::Find wished = find;
            if (!proposal.unit.empty()) {
                wished.unit = project.record().units[project.unit_named(proposal.unit)].id;
            }
            if (!wished.z) wished.z = proposal.z;
            if (!(wished == find)) changed.push_back(std::move(wished));
        }
    }
    assignment.applied = changed.size();
    if (changed.empty()) return;
    project.change(fmt::format("Assign {} finds", changed.size()), [&] {
        for (const model::Find& find : changed) project.file().update(find);
    });
}

} // namespace

FindAssignment assign_finds(Project& project, const AssignOptions& options, Progress& progress) {
    if (!options.day.empty()) require_day("--day", options.day);
    FindAssignment assignment = Assigner(project, progress).propose(options.day);
    if (options.apply) apply(project, assignment);
    return assignment;
}

} // namespace planum::app
