// SPDX-License-Identifier: MIT
#include "app/drawing/draw_matrix.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "app/checks/daily_check.hpp"
#include "app/drawing/compare_readings.hpp"
#include "app/drawing/former_places.hpp"
#include "core/base/calendar.hpp"
#include "core/base/error.hpp"
#include "strat/layout/drawing_evidence.hpp"
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

// Asked for what the site does not have, a drawing would silently be the ordinary one.
void refuse_what_is_not_there(const model::Record& record, const strat::DrawingOptions& options) {
    const auto refuse = [](const char* option, const char* what) {
        throw Error(ErrorCode::NotFound, fmt::format("{}: the site has no {} yet", option, what));
    };
    const bool phases = !record.phases.empty();
    const bool periods = !record.periods.empty();
    if (options.fold == strat::Fold::Phases && !phases) refuse("fold", "phases");
    if (options.fold == strat::Fold::Periods && !periods) refuse("fold", "periods");
    if (options.fold == strat::Fold::Groups && record.groups.empty()) refuse("fold", "groups");
    if (options.bands == strat::Bands::Phases && !phases) refuse("bands", "phases");
    if (options.bands == strat::Bands::Periods && !periods) refuse("bands", "periods");
    if (options.frames == strat::Frames::Groups && record.groups.empty()) refuse("frames", "groups");
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

void colour_by_evidence(Project& project, const DrawRequest& request, const DailyCheck& check,
                        const strat::TextMeasure& text, strat::MatrixDrawing& drawing) {
    const auto verdicts = strat::line_verdicts(drawing, strat::DrawingIndex(drawing),
                                               interpreted(project.record(), request.interpretation), check.verdicts);
    strat::show_evidence(drawing, verdicts,
                         request.language == "de" ? strat::german_evidence_words() : strat::EvidenceWords{}, text);
}

void keep_problems(const DailyCheck& check, strat::DrawingOptions& options) {
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
    options.subtitle = options.words.problems;
}

struct LoggedSince {
    std::set<std::string> inserted; // uuids
    std::set<std::string> touched;
};

LoggedSince logged_since(Project& project, const std::string& since) {
    constexpr std::size_t kMost = 1'000'000;
    LoggedSince logged;
    for (const store::LogEntry& entry : project.file().log(std::nullopt, kMost)) {
        if (entry.made_at < since) continue;
        (entry.action == "insert" ? logged.inserted : logged.touched).insert(entry.uuid);
    }
    return logged;
}

// The reading as it was: without what came since, with what went since.
model::Record state_before(Project& project, const model::Record& now, const LoggedSince& logged,
                           const std::string& since) {
    model::Record before = now;
    std::erase_if(before.units, [&](const auto& u) { return logged.inserted.contains(u.id.to_string()); });
    std::erase_if(before.relations, [&](const auto& r) { return logged.inserted.contains(r.id.to_string()); });
    store::RemovedRecords removed = project.file().load_removed(since);
    const auto existed = [&](const auto& value) { return !logged.inserted.contains(value.id.to_string()); };
    std::copy_if(removed.units.begin(), removed.units.end(), std::back_inserter(before.units), existed);
    std::set<model::UnitId> known;
    for (const model::Record* record : {&now, &std::as_const(before)}) {
        for (const model::StratigraphicUnit& unit : record->units) known.insert(unit.id);
    }
    std::copy_if(removed.relations.begin(), removed.relations.end(), std::back_inserter(before.relations),
                 [&](const model::PhysicalRelation& r) {
                     return existed(r) && known.contains(r.subject) && known.contains(r.object);
                 });
    model::sort_record(before);
    return before;
}

// Draws only what tells the two states apart.
void keep_differences(Comparison comparison, model::Record& drawn, strat::DrawingOptions& options) {
    for (const strat::UnitMark& mark : comparison.units) options.only.push_back(mark.unit);
    options.marks = std::move(comparison.units);
    options.order_marks = std::move(comparison.orders);
    drawn = std::move(comparison.both);
}

void keep_changed(Project& project, const DrawRequest& request, model::Record& drawn, strat::DrawingOptions& options) {
    const LoggedSince logged = logged_since(project, request.since);
    Comparison comparison = compare_readings(state_before(project, drawn, logged, request.since), drawn);
    // What was there before and is there still, but says something else: the log knows it, the two states do not.
    std::set<model::UnitId> marked;
    std::set<std::pair<model::UnitId, model::UnitId>> marked_orders;
    for (const strat::UnitMark& mark : comparison.units) marked.insert(mark.unit);
    for (const strat::OrderMark& mark : comparison.orders) marked_orders.insert({mark.later, mark.earlier});
    const auto mark_unit = [&](model::UnitId unit) {
        if (marked.insert(unit).second) comparison.units.push_back({unit, strat::Mark::Changed});
    };
    for (const model::PhysicalRelation& r : drawn.relations) {
        if (!logged.touched.contains(r.id.to_string()) || logged.inserted.contains(r.id.to_string())) continue;
        if (!marked_orders.insert({r.subject, r.object}).second) continue;
        comparison.orders.push_back({r.subject, r.object, strat::Mark::Changed});
        mark_unit(r.subject);
        mark_unit(r.object);
    }
    for (const model::StratigraphicUnit& unit : drawn.units) {
        if (logged.touched.contains(unit.id.to_string())) mark_unit(unit.id);
    }
    if (comparison.units.empty()) {
        throw Error(ErrorCode::NotFound, "nothing was added, removed or changed since " + request.since);
    }
    keep_differences(std::move(comparison), drawn, options);
    options.subtitle = strat::with_word(options.words.changed_since, request.since);
}

void keep_compared(Project& project, const DrawRequest& request, model::Record& drawn, strat::DrawingOptions& options) {
    const auto& readings = project.record().interpretations;
    const bool is_reading =
        std::any_of(readings.begin(), readings.end(), [&](const auto& i) { return i.name == request.compared_with; });
    // `record` as interpretation diff calls it; `field` is the older word.
    const bool is_record = !is_reading && (request.compared_with == "record" || request.compared_with == "field");
    const std::string before_name = is_record ? std::string() : request.compared_with;
    Comparison comparison = compare_readings(interpreted(project.record(), before_name), drawn);
    const auto name_in = [&](const strat::DrawingWords& words, const std::string& name) {
        return name.empty() ? words.record : name;
    };
    if (comparison.units.empty()) {
        const strat::DrawingWords english;
        throw Error(ErrorCode::NotFound, name_in(english, request.interpretation) + " does not differ from " +
                                             name_in(english, before_name));
    }
    keep_differences(std::move(comparison), drawn, options);
    options.subtitle =
        strat::with_word(strat::with_word(options.words.compared, name_in(options.words, request.interpretation)),
                         name_in(options.words, before_name));
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
    options.words = strat::words_in(request.language);
    options.unit_link = request.unit_link;
    if (!request.unit_link.empty() && request.unit_link.find("{unit}") == std::string::npos &&
        request.unit_link.find("{uuid}") == std::string::npos) {
        throw Error(ErrorCode::Usage, fmt::format("link: {} leads all units to one place; put {{unit}} where the "
                                                  "number goes",
                                                  request.unit_link));
    }
    if (!request.around.empty()) options.around = project.record().units[project.unit_named(request.around)].id;
    if (request.titles) options.labels = strat::Labels::NumbersAndTitles;
    if (!request.area.empty()) options.subtitle = strat::with_word(options.words.area, request.area);
    if (!request.around.empty()) {
        options.subtitle +=
            (options.subtitle.empty() ? "" : ", ") + strat::with_word(options.words.around, request.around);
    }
    options.only = request.only;
    if (!request.only.empty()) options.subtitle = request.only_what;
    std::optional<DailyCheck> check;
    if (request.problems_only || request.evidence) check = check_project(project, request.interpretation, progress);
    if (request.problems_only) keep_problems(*check, options);
    model::Record drawn = interpreted(project.record(), request.interpretation);
    refuse_what_is_not_there(drawn, options);
    if (!request.since.empty() && !request.compared_with.empty()) {
        throw Error(ErrorCode::Usage, "compare: two days or two interpretations, not both at once");
    }
    if (!request.since.empty() && !is_day(request.since.substr(0, 10))) {
        throw Error(ErrorCode::Usage,
                    fmt::format("since: {} is no day; write YYYY-MM-DD, the time behind it if need be", request.since));
    }
    if (!request.since.empty()) keep_changed(project, request, drawn, options);
    if (!request.compared_with.empty()) keep_compared(project, request, drawn, options);
    progress.step("building the matrix");
    const auto matrix = strat::HarrisMatrix::build(drawn);
    strat::PreviousDrawing previous;
    if (!request.keep_places.empty()) {
        if (request.engine == "graphviz") {
            throw Error(ErrorCode::Usage, "keep-places: only the engine planum keeps places");
        }
        previous = former_places(request.keep_places, drawn);
    }
    progress.step("drawing");
    strat::MatrixDrawing drawing = engine_of(request)->draw({drawn, matrix, text, options, previous}, progress);
    if (request.evidence) colour_by_evidence(project, request, *check, text, drawing);
    return drawing;
}

strat::MatrixStats matrix_stats(Project& project, const std::string& interpretation) {
    if (interpretation.empty()) return strat::HarrisMatrix::build(project.record()).stats();
    return strat::HarrisMatrix::build(interpreted(project.record(), interpretation)).stats();
}

} // namespace planum::app
