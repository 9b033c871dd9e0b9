// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <unistd.h>

#include "app/drawing/draw_matrix.hpp"
#include "app/export/export_record.hpp"
#include "app/reports/report.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "paint/font_measure.hpp"
#include "paint/missing_signs.hpp"
#include "paint/report_pdf.hpp"

namespace planum::cli {

using nlohmann::ordered_json;
using store::OpenMode;

namespace {

struct Options {
    std::string output;
    std::string format;
    std::string interpretation;
    std::string day;
};

void run_report(const Context& context, const Options& options) {
    app::Project project = context.open(OpenMode::ReadOnly);
    const paint::FontTextMeasure measure;
    const app::ReportRequest request{options.interpretation, options.day};
    if (text::fold_case(std::filesystem::path(options.output).extension().string()) == ".pdf") {
        const app::PrintedReport printed = app::printed_report(project, request, *context.progress);
        paint::ReportPdf report;
        report.html = printed.html;
        std::optional<strat::MatrixDrawing> drawing;
        if (printed.has_drawing) drawing = app::draw_matrix(project, printed.drawing, measure, *context.progress);
        report.drawing = drawing ? &*drawing : nullptr;
        report.site = project.record().settings.name;
        report.date = project.clock().now().substr(0, 10);
        write_file_atomically(options.output, paint::render_report_pdf(report, *context.progress));
        const std::string remark = paint::missing_signs_remark(options.output, paint::missing_signs(printed.html));
        if (!remark.empty()) context.say(remark);
        context.say("wrote " + options.output);
        return;
    }
    app::write_report(project, options.output, request, measure, *context.progress);
    context.say("wrote " + options.output);
}

void run_export(const Context& context, const Options& options) {
    app::Project project = context.open(OpenMode::ReadOnly);
    write_export(context, project, options.output, {options.format, options.interpretation});
}

// To standard output, by way of a folder of its own: a format may write several files, and says so only then.
void print_export(const Context& context, app::Project& project, const app::ExportOptions& options) {
    if (options.format.empty()) {
        throw Error(ErrorCode::Usage, "-o - is standard output; say --format lst, dot, … with it");
    }
    if (context.json) {
        throw Error(ErrorCode::Usage, "standard output holds the file or what --json says, not both");
    }
    std::string folder = (std::filesystem::temp_directory_path() / "planum-XXXXXX").string();
    if (::mkdtemp(folder.data()) == nullptr) {
        throw Error(ErrorCode::Io,
                    "no temporary folder can be made in " + std::filesystem::temp_directory_path().string());
    }
    const std::shared_ptr<void> gone(nullptr, [&](void*) {
        std::error_code none;
        std::filesystem::remove_all(folder, none);
    });
    const app::Exported done = app::export_record(project, std::filesystem::path(folder) / "record", options);
    if (done.files.size() != 1) {
        throw Error(ErrorCode::Usage, fmt::format("{} is {} files, which standard output cannot hold; name a file",
                                                  options.format, done.files.size()));
    }
    for (const std::string& sentence : done.lost) context.say("not carried: " + sentence);
    *context.out << read_file(done.files.front(), std::filesystem::file_size(done.files.front()));
}

} // namespace

void write_export(const Context& context, app::Project& project, const std::filesystem::path& file,
                  const app::ExportOptions& options) {
    if (file == "-") return print_export(context, project, options);
    const app::Exported done = app::export_record(project, file, options);
    for (const std::string& sentence : done.lost) context.say("not carried: " + sentence);
    for (const auto& written : done.files) context.say("wrote " + written.string());
    if (!context.json) return;
    ordered_json files = ordered_json::array();
    for (const auto& written : done.files) files.push_back(written.string());
    context.print({{"files", std::move(files)}, {"not_carried", done.lost}});
}

void add_report_commands(CLI::App& root, Context& context) {
    auto report = std::make_shared<Options>();
    CLI::App* command = add_command(root, context, "report", "the record, its problems and decisions, for the archive");
    command->add_option("-o,--output", report->output, "file to write: .xml (schema planum-report-1), .html or .pdf")
        ->required();
    command->add_option("--interpretation", report->interpretation, "this reading instead of the field record");
    command->add_option(
        "--day", report->day,
        "only what was dug, recorded, found or scanned on this day [2025-06-01], with what that touches");
    command->callback([&context, report] { run_report(context, *report); });

    auto data = std::make_shared<Options>();
    CLI::App* export_command = add_command(root, context, "export", "the record for other programs");
    export_command
        ->add_option("-o,--output", data->output,
                     "file to write: .csv .json .lst .hmcx .graphml .dot .geojson .ttl .xlsx .dxf .oxcal")
        ->required();
    export_command->add_option("--format", data->format,
                               "format, where the ending does not say (hmc-csv, hm, geojson-site, …)");
    export_command->add_option("--interpretation", data->interpretation, "this reading instead of the field record");
    export_command->callback([&context, data] { run_export(context, *data); });
}

} // namespace planum::cli
