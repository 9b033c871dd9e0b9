// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/drawing/draw_matrix.hpp"
#include "app/export/export_record.hpp"
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

struct Options {
    app::DrawRequest draw;
    std::string output;
    std::string paper = "fit";
    std::string paging = "page";
    std::string format;
    double dpi = 150.0;
    bool stats = false;
};

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

void run_stats(const Context& context, const Options& options) {
    app::Project project = context.open(OpenMode::ReadOnly);
    const ordered_json stats = to_json(app::matrix_stats(project, options.draw.interpretation));
    if (context.json) return context.print(stats);
    for (const auto& [key, value] : stats.items()) *context.out << fmt::format("{:<20} {}\n", key, value.dump());
}

paint::PdfOptions pdf_options(const app::Project& project, const Options& options, const std::string& site) {
    paint::PdfOptions pdf;
    pdf.site = site;
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

// What chooses a part of the site is understood by drawings only; a whole site sent off for a part would not be
// noticed.
void refuse_part(const app::DrawRequest& draw) {
    const std::pair<const char*, bool> parts[] = {
        {"area", !draw.area.empty()},   {"around", !draw.around.empty()},         {"fold", !draw.fold.empty()},
        {"since", !draw.since.empty()}, {"compare", !draw.compared_with.empty()}, {"problems", draw.problems_only},
    };
    for (const auto& [name, is_given] : parts) {
        if (!is_given) continue;
        throw Error(ErrorCode::Usage,
                    fmt::format("matrix: a file for other programs holds the whole site; {} makes a part "
                                "of a drawing only (.svg, .pdf, .png)",
                                name));
    }
}

void run_draw(const Context& context, const Options& options) {
    app::Project project = context.open(OpenMode::ReadOnly);
    const std::string kind = options.format.empty()
                                 ? text::fold_case(std::filesystem::path(options.output).extension().string())
                                 : "." + text::fold_case(options.format);
    if (kind != ".svg" && kind != ".pdf" && kind != ".png") {
        refuse_part(options.draw);
        try {
            return write_export(context, project, options.output, {options.format, options.draw.interpretation});
        } catch (Error& e) {
            if (e.code() == ErrorCode::Usage) e.add_context("a drawing is .svg, .pdf or .png");
            throw;
        }
    }
    const paint::FontTextMeasure measure;
    const strat::MatrixDrawing drawing = app::draw_matrix(project, options.draw, measure, *context.progress);
    std::string bytes;
    if (kind == ".svg") bytes = strat::write_svg(drawing);
    if (kind == ".png") bytes = paint::render_png(drawing, {.dpi = options.dpi});
    if (kind == ".pdf") {
        bytes = paint::render_pdf(drawing, pdf_options(project, options, project.record().settings.name),
                                  *context.progress);
    }
    write_file_atomically(options.output, bytes);
    if (kind != ".svg") {
        const std::string remark = paint::missing_signs_remark(options.output, paint::missing_signs(drawing));
        if (!remark.empty()) context.say(remark);
    }
    context.say(
        fmt::format("wrote {}: {} boxes, {} lines", options.output, drawing.boxes.size(), drawing.lines.size()));
}

} // namespace

void add_matrix_commands(CLI::App& root, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* matrix = add_command(root, context, "matrix", "draw the Harris matrix, write it as a file, or count it");
    CLI::Option* output =
        matrix->add_option("-o,--output", options->output,
                           "file to write: .svg .pdf .png are drawings; .dot .graphml .lst .hmcx .csv "
                           ".json are for other programs");
    matrix->add_option("--format", options->format,
                       "format of the file, where its ending does not say (svg, hmc-csv, hm, …)");
    matrix->add_flag("--stats", options->stats, "print counts instead")->excludes(output);
    matrix->add_option("--engine", options->draw.engine, "layout engine");
    matrix->add_option("--interpretation", options->draw.interpretation, "this reading instead of the field record");
    matrix->add_option("--area", options->draw.area, "only this area");
    matrix->add_option("--around", options->draw.around, "only the neighbourhood of this unit");
    matrix->add_option("--steps", options->draw.around_steps, "how far around it")
        ->capture_default_str()
        ->check(CLI::Range(0, 100'000));
    matrix->add_option("--fold", options->draw.fold, "phases, periods or groups: one box each");
    matrix->add_option("--bands", options->draw.bands,
                       "phases, periods or none; unasked where most units have a phase");
    matrix->add_flag("--frames", options->draw.frames, "a frame around the units of each group");
    matrix->add_option("--since", options->draw.since,
                       "only what was added, removed or changed since this day (YYYY-MM-DD)");
    matrix->add_option("--compare", options->draw.compared_with,
                       "only where the interpretation differs from this one (field: from the record itself)");
    matrix->add_flag("--problems", options->draw.problems_only, "only what problems are about");
    matrix->add_flag("--titles", options->draw.titles, "short definitions below the numbers");
    matrix->add_option("--link", options->draw.unit_link,
                       "SVG: where a unit leads to when clicked, {unit} being its number (units.html#{unit})");
    matrix->add_option("--paper", options->paper, "PDF: fit, A4, A3, A2, A1 or A0")
        ->capture_default_str()
        ->check(CLI::IsMember({"fit", "a4", "a3", "a2", "a1", "a0"}, CLI::ignore_case));
    matrix->add_option("--paging", options->paging, "PDF: shrink to one page, or a poster of many sheets")
        ->capture_default_str()
        ->check(CLI::IsMember({"page", "poster"}));
    matrix->add_option("--dpi", options->dpi, "PNG: pixels per inch")
        ->capture_default_str()
        ->check(CLI::Range(20.0, 1200.0))
        ->check(
            [](const std::string& text) {
                // The range takes what is not a number for one inside it.
                return text::fold_case(text).find("nan") == std::string::npos ? std::string{} : "no number";
            },
            "");
    matrix->callback([&context, options] {
        if (options->stats) return run_stats(context, *options);
        if (options->output.empty()) throw Error(ErrorCode::Usage, "matrix: say -o FILE or --stats");
        run_draw(context, *options);
    });
}

} // namespace planum::cli
