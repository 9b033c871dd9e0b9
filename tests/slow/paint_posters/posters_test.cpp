// SPDX-License-Identifier: MIT
// A poster, as a viewer shows it, cut at its sheets' edges and put together again, is the drawing.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "core/base/file.hpp"
#include "paint/drawing_pdf.hpp"
#include "paint/font_measure.hpp"
#include "strat/layout/planum_engine.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/layout_records.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;
using namespace planum::paint;
using namespace planum::strat;

namespace {

constexpr double kDotsPerPoint = 2.0; // 144 dpi: a stroke of 0.8 pt is a pixel or two

struct Grey {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<unsigned char> pixels;

    // The darkest pixel around a place, white outside.
    [[nodiscard]] int darkest(std::int64_t x, std::int64_t y, std::int64_t reach) const {
        int found = 255;
        for (std::int64_t j = y - reach; j <= y + reach; ++j) {
            for (std::int64_t i = x - reach; i <= x + reach; ++i) {
                if (i < 0 || j < 0 || i >= static_cast<std::int64_t>(width) || j >= static_cast<std::int64_t>(height))
                    continue;
                found = std::min<int>(found, pixels[static_cast<std::size_t>(j) * width + static_cast<std::size_t>(i)]);
            }
        }
        return found;
    }
};

// A binary PGM as pdftoppm writes it.
Grey read_pgm(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string magic;
    std::size_t most = 0;
    Grey g;
    in >> magic >> g.width >> g.height >> most;
    in.get();
    g.pixels.resize(g.width * g.height);
    in.read(reinterpret_cast<char*>(g.pixels.data()), static_cast<std::streamsize>(g.pixels.size()));
    REQUIRE(magic == "P5");
    REQUIRE(in.good());
    return g;
}

std::vector<Grey> pages_of(const std::string& pdf, const std::filesystem::path& folder, const std::string& name) {
    write_file_atomically(folder / (name + ".pdf"), pdf);
    const std::string command = fmt::format("pdfinfo '{0}.pdf' > /dev/null && pdftoppm -gray -r {1} '{0}.pdf' '{0}'",
                                            (folder / name).string(), kDotsPerPoint * 72.0);
    REQUIRE(std::system(command.c_str()) == 0);
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string file = entry.path().filename().string();
        if (file.starts_with(name + "-") && file.ends_with(".pgm")) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::vector<Grey> pages;
    for (const auto& file : files) pages.push_back(read_pgm(file));
    return pages;
}

// The sheets' contents, each where it belongs in the drawing.
Grey put_together(const std::vector<Grey>& pages, const PosterPlan& plan, const MatrixDrawing& drawing) {
    Grey whole;
    whole.width = static_cast<std::size_t>(std::ceil(drawing.width * kDotsPerPoint));
    whole.height = static_cast<std::size_t>(std::ceil(drawing.height * kDotsPerPoint));
    whole.pixels.assign(whole.width * whole.height, 255);
    for (std::size_t s = 0; s < plan.sheets.size(); ++s) {
        const DrawRect& part = plan.sheets[s].part;
        for (std::size_t y = 0; y < whole.height; ++y) {
            for (std::size_t x = 0; x < whole.width; ++x) {
                const double dx = (static_cast<double>(x) + 0.5) / kDotsPerPoint;
                const double dy = (static_cast<double>(y) + 0.5) / kDotsPerPoint;
                if (dx < part.x || dx >= part.right() || dy < part.y || dy >= part.bottom()) continue;
                const auto px = static_cast<std::size_t>((plan.content.x + dx - part.x) * kDotsPerPoint);
                const auto py = static_cast<std::size_t>((plan.content.y + dy - part.y) * kDotsPerPoint);
                if (px >= pages[s].width || py >= pages[s].height) continue;
                whole.pixels[y * whole.width + x] = pages[s].pixels[py * pages[s].width + px];
            }
        }
    }
    return whole;
}

// Share of dark pixels of one picture with nothing dark in the other within two pixels.
double missing(const Grey& from, const Grey& in) {
    constexpr int kDark = 110;
    constexpr int kGrey = 190;
    std::size_t dark = 0;
    std::size_t lost = 0;
    for (std::size_t y = 0; y < from.height; ++y) {
        for (std::size_t x = 0; x < from.width; ++x) {
            if (from.pixels[y * from.width + x] > kDark) continue;
            ++dark;
            if (in.darkest(static_cast<std::int64_t>(x), static_cast<std::int64_t>(y), 2) > kGrey) ++lost;
        }
    }
    REQUIRE(dark > 1000);
    return static_cast<double>(lost) / static_cast<double>(dark);
}

} // namespace

TEST_CASE("The tiles of a poster, put together, are the drawing on one page") {
    if (std::system("pdftoppm -v 2> /dev/null") != 0) {
        WARN("skipped: pdftoppm is not here");
        return;
    }
    const model::Record record = test::a_trench({.units = 150, .seed = 8, .width = 40, .layer_reach = 8});
    const HarrisMatrix matrix = HarrisMatrix::build(record);
    const FontTextMeasure text;
    const MatrixDrawing drawing = PlanumEngine().draw({record, matrix, text, {}, {}}, Progress::none());
    const test::TemporaryFolder folder;
    PdfOptions single;
    single.poster.paper = Paper::Fitted;
    const std::vector<Grey> one = pages_of(render_pdf(drawing, single, Progress::none()), folder.path(), "one");
    REQUIRE(one.size() == 1);
    const PosterPlan one_plan = plan_poster(drawing, single.poster);
    const Grey page = put_together(one, one_plan, drawing);
    PdfOptions tiled;
    tiled.poster.paper = Paper::A4;
    tiled.poster.paging = Paging::Poster;
    const PosterPlan plan = plan_poster(drawing, tiled.poster);
    REQUIRE(plan.sheets.size() >= 4);
    REQUIRE(plan.scale == 1.0);
    const std::vector<Grey> tiles = pages_of(render_pdf(drawing, tiled, Progress::none()), folder.path(), "tiled");
    REQUIRE(tiles.size() > plan.sheets.size()); // and the map and the index
    const Grey whole = put_together(tiles, plan, drawing);
    CHECK(missing(page, whole) < 0.002);
    CHECK(missing(whole, page) < 0.002);
    // Every stroke and every box of the geometry that the SVG is written from is there.
    const auto is_inked = [&](double x, double y) {
        return whole.darkest(static_cast<std::int64_t>(x * kDotsPerPoint), static_cast<std::int64_t>(y * kDotsPerPoint),
                             2) < 190;
    };
    for (const DrawnLine& line : drawing.lines) {
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            const DrawPoint middle{(line.points[i - 1].x + line.points[i].x) / 2.0,
                                   (line.points[i - 1].y + line.points[i].y) / 2.0};
            INFO(line.id);
            CHECK(is_inked(middle.x, middle.y));
        }
    }
    for (const DrawnBox& box : drawing.boxes) {
        INFO(box.id);
        CHECK(is_inked(box.rect.centre().x, box.rect.y));
        CHECK(is_inked(box.rect.x, box.rect.centre().y));
    }
}
