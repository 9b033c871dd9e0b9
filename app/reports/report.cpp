// SPDX-License-Identifier: MIT
#include "app/reports/report.hpp"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/checks/daily_check.hpp"
#include "app/drawing/draw_matrix.hpp"
#include "app/reports/days_record.hpp"
#include "app/reports/html_report.hpp"
#include "app/reports/xml_report.hpp"
#include "app/scans/days_surface.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "strat/layout/svg_writer.hpp"

namespace planum::app {

namespace {

/// What a report is made from, with what it points to.
struct Gathered {
    model::Record record;
    std::optional<strat::HarrisMatrix> matrix;
    DaysRecord of_day;
    ReportInput input;
};

void keep_day(Gathered& all, const std::string& day) {
    ReportInput& input = all.input;
    const auto units = units_of_day(all.record, day);
    keep_problems_of_day(input.diagnostics, units, day);
    keep_problems_of_day(input.accepted, units, day);
    std::vector<model::Diagnostic> shown = input.diagnostics;
    shown.insert(shown.end(), input.accepted.begin(), input.accepted.end());
    all.of_day = days_record(all.record, *all.matrix, day, shown);
    input.record = &all.of_day.record;
    input.orders = all.of_day.orders;
    input.day = day;
    input.of_day = all.of_day.units;
}

// By pointer: the input points into it.
std::unique_ptr<Gathered> gather(Project& project, const ReportRequest& request, Progress& progress) {
    if (!request.day.empty()) require_day("--day", request.day);
    auto all = std::make_unique<Gathered>();
    all->record = interpreted(project.record(), request.interpretation);
    all->matrix.emplace(strat::HarrisMatrix::build(all->record));
    DailyCheck check = check_project(project, request.interpretation, progress);
    ReportInput& input = all->input;
    input.record = &all->record;
    input.whole = &all->record;
    input.matrix = &*all->matrix;
    input.orders.assign(all->matrix->reduced().begin(), all->matrix->reduced().end());
    input.diagnostics = std::move(check.problems);
    input.accepted = std::move(check.accepted);
    input.coverage = std::move(check.coverage);
    input.made_at = project.clock().now();
    input.made_by = project.author();
    input.interpretation = request.interpretation;
    if (!request.day.empty()) keep_day(*all, request.day);
    return all;
}

DrawRequest drawing_of(const Gathered& all) {
    DrawRequest drawing;
    drawing.interpretation = all.input.interpretation;
    if (all.input.day.empty()) return drawing;
    for (const model::StratigraphicUnit& unit : all.input.record->units) drawing.only.push_back(unit.id);
    drawing.only_what = "units of " + all.input.day + " and their neighbours";
    return drawing;
}

} // namespace

PrintedReport printed_report(Project& project, const ReportRequest& request, Progress& progress) {
    const std::unique_ptr<Gathered> all = gather(project, request, progress);
    return {write_html_report(all->input, HtmlFor::Paper), drawing_of(*all), !all->input.record->units.empty()};
}

void write_report(Project& project, const std::filesystem::path& file, const ReportRequest& request,
                  const strat::TextMeasure& measure, Progress& progress) {
    const std::string ending = text::fold_case(file.extension().string());
    if (ending != ".xml" && ending != ".html") {
        throw Error(ErrorCode::Usage, file.string() + ": a report is .xml, .html or .pdf");
    }
    const std::unique_ptr<Gathered> all = gather(project, request, progress);
    progress.step("writing " + file.filename().string());
    if (ending == ".xml") return write_file_atomically(file, write_xml_report(all->input));
    if (!all->input.record->units.empty()) {
        DrawRequest drawing = drawing_of(*all);
        drawing.unit_link = "#u-{uuid}"; // the unit's card on the same page
        all->input.drawing_svg = strat::write_svg(draw_matrix(project, drawing, measure, progress));
    }
    write_file_atomically(file, write_html_report(all->input, HtmlFor::Screen));
}

} // namespace planum::app
