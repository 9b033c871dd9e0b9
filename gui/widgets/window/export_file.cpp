// SPDX-License-Identifier: MIT
#include "gui/widgets/window/export_file.hpp"

#include <QCoreApplication>

#include "app/drawing/draw_matrix.hpp"
#include "app/export/export_record.hpp"
#include "app/reports/report.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "gui/viewmodels/words.hpp"
#include "paint/drawing_pdf.hpp"
#include "paint/drawing_png.hpp"
#include "paint/font_measure.hpp"
#include "strat/layout/svg_writer.hpp"

namespace planum::gui {

namespace {

QString wrote(const std::filesystem::path& file) {
    return QCoreApplication::translate("export", "wrote %1").arg(qt(file.string()));
}

} // namespace

QString export_file(app::Project& project, const std::filesystem::path& file, Progress& progress) {
    const std::string ending = text::fold_case(file.extension().string());
    const paint::FontTextMeasure measure;
    if (ending == ".xml" || ending == ".html") {
        app::write_report(project, file, app::ReportRequest{}, measure, progress);
        return wrote(file);
    }
    if (ending == ".svg" || ending == ".pdf" || ending == ".png") {
        const strat::MatrixDrawing drawing = app::draw_matrix(project, {}, measure, progress);
        paint::PdfOptions pdf;
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
        sentences << QCoreApplication::translate("export", "not carried: %1").arg(qt(lost));
    }
    return sentences.join(QStringLiteral("; "));
}

} // namespace planum::gui
