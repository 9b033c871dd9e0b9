// SPDX-License-Identifier: MIT
#include "app/reports/report.hpp"

#include <memory>
#include <optional>
#include <utility>

#include "app/checks/daily_check.hpp"
#include "app/drawing/draw_matrix.hpp"
#include "app/reports/html_report.hpp"
#include "app/reports/xml_report.hpp"
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
    ReportInput input;
};

// By pointer: the input points into it.
std::unique_ptr<Gathered> gather(Project& project, const std::string& interpretation, Progress& progress) {
    auto all = std::make_unique<Gathered>();
    all->record = interpreted(project.record(), interpretation);
    all->matrix.emplace(strat::HarrisMatrix::build(all->record));
    DailyCheck check = check_project(project, interpretation, progress);
    ReportInput& input = all->input;
    input.record = &all->record;
    input.matrix = &*all->matrix;
    input.diagnostics = std::move(check.problems);
    input.accepted = std::move(check.accepted);
    input.coverage = std::move(check.coverage);
    input.made_at = project.clock().now();
    input.made_by = project.author();
    input.interpretation = interpretation;
    return all;
}

} // namespace

std::string printed_report(Project& project, const std::string& interpretation, Progress& progress) {
    return write_html_report(gather(project, interpretation, progress)->input, HtmlFor::Paper);
}

void write_report(Project& project, const std::filesystem::path& file, const std::string& interpretation,
                  const strat::TextMeasure& measure, Progress& progress) {
    const std::string ending = text::fold_case(file.extension().string());
    if (ending != ".xml" && ending != ".html") {
        throw Error(ErrorCode::Usage, file.string() + ": a report is .xml, .html or .pdf");
    }
    const std::unique_ptr<Gathered> all = gather(project, interpretation, progress);
    progress.step("writing " + file.filename().string());
    if (ending == ".xml") return write_file_atomically(file, write_xml_report(all->input));
    DrawRequest request;
    request.interpretation = interpretation;
    all->input.drawing_svg = strat::write_svg(draw_matrix(project, request, measure, progress));
    write_file_atomically(file, write_html_report(all->input, HtmlFor::Screen));
}

} // namespace planum::app
