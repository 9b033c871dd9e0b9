// SPDX-License-Identifier: MIT
#include "tests/support/evidence_dig.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <map>

#include <fmt/format.h>

#include "app/checks/daily_check.hpp"
#include "app/evidence/evidence.hpp"
#include "app/import/import_service.hpp"
#include "app/regions/region_import.hpp"
#include "app/registration/import_markers.hpp"
#include "app/scans/add_scans.hpp"
#include "app/scans/days_surface.hpp"
#include "scans/surface/questions.hpp"
#include "tests/support/shown_by_surfaces.hpp"

namespace planum::test {

namespace fs = std::filesystem;

namespace {

template<class Work>
double seconds_of(Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<fs::path> entries_of(const fs::path& folder) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder)) found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

app::Project project_of(const fs::path& file, const fs::path& sheets, model::DigMethod method) {
    model::ProjectSettings settings;
    settings.method = method;
    app::Project project = app::Project::create(file, settings, {});
    app::import_files(project, {sheets}, {}, Progress::none());
    return project;
}

// Numbers as the tally counts: units of the dig in the order in which they formed.
std::vector<scans::Conclusion> numbered_as_formed(const app::demo::DemoDig& dig, app::Project& project,
                                                  const app::AreaEvidence& area) {
    std::map<std::string, int> formed;
    for (std::size_t u = 0; u < dig.formation.units().size(); ++u)
        formed[dig.formation.units()[u].number] = static_cast<int>(u);
    const auto number = [&](scans::UnitNumber u) {
        return formed.at(project.index().name(area.units[static_cast<std::size_t>(u)].id));
    };
    std::vector<scans::Conclusion> conclusions = area.conclusions;
    scans::keep_useful_questions(conclusions, area.units.size());
    for (scans::Conclusion& c : conclusions) {
        c.unit = number(c.unit);
        c.other = number(c.other);
    }
    return conclusions;
}

// What surfaces say of a pair that was missed, step by step, and what was made of it.
void trace(const app::AreaEvidence& area, app::Project& project, const std::string& later, const std::string& earlier) {
    const auto number = [&](const std::string& name) {
        for (std::size_t u = 0; u < area.units.size(); ++u) {
            if (project.index().name(area.units[u].id) == name) return static_cast<scans::UnitNumber>(u);
        }
        return scans::kNobody;
    };
    const scans::UnitNumber u = number(later);
    const scans::UnitNumber v = number(earlier);
    if (u == scans::kNobody || v == scans::kNobody) {
        fmt::print("      {} {}: not outlined\n", later, earlier);
        return;
    }
    const auto& a = area.units[static_cast<std::size_t>(u)];
    const auto& b = area.units[static_cast<std::size_t>(v)];
    fmt::print("      {} {}/{}, {} {}/{}, cells of {:.2f} m\n", later, to_word(a.kind), to_word(a.form), earlier,
               to_word(b.kind), to_word(b.form), area.frame.cell);
    for (std::size_t i = 0; i < area.history.steps.size(); ++i) {
        const double square = area.history.steps[i].cell * area.history.steps[i].cell;
        for (const scans::Succession& s : area.history.steps[i].successions) {
            if ((s.first != u || s.then != v) && (s.first != v || s.then != u)) continue;
            fmt::print(
                "      step {}: {} > {}: {:.3f} m², lower {:.3f}, thin {:.3f}, cut {:.3f} {:.3f}, drop {:.3f} of "
                "{:.3f}, hidden {}\n",
                i, s.first == u ? later : earlier, s.first == u ? earlier : later, square * double(s.cells),
                square * double(s.lower), square * double(s.thin), square * double(s.cut_first),
                square * double(s.cut_then), s.drop, s.tolerance, s.hidden);
        }
        for (const scans::EdgeMigration& e : area.history.steps[i].edges) {
            if ((e.a != u || e.b != v) && (e.a != v || e.b != u)) continue;
            fmt::print("      step {}: line {:.2f} m, followed {:.2f}, into {} {:.2f}, into {} {:.2f}\n", i, e.length,
                       e.followed, e.a == u ? later : earlier, e.into_a, e.a == u ? earlier : later, e.into_b);
        }
    }
    for (const scans::Conclusion& c : area.conclusions) {
        if ((c.unit != u || c.other != v) && (c.unit != v || c.other != u)) continue;
        fmt::print("      {} {} {}: ground {}, {:.3f} m²{}\n", c.is_question ? "question" : "relation",
                   c.unit == u ? later : earlier, to_word(c.kind), static_cast<int>(c.ground), c.area,
                   c.thin ? ", thin" : "");
    }
}

// The same evidence for another record of the same dig, by number.
std::vector<model::SurfaceEvidence> carried_over(const std::vector<model::SurfaceEvidence>& evidence,
                                                 app::Project& from, app::Project& to) {
    std::vector<model::SurfaceEvidence> carried;
    for (model::SurfaceEvidence e : evidence) {
        const auto upper = to.index().named(from.index().name(e.upper));
        const auto lower = to.index().named(from.index().name(e.lower));
        if (upper.size() != 1 || lower.size() != 1) continue;
        e.upper = to.record().units[upper.front()].id;
        e.lower = to.record().units[lower.front()].id;
        carried.push_back(e);
    }
    return carried;
}

std::string why_hidden(const app::demo::DemoDig& dig, const app::demo::Mistake& mistake) {
    const std::string first = mistake.is.substr(0, mistake.is.find(' '));
    const std::string last = mistake.is.substr(mistake.is.rfind(' ') + 1);
    for (const app::demo::Mistake& other : dig.mistakes) {
        if (other.kind == "number-used-twice" && (other.was == first || other.was == last))
            return "another mistake took the number " + other.was + " from the record";
    }
    std::array<app::demo::UnitNo, 2> units{};
    for (std::size_t u = 0; u < dig.formation.units().size(); ++u) {
        if (dig.formation.units()[u].number == first) units[0] = static_cast<app::demo::UnitNo>(u);
        if (dig.formation.units()[u].number == last) units[1] = static_cast<app::demo::UnitNo>(u);
    }
    return why_not_shown(dig, std::max(units[0], units[1]), std::min(units[0], units[1]));
}

void look_for_mistakes(EvidenceDig& result, const app::demo::DemoDig& dig, const app::DailyCheck& check,
                       app::Project& mistaken) {
    for (const app::demo::Mistake& mistake : dig.mistakes) {
        if (mistake.kind != "reversed-relation" || !mistake.visible) continue;
        const std::string why = why_hidden(dig, mistake);
        if (!why.empty()) {
            result.hidden_mistakes.push_back(mistake.is + ": " + why);
            continue;
        }
        ++result.visible_mistakes;
        const bool found = std::any_of(check.problems.begin(), check.problems.end(), [&](const model::Diagnostic& d) {
            return d.code == "height-contradiction" &&
                   std::any_of(d.relations.begin(), d.relations.end(), [&](const model::NamedRelation& r) {
                       return mistake.is.starts_with(mistaken.index().name(r.unit) + " ") &&
                              mistake.is.ends_with(" " + mistaken.index().name(r.other));
                   });
        });
        if (found) {
            ++result.found_mistakes;
        } else {
            result.missed_mistakes.push_back(mistake.is);
        }
    }
}

} // namespace

EvidenceDig evidence_of_dig(const fs::path& folder, const app::demo::SimulationOptions& options,
                            app::RegisterMethod method, const EvidenceWanted& wanted) {
    const app::demo::DemoDig dig = app::demo::simulate(options, Progress::none());
    app::demo::write_demo(dig, folder, Progress::none());
    app::Project project = project_of(folder / "dig.gpkg", folder / "record", options.method);
    std::vector<fs::path> days = entries_of(folder);
    std::erase_if(days, [](const fs::path& path) { return !is_day(path.filename().string()); });
    app::add_scans(project, days, {}, Progress::none());
    app::import_markers(project, folder / "markers.csv", {});
    EvidenceDig result;
    app::RegisterOptions registering;
    registering.method = method;
    result.register_seconds =
        seconds_of([&] { static_cast<void>(app::register_scans(project, registering, Progress::none())); });
    app::import_outline_files(project, entries_of(folder / "outlines"), {}, Progress::none());
    result.scans = project.record().scans.size();
    for (const model::Scan& scan : project.record().scans)
        result.placed += model::pose_in_force(project.record(), scan.id) != nullptr ? 1U : 0U;
    result.surfaces = project.record().surfaces.size();

    std::vector<app::AreaEvidence> areas;
    result.first_seconds = seconds_of([&] { areas = app::gather_evidence(project, Progress::none()); });
    result.again_seconds = seconds_of([&] { areas = app::gather_evidence(project, Progress::none()); });
    std::vector<scans::Conclusion> conclusions;
    for (const app::AreaEvidence& area : areas) {
        const auto more = numbered_as_formed(dig, project, area);
        conclusions.insert(conclusions.end(), more.begin(), more.end());
    }
    result.tally = tally_of(dig, conclusions, wanted.loud);

    const auto evidence = app::surface_evidence(areas);
    for (const model::Diagnostic& d : app::check_record(project.record(), evidence, Progress::none()).problems) {
        if (d.code == "height-contradiction") result.false_contradictions.push_back(d.message);
    }
    app::Project mistaken = project_of(folder / "mistaken.gpkg", folder / "with-mistakes", options.method);
    look_for_mistakes(result, dig,
                      app::check_record(mistaken.record(), carried_over(evidence, project, mistaken), Progress::none()),
                      mistaken);
    if (wanted.volumes) {
        app::EarthReport report;
        result.volume_seconds = seconds_of([&] { report = app::dug_earth(project, {}, Progress::none()); });
        result.volumes = compare_volumes(dig, report);
    }
    if (wanted.loud) {
        const auto& formed = dig.formation.units();
        for (const app::AreaEvidence& area : areas) {
            for (const auto& [later, earlier] : result.tally.missed) {
                fmt::print("    trace of a missed contact\n");
                trace(area, project, formed[static_cast<std::size_t>(later)].number,
                      formed[static_cast<std::size_t>(earlier)].number);
            }
            for (const std::string& mistake : result.missed_mistakes) {
                fmt::print("    trace of a missed mistake: {}\n", mistake);
                trace(area, project, mistake.substr(mistake.rfind(' ') + 1), mistake.substr(0, mistake.find(' ')));
            }
        }
    }
    return result;
}

} // namespace planum::test
