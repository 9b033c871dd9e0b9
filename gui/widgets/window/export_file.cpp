// SPDX-License-Identifier: MIT
#include "gui/widgets/window/export_file.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "app/drawing/draw_matrix.hpp"
#include "app/export/export_record.hpp"
#include "app/reports/report.hpp"
#include "app/surfaces/plan_sheet.hpp"
#include "app/surfaces/section_sheet.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "gui/viewmodels/service_sentences.hpp"
#include "gui/viewmodels/words.hpp"
#include "gui/widgets/language.hpp"
#include "paint/drawing_pdf.hpp"
#include "paint/drawing_png.hpp"
#include "paint/font_measure.hpp"
#include "paint/map_sheet_painter.hpp"
#include "paint/report_pdf.hpp"
#include "strat/layout/svg_writer.hpp"

namespace planum::gui {

namespace {

QString wrote(const std::filesystem::path& file) {
    return QCoreApplication::translate("export", "wrote %1").arg(qt(file.string()));
}

void write_sheet(const geometry::MapSheet& sheet, const std::filesystem::path& file, double scale, Progress& progress) {
    paint::MapSheetOptions how;
    how.scale = scale;
    const std::string ending = text::fold_case(file.extension().string());
    if (ending != ".pdf" && ending != ".png")
        throw Error(ErrorCode::Usage, fmt::format("{}: plans and sections are written as .pdf or .png", file.string()));
    write_file_atomically(file, ending == ".png" ? paint::render_map_png(sheet, how)
                                                 : paint::render_map_pdf(sheet, how, progress));
}

} // namespace

QString export_file(app::Project& project, const std::filesystem::path& file, Progress& progress,
                    const strat::MatrixDrawing* shown) {
    const std::string ending = text::fold_case(file.extension().string());
    const paint::FontTextMeasure measure;
    if (ending == ".xml" || ending == ".html") {
        app::write_report(project, file, app::ReportRequest{}, measure, progress);
        return wrote(file);
    }
    if (ending == ".svg" || ending == ".pdf" || ending == ".png") {
        app::DrawRequest whole;
        whole.language = window_language().toStdString();
        const strat::MatrixDrawing drawing =
            shown != nullptr ? *shown : app::draw_matrix(project, whole, measure, progress);
        paint::PdfOptions pdf;
        pdf.words = strat::words_in(whole.language);
        pdf.site = project.record().settings.name;
        pdf.date = project.clock().now().substr(0, 10);
        write_file_atomically(file, ending == ".svg"   ? strat::write_svg(drawing)
                                    : ending == ".png" ? paint::render_png(drawing)
                                                       : paint::render_pdf(drawing, pdf, progress));
        return wrote(file);
    }
    const app::Exported exported = app::export_record(project, file, {});
    QStringList sentences;
    for (const auto& written : exported.files) sentences << wrote(written);
    for (const std::string& lost : exported.lost) {
        sentences << QCoreApplication::translate("export", "not carried: %1").arg(service_sentence(lost));
    }
    return sentences.join(QStringLiteral("; "));
}

QString write_report_file(app::Project& project, const std::filesystem::path& file, const std::string& day,
                          Progress& progress) {
    const paint::FontTextMeasure measure;
    const app::ReportRequest request{{}, day};
    if (text::fold_case(file.extension().string()) != ".pdf") {
        app::write_report(project, file, request, measure, progress);
        return wrote(file);
    }
    const app::PrintedReport printed = app::printed_report(project, request, progress);
    std::optional<strat::MatrixDrawing> drawing;
    if (printed.has_drawing) drawing = app::draw_matrix(project, printed.drawing, measure, progress);
    paint::ReportPdf report;
    report.html = printed.html;
    report.drawing = drawing ? &*drawing : nullptr;
    report.site = project.record().settings.name;
    report.date = project.clock().now().substr(0, 10);
    write_file_atomically(file, paint::render_report_pdf(report, progress));
    return wrote(file);
}

QString write_plan_file(app::Project& project, const std::filesystem::path& file, const std::string& surface,
                        double scale, Progress& progress) {
    app::PlanRequest request;
    request.surface = surface;
    const app::PlanSheet made = app::plan_sheet(project, request, progress);
    write_sheet(made.sheet, file, scale, progress);
    QStringList sentences{wrote(file)};
    for (const std::string& note : made.notes) sentences << service_sentence(note);
    return sentences.join(QStringLiteral("; "));
}

QString write_section_file(app::Project& project, const std::filesystem::path& file, const std::string& section,
                           double scale, Progress& progress) {
    const auto& sections = project.record().sections;
    const auto found =
        std::find_if(sections.begin(), sections.end(), [&](const model::Section& one) { return one.name == section; });
    if (found == sections.end()) throw Error(ErrorCode::NotFound, "no section " + section);
    app::SectionRequest request; // the wall as one picture, as it is drawn on
    request.from = found->from_in_site;
    request.to = found->to_in_site;
    write_sheet(app::section_sheet(project, request, progress).sheet, file, scale, progress);
    return wrote(file);
}

QString write_free_section_file(app::Project& project, const std::filesystem::path& file,
                                const std::array<double, 2>& from_in_site, const std::array<double, 2>& to_in_site,
                                double scale, Progress& progress) {
    app::SectionRequest request;
    request.from = from_in_site;
    request.to = to_in_site;
    request.surfaces_apart = true;
    write_sheet(app::section_sheet(project, request, progress).sheet, file, scale, progress);
    return wrote(file);
}

} // namespace planum::gui
