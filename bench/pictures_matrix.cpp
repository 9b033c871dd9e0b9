// SPDX-License-Identifier: MIT
// The pictures of generated matrices in docs/matrix-drawing.md, made anew: ./dev pictures
// Usage: pictures_matrix FOLDER
#include <cstdio>
#include <exception>
#include <filesystem>

#include "app/drawing/compare_readings.hpp"
#include "core/base/file.hpp"
#include "paint/drawing_png.hpp"
#include "paint/font_measure.hpp"
#include "strat/layout/planum_engine.hpp"
#include "tests/support/layout_records.hpp"

using namespace planum;

namespace {

void write(const std::filesystem::path& file, const model::Record& record, const strat::DrawingOptions& options,
           double dpi) {
    const strat::HarrisMatrix matrix = strat::HarrisMatrix::build(record);
    const paint::FontTextMeasure measure;
    const strat::MatrixDrawing drawing =
        strat::PlanumEngine().draw({record, matrix, measure, options, {}}, Progress::none());
    write_file_atomically(file, paint::render_png(drawing, {.dpi = dpi}));
    std::printf("wrote %s\n", file.c_str());
}

// A pit and its surroundings; a day later a fill was split, a layer found to run below the pit, a relation withdrawn.
model::Record pit(bool later) {
    using model::RelationKind;
    using model::UnitKind;
    test::MatrixBuilder builder = test::a_matrix();
    builder.raw().settings.name = "A pit and a day";
    for (const char* layer : {"101", "102", "103", "105", "106", "107", "108"}) builder.kind(layer, UnitKind::Deposit);
    builder.kind("104", UnitKind::Cut).kind("109", UnitKind::Natural).kind("110", UnitKind::Structure);
    builder.above("101", "102").above("101", "106");
    builder.relate("102", RelationKind::Fills, "104");
    builder.relate("103", RelationKind::Fills, "104");
    builder.relate("104", RelationKind::Cuts, "105");
    builder.above("105", "107").above("107", "109").above("106", "110").above("110", "108").above("108", "109");
    if (later) {
        builder.kind("111", UnitKind::Deposit).above("102", "111").above("111", "103");
        builder.above("107", "108");
    } else {
        builder.above("102", "103").above("106", "107");
    }
    return builder.record();
}

void make_pictures(const std::filesystem::path& folder) {
    write(folder / "matrix-trench.png", test::a_trench({.units = 120, .seed = 7}), {}, 72.0);
    app::Comparison comparison = app::compare_readings(pit(false), pit(true));
    strat::DrawingOptions options;
    options.subtitle = "what a day changed";
    options.marks = comparison.units;
    options.order_marks = comparison.orders;
    write(folder / "matrix-compare.png", comparison.both, options, 96.0);
}

} // namespace

int main(int argc, char** argv) {
    try {
        make_pictures(argc > 1 ? argv[1] : ".");
        return 0;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "pictures_matrix: %s\n", e.what());
        return 1;
    }
}
