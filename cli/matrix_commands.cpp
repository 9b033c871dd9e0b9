// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <memory>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/drawing/draw_matrix.hpp"
#include "app/export/export_record.hpp"
#include "cli/matrix_options.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "paint/drawing_pdf.hpp"
#include "paint/drawing_png.hpp"
#include "paint/font_measure.hpp"
#include "paint/missing_signs.hpp"
#include "strat/layout/svg_writer.hpp"

namespace planum::cli {

using nlohmann::ordered_json;
using store::OpenMode;

namespace {

ordered_json to_json(const strat::MatrixStats& s) {
    return {{"units", s.units},
            {"orders", s.orders},
            {"same_as", s.same_as},
            {"contemporary", s.contemporary},
            {"merged", s.merged},
            {"self", s.self},
            {"mutual", s.mutual},
            {"cycle_groups", s.cycle_groups},
            {"largest_cycle_group", s.largest_cycle_group},
            {"orders_in_cycles", s.orders_in_cycles},
            {"redundant", s.redundant},
            {"reduced_from", s.reduced_from},
            {"depth", s.depth},
            {"isolated", s.isolated}};
}

void run_stats(const Context& context, const MatrixOptions& options) {
    app::Project project = context.open(OpenMode::ReadOnly);
    const ordered_json stats = to_json(app::matrix_stats(project, options.draw.interpretation));
    if (context.json) return context.print(stats);
    for (const auto& [key, value] : stats.items()) *context.out << fmt::format("{:<20} {}\n", key, value.dump());
}

paint::PdfOptions pdf_options(const app::Project& project, const MatrixOptions& options, const std::string& site) {
    paint::PdfOptions pdf;
    pdf.site = site;
    pdf.words = strat::words_in(options.draw.language);
    pdf.date = project.clock().now().substr(0, 10);
    const std::vector<std::pair<std::string, paint::Paper>> papers = {
        {"fit", paint::Paper::Fitted}, {"a4", paint::Paper::A4}, {"a3", paint::Paper::A3},
        {"a2", paint::Paper::A2},      {"a1", paint::Paper::A1}, {"a0", paint::Paper::A0}};
    for (const auto& [word, paper] : papers) {
        if (word == text::fold_case(options.paper)) pdf.poster.paper = paper;
    }
    if (options.paging == "poster") pdf.poster.paging = paint::Paging::Poster;
    return pdf;
}

// An empty picture would look like a fault.
void refuse_empty(const strat::MatrixDrawing& drawing, app::Project& project, const app::DrawRequest& draw) {
    if (!drawing.boxes.empty()) return;
    if (project.record().units.empty()) {
        throw Error(ErrorCode::NotFound,
                    "nothing to draw: the project has no units yet; see planum import and planum unit add");
    }
    std::vector<std::string> chosen;
    if (!draw.area.empty()) chosen.push_back("in area " + draw.area);
    if (!draw.around.empty()) chosen.push_back("around unit " + draw.around);
    if (draw.problems_only) chosen.emplace_back("that a problem is about");
    if (!draw.since.empty()) chosen.push_back("that changed since " + draw.since);
    if (!draw.compared_with.empty()) chosen.emplace_back("that the readings differ in");
    throw Error(ErrorCode::NotFound, fmt::format("nothing to draw: there is no unit {}", text::join(chosen, " and ")));
}

std::string drawn_as(MatrixKind kind, const strat::MatrixDrawing& drawing, const paint::PdfOptions& pdf,
                     const MatrixOptions& options, Progress& progress) {
    if (kind == MatrixKind::Svg) return strat::write_svg(drawing);
    if (kind == MatrixKind::Png) return paint::render_png(drawing, {.dpi = options.dpi});
    return paint::render_pdf(drawing, pdf, progress);
}

// A wide matrix on one small sheet is a grey strip.
void warn_of_small_print(const Context& context, const MatrixOptions& options, const strat::MatrixDrawing& drawing,
                         const paint::PdfOptions& pdf) {
    constexpr double kLegible = 5.0; // [pt]
    if (pdf.poster.paging == paint::Paging::Poster || drawing.boxes.empty()) return;
    const double size = drawing.boxes.front().text_size * paint::plan_poster(drawing, pdf.poster).scale;
    if (size >= kLegible) return;
    const std::string paper = "A" + options.paper.substr(1); // as paper is called, however it was typed
    context.say(
        fmt::format("{}: on one sheet of {} the numbers are {:.1f} pt high; larger paper or --paging poster makes "
                    "them legible",
                    options.output, paper, size));
}

void run_draw(const Context& context, const MatrixOptions& options, MatrixKind kind) {
    const bool to_stdout = options.output == "-";
    if (to_stdout && context.json) {
        throw Error(ErrorCode::Usage, "matrix: standard output holds the file or what --json says, not both");
    }
    app::Project project = context.open(OpenMode::ReadOnly);
    if (kind == MatrixKind::Export) {
        try {
            return write_export(context, project, options.output, {options.format, options.draw.interpretation});
        } catch (Error& e) {
            if (e.code() == ErrorCode::Usage) e.add_context("a drawing is .svg, .pdf or .png");
            throw;
        }
    }
    const paint::FontTextMeasure measure;
    const strat::MatrixDrawing drawing = app::draw_matrix(project, options.draw, measure, *context.progress);
    refuse_empty(drawing, project, options.draw);
    const paint::PdfOptions pdf = pdf_options(project, options, project.record().settings.name);
    const std::string bytes = drawn_as(kind, drawing, pdf, options, *context.progress);
    if (to_stdout) {
        *context.out << bytes;
    } else {
        write_file_atomically(options.output, bytes);
    }
    if (kind != MatrixKind::Svg) {
        const std::string remark = paint::missing_signs_remark(options.output, paint::missing_signs(drawing));
        if (!remark.empty()) context.say(remark);
    }
    if (kind == MatrixKind::Pdf) warn_of_small_print(context, options, drawing, pdf);
    if (!to_stdout) {
        context.say(fmt::format("wrote {}: {}, {}", options.output, text::counted(drawing.boxes.size(), "box", "boxes"),
                                text::counted(drawing.lines.size(), "line")));
    }
    if (!context.json) return;
    std::size_t units = 0;
    for (const strat::DrawnBox& box : drawing.boxes) units += box.units.size();
    ordered_json summary = {{"files", ordered_json::array({options.output})},
                            {"engine", drawing.engine},
                            {"units", units},
                            {"boxes", drawing.boxes.size()},
                            {"lines", drawing.lines.size()},
                            {"width_pt", drawing.width},
                            {"height_pt", drawing.height}};
    if (kind == MatrixKind::Pdf) summary["sheets"] = paint::plan_poster(drawing, pdf.poster).sheets.size();
    context.print(summary);
}

} // namespace

void add_matrix_commands(CLI::App& root, Context& context) {
    auto options = std::make_shared<MatrixOptions>();
    CLI::App* matrix = add_command(root, context, "matrix", "draw the Harris matrix, write it as a file, or count it");
    add_matrix_options(*matrix, *options);
    matrix->callback([&context, options, matrix] {
        if (!options->stats && options->output.empty()) {
            throw Error(ErrorCode::Usage, "matrix: say -o FILE or --stats");
        }
        const MatrixKind kind = kind_of(*options);
        refuse_useless_options(*matrix, *options, kind);
        if (kind == MatrixKind::Stats) return run_stats(context, *options);
        run_draw(context, *options, kind);
    });
}

} // namespace planum::cli
