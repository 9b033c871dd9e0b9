// SPDX-License-Identifier: MIT
#include "app/drawing/draw_matrix.hpp"

#include <map>
#include <memory>
#include <set>

#include <fmt/format.h>

#include "app/checks/daily_check.hpp"
#include "core/base/error.hpp"
#include "strat/layout/graphviz_engine.hpp"
#include "strat/layout/planum_engine.hpp"

namespace planum::app {

namespace {

strat::Fold fold_of(const std::string& word) {
    if (word.empty()) return strat::Fold::None;
    if (word == "phases") return strat::Fold::Phases;
    if (word == "periods") return strat::Fold::Periods;
    if (word == "groups") return strat::Fold::Groups;
    throw Error(ErrorCode::Usage, "fold: " + word + " is none of phases, periods, groups");
}

strat::Bands bands_of(const std::string& word) {
    if (word.empty()) return strat::Bands::Automatic;
    if (word == "none") return strat::Bands::None;
    if (word == "phases") return strat::Bands::Phases;
    if (word == "periods") return strat::Bands::Periods;
    throw Error(ErrorCode::Usage, "bands: " + word + " is none of phases, periods, none");
}

std::unique_ptr<strat::LayoutEngine> engine_of(const DrawRequest& request) {
    if (request.engine.empty() || request.engine == "planum") return std::make_unique<strat::PlanumEngine>();
    if (request.engine == "graphviz") {
        strat::GraphvizOptions options;
        if (!request.layout_worker.empty()) options.executable = request.layout_worker;
        return std::make_unique<strat::GraphvizEngine>(options);
    }
    throw Error(ErrorCode::Usage, "engine: " + request.engine + " is none of planum, graphviz");
}

void keep_problems(Project& project, const DrawRequest& request, strat::DrawingOptions& options, Progress& progress) {
    const DailyCheck check = check_project(project, request.interpretation, progress);
    std::set<model::UnitId> units;
    for (const model::Diagnostic& problem : check.problems) {
        if (problem.severity == model::Severity::Info || problem.relations.empty()) continue;
        for (const model::NamedRelation& relation : problem.relations) {
            units.insert(relation.unit);
            units.insert(relation.other);
        }
    }
    if (units.empty()) throw Error(ErrorCode::NotFound, "no problem to draw: no error or warning names a relation");
    options.only.assign(units.begin(), units.end());
    for (const model::UnitId unit : units) options.marks.push_back({unit, strat::Mark::Problem});
    options.subtitle = "problems";
}

// Units inserted or changed since the day, by the change log; relations added mark both their units changed.
void keep_changed(Project& project, const DrawRequest& request, strat::DrawingOptions& options) {
    constexpr std::size_t kMost = 1'000'000;
    std::map<std::string, strat::Mark> by_uuid;
    for (const store::LogEntry& entry : project.file().log(std::nullopt, kMost)) {
        if (entry.made_at < request.since) continue;
        strat::Mark& mark = by_uuid[entry.uuid];
        if (entry.action == "insert") mark = strat::Mark::Added;
        if (mark == strat::Mark::None) mark = strat::Mark::Changed;
    }
    std::map<model::UnitId, strat::Mark> marks;
    for (const model::StratigraphicUnit& unit : project.record().units) {
        const auto it = by_uuid.find(unit.id.to_string());
        if (it != by_uuid.end()) marks[unit.id] = it->second;
    }
    for (const model::PhysicalRelation& relation : project.record().relations) {
        const auto it = by_uuid.find(relation.id.to_string());
        if (it == by_uuid.end()) continue;
        options.order_marks.push_back({relation.subject, relation.object, it->second});
        marks.try_emplace(relation.subject, strat::Mark::Changed);
        marks.try_emplace(relation.object, strat::Mark::Changed);
    }
    if (marks.empty()) throw Error(ErrorCode::NotFound, "nothing was added or changed since " + request.since);
    for (const auto& [unit, mark] : marks) {
        options.only.push_back(unit);
        options.marks.push_back({unit, mark});
    }
    options.subtitle = "changed since " + request.since;
}

} // namespace

strat::MatrixDrawing draw_matrix(Project& project, const DrawRequest& request, const strat::TextMeasure& text,
                                 Progress& progress) {
    strat::DrawingOptions options;
    options.area = request.area;
    options.fold = fold_of(request.fold);
    options.bands = bands_of(request.bands);
    if (request.frames) {
        if (request.engine == "graphviz") throw Error(ErrorCode::Usage, "frames: only the engine planum draws them");
        options.frames = strat::Frames::Groups;
    }
    options.around_steps = request.around_steps;
    if (!request.around.empty()) options.around = project.record().units[project.unit_named(request.around)].id;
    if (request.titles) options.labels = strat::Labels::NumbersAndTitles;
    if (!request.area.empty()) options.subtitle = "area " + request.area;
    if (!request.around.empty()) options.subtitle = "around unit " + request.around;
    if (request.problems_only) keep_problems(project, request, options, progress);
    if (!request.since.empty()) keep_changed(project, request, options);
    const model::Record record = interpreted(project.record(), request.interpretation);
    progress.step("building the matrix");
    const auto matrix = strat::HarrisMatrix::build(record);
    progress.step("drawing");
    return engine_of(request)->draw({record, matrix, text, options, {}}, progress);
}

strat::MatrixStats matrix_stats(Project& project, const std::string& interpretation) {
    if (interpretation.empty()) return strat::HarrisMatrix::build(project.record()).stats();
    return strat::HarrisMatrix::build(interpreted(project.record(), interpretation)).stats();
}

} // namespace planum::app
