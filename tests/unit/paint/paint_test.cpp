// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <set>
#include <string>

#include "core/base/error.hpp"
#include "paint/drawing_pdf.hpp"
#include "paint/drawing_png.hpp"
#include "paint/font_measure.hpp"
#include "paint/legend_strip.hpp"
#include "paint/missing_signs.hpp"
#include "paint/poster_plan.hpp"
#include "paint/report_pdf.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;
using namespace planum::paint;
using namespace planum::strat;

namespace {

// A drawing of boxes in rows, by hand, `columns` × `rows` of them.
MatrixDrawing boxes_in_rows(std::size_t columns, std::size_t rows) {
    MatrixDrawing d;
    d.title = "Boxes";
    for (std::size_t r = 0; r < rows; ++r) {
        for (std::size_t c = 0; c < columns; ++c) {
            DrawnBox box;
            const std::string name = std::to_string(r * columns + c + 1);
            box.id = "unit-" + name;
            box.names = {name};
            box.lines = {name};
            box.line_widths = {10.0};
            box.rect = {40.0 + 60.0 * static_cast<double>(c), 40.0 + 50.0 * static_cast<double>(r), 40.0, 20.0};
            d.boxes.push_back(box);
        }
    }
    d.width = 80.0 + 60.0 * static_cast<double>(columns);
    d.height = 80.0 + 50.0 * static_cast<double>(rows);
    return d;
}

std::size_t count(const std::string& text, std::string_view word) {
    std::size_t n = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
    return n;
}

} // namespace

TEST_CASE("The built-in widths are those of the font") {
    const FontTextMeasure font;
    const TableTextMeasure table;
    for (const char* words : {"1042", "Harris matrix: 12 = 15", "WWWiii"}) {
        CHECK(table.width(words, 9.0, FontWeight::Regular) ==
              Approx(font.width(words, 9.0, FontWeight::Regular)).epsilon(0.03));
        CHECK(table.width(words, 16.0, FontWeight::Bold) ==
              Approx(font.width(words, 16.0, FontWeight::Bold)).epsilon(0.03));
    }
}

TEST_CASE("PNG is a PNG, and one too large is refused with what would fit") {
    const MatrixDrawing drawing = boxes_in_rows(3, 2);
    CHECK(render_png(drawing).starts_with("\x89PNG"));
    PngOptions options;
    options.max_pixels = 1000;
    CHECK_THROWS_WITH(render_png(drawing, options), Catch::Contains("dpi"));
}

TEST_CASE("A drawing on one page is never enlarged") {
    const PosterPlan plan = plan_poster(boxes_in_rows(2, 2), {});
    CHECK(plan.scale == 1.0);
    REQUIRE(plan.sheets.size() == 1);
}

TEST_CASE("A poster covers the whole drawing, neighbours overlap, each box is whole on some sheet") {
    const MatrixDrawing drawing = boxes_in_rows(60, 50);
    PosterOptions options;
    options.paper = Paper::A4;
    options.paging = Paging::Poster;
    const PosterPlan plan = plan_poster(drawing, options);
    REQUIRE(plan.sheets.size() > 4);
    double right = 0.0;
    double bottom = 0.0;
    for (const Sheet& sheet : plan.sheets) {
        right = std::max(right, sheet.part.right());
        bottom = std::max(bottom, sheet.part.bottom());
    }
    CHECK(right >= drawing.width);
    CHECK(bottom >= drawing.height);
    for (const DrawnBox& box : drawing.boxes) {
        CHECK(std::any_of(plan.sheets.begin(), plan.sheets.end(), [&](const Sheet& s) {
            return box.rect.x >= s.part.x && box.rect.right() <= s.part.right() && box.rect.y >= s.part.y &&
                   box.rect.bottom() <= s.part.bottom();
        }));
    }
    const std::vector<SheetEntry> index = sheet_index(drawing, plan);
    REQUIRE(index.size() == drawing.boxes.size());
    CHECK(index.front().unit == "1");
    CHECK(index.front().sheet == "A1");
}

TEST_CASE("Rows of sheets are lettered beyond Z") {
    CHECK(row_letters(0) == "A");
    CHECK(row_letters(25) == "Z");
    CHECK(row_letters(26) == "AA");
    CHECK(row_letters(701) == "ZZ");
    CHECK(row_letters(702) == "AAA");
}

TEST_CASE("A poster of too many sheets is refused with what to do") {
    PosterOptions options;
    options.paper = Paper::A4;
    options.paging = Paging::Poster;
    options.scale = 100.0;
    CHECK_THROWS_WITH(plan_poster(boxes_in_rows(60, 50), options), Catch::Contains("larger paper"));
}

TEST_CASE("PDF embeds its font, has a page for each sheet, the map and the index, and repeats itself") {
    const MatrixDrawing drawing = boxes_in_rows(30, 20);
    PdfOptions options;
    options.poster.paper = Paper::A4;
    options.poster.paging = Paging::Poster;
    options.site = "Site";
    options.date = "2025-06-01";
    const std::string pdf = render_pdf(drawing, options, Progress::none());
    const std::size_t sheets = plan_poster(drawing, options.poster).sheets.size();
    CHECK(pdf.starts_with("%PDF-1."));
    CHECK(count(pdf, "/FontFile2") >= 1);
    CHECK(count(pdf, "/Type /Page\n") == sheets + 2 + 1); // index of 600 units on A4: two pages
    CHECK(pdf == render_pdf(drawing, options, Progress::none()));
}

TEST_CASE("A poster that fits on one sheet is that sheet, with the drawing's own key") {
    const MatrixDrawing drawing = boxes_in_rows(2, 2);
    PdfOptions options;
    options.poster.paper = Paper::A4;
    options.poster.paging = Paging::Poster;
    const PosterPlan plan = plan_poster(drawing, options.poster);
    CHECK(plan.title_block == kTitleBlock);
    CHECK(plan.sheets.front().part.width >= drawing.width);
    CHECK(count(render_pdf(drawing, options, Progress::none()), "/Type /Page\n") == 1);
}

TEST_CASE("A short index stands on the page of the map") {
    const MatrixDrawing drawing = boxes_in_rows(12, 5);
    PdfOptions options;
    options.poster.paper = Paper::A4;
    options.poster.paging = Paging::Poster;
    const std::size_t sheets = plan_poster(drawing, options.poster).sheets.size();
    CHECK(count(render_pdf(drawing, options, Progress::none()), "/Type /Page\n") == sheets + 1);
}

TEST_CASE("One long name costs the other units no room in the index") {
    MatrixDrawing drawing = boxes_in_rows(12, 5);
    PdfOptions options;
    options.poster.paper = Paper::A4;
    options.poster.paging = Paging::Poster;
    const std::string before = render_pdf(drawing, options, Progress::none());
    drawing.boxes.back().names = {std::string(300, 'W')};
    const std::string after = render_pdf(drawing, options, Progress::none());
    CHECK(count(before, "/Type /Page\n") == count(after, "/Type /Page\n"));
}

TEST_CASE("Each sheet of a poster has room for the legend at its foot") {
    MatrixDrawing drawing = boxes_in_rows(12, 5);
    PosterOptions options;
    options.paper = Paper::A4;
    options.paging = Paging::Poster;
    const PosterPlan bare = plan_poster(drawing, options);
    CHECK(bare.title_block == kTitleBlock);
    for (int i = 0; i < 12; ++i) {
        DrawnText words;
        words.role = "legend";
        words.text = "by way of units not drawn";
        words.width = 120.0;
        drawing.texts.push_back(words);
        drawing.legend.emplace_back();
    }
    const PosterPlan plan = plan_poster(drawing, options);
    const LegendStrip strip = lay_legend(drawing, plan.content.width);
    REQUIRE(strip.entries.size() == 12);
    CHECK(plan.title_block == kTitleBlock + strip.height);
    CHECK(plan.content.height < bare.content.height);
    for (const LegendStrip::Entry& a : strip.entries) {
        CHECK(a.at.x + 19.5 + 4.0 + 120.0 * 0.75 <= plan.content.width);
        for (const LegendStrip::Entry& b : strip.entries) {
            if (&a != &b && a.at.y == b.at.y) CHECK(std::abs(a.at.x - b.at.x) > 19.5 + 120.0 * 0.75);
        }
    }
}

TEST_CASE("Letters that no font of ours has are measured as they are in fonts that have them") {
    const FontTextMeasure measure;
    CHECK(measure.width("土層", 9.0, FontWeight::Regular) == Approx(18.0));
    CHECK(measure.width("12 土", 9.0, FontWeight::Regular) ==
          Approx(9.0 + measure.width("12 ", 9.0, FontWeight::Regular)));
}

TEST_CASE("A printed report has pages of words, then the matrix, and repeats itself") {
    const MatrixDrawing drawing = boxes_in_rows(3, 4);
    ReportPdf report;
    report.html = "<h1>Hill Farm</h1>";
    for (int i = 0; i < 200; ++i) report.html += "<p>a line</p>";
    report.site = "Hill Farm";
    const std::string words = render_report_pdf(report, Progress::none());
    report.drawing = &drawing;
    const std::string pdf = render_report_pdf(report, Progress::none());
    CHECK(pdf.starts_with("%PDF-1."));
    CHECK(count(words, "/Type /Page\n") > 1);
    CHECK(count(pdf, "/Type /Page\n") == count(words, "/Type /Page\n") + 1);
    CHECK(pdf == render_report_pdf(report, Progress::none()));
}

TEST_CASE("A PDF is the same file in every time zone, and all of its objects are found") {
    const char* const before = std::getenv("TZ");
    const std::string kept = before == nullptr ? "" : before;
    const MatrixDrawing drawing = boxes_in_rows(4, 3);
    PdfOptions options;
    options.created_at = "2025-06-01T17:04:05";
    std::set<std::string> files;
    const test::TemporaryFolder folder;
    for (const char* zone : {"UTC0", "JST-9", "XXX+9:30"}) {
        setenv("TZ", zone, 1);
        tzset();
        const std::string pdf = render_pdf(drawing, options, Progress::none());
        CHECK_THAT(pdf, Catch::Contains("/CreationDate (D:20250601170405Z)"));
        files.insert(pdf);
        // A reader that had to look for the objects itself would say so.
        const auto file = folder.write("zone.pdf", pdf);
        CHECK(std::system(("test -z \"$(pdfinfo " + file.string() + " 2>&1 >/dev/null)\"").c_str()) == 0);
        std::size_t table = std::stoul(pdf.substr(pdf.rfind("startxref\n") + 10));
        CHECK(pdf.compare(table, 5, "xref\n") == 0);
        table = pdf.find('\n', table + 5) + 1;
        for (std::size_t object = 1; object < 5; ++object) {
            const std::size_t at = std::stoul(pdf.substr(table + 20 * object, 10));
            CHECK(pdf.compare(at, 7, std::to_string(object) + " 0 obj") == 0);
        }
    }
    CHECK(files.size() == 1);
    if (before == nullptr) {
        unsetenv("TZ");
    } else {
        setenv("TZ", kept.c_str(), 1);
    }
    tzset();
}

TEST_CASE("Signs that no font of the machine has are named, others are not") {
    CHECK(missing_signs("US 1042 = Größe, çà, Ω, \t\n1\u200d2\ufe0f").empty());
    // Private use: nobody's fonts have it.
    CHECK(missing_signs("a\U00100123b\U00100123") == std::vector<std::string>{"\U00100123"});
    MatrixDrawing drawing = boxes_in_rows(2, 1);
    CHECK(missing_signs(drawing).empty());
    drawing.boxes[1].lines.push_back("\U00100123");
    CHECK(missing_signs(drawing).size() == 1);
    CHECK(missing_signs_remark("m.png", {}).empty());
    CHECK(missing_signs_remark("m.png", missing_signs(drawing)) ==
          "m.png: no font on this machine has \U00100123; empty squares stand in its place");
}
