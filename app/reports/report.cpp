// SPDX-License-Identifier: MIT
#include "app/reports/report.hpp"

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

void write_report(Project& project, const std::filesystem::path& file, const std::string& interpretation,
                  const strat::TextMeasure& measure, Progress& progress) {
    const std::string ending = text::fold_case(file.extension().string());
    if (ending != ".xml" && ending != ".html") {
        throw Error(ErrorCode::Usage, file.string() + ": a report is .xml or .html");
    }
    const model::Record record = interpreted(project.record(), interpretation);
    const auto matrix = strat::HarrisMatrix::build(record);
    DailyCheck check = check_project(project, interpretation, progress);
    ReportInput input;
    input.record = &record;
    input.matrix = &matrix;
    input.diagnostics = std::move(check.problems);
    input.accepted = std::move(check.accepted);
    input.coverage = std::move(check.coverage);
    input.made_at = project.clock().now();
    input.made_by = project.author();
    input.interpretation = interpretation;
    progress.step("writing " + file.filename().string());
    if (ending == ".xml") return write_file_atomically(file, write_xml_report(input));
    DrawRequest request;
    request.interpretation = interpretation;
    input.drawing_svg = strat::write_svg(draw_matrix(project, request, measure, progress));
    write_file_atomically(file, write_html_report(input));
}

} // namespace planum::app
