// SPDX-License-Identifier: MIT
#include "paint/map_sheet_painter.hpp"

#include <cmath>
#include <cstdint>

#include "core/base/error.hpp"
#include "paint/map_page.hpp"
#include "paint/qt_runtime.hpp"
#include "paint/sheet_group_painter.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using namespace planum::paint;

namespace {

geometry::MapSheet trench() {
    geometry::MapSheet sheet;
    sheet.extent = {{100.0, 200.0}, {104.0, 202.0}};
    sheet.title = "Plan";
    sheet.shapes.push_back({{{{{100.5, 200.5, 0}, {103.0, 200.5, 0}, {103.0, 201.5, 0}}}}, {}});
    sheet.labels.push_back({102.5, 201.0, "1008", "49.51"});
    sheet.marks.push_back({101.0, 201.0, geometry::SheetSign::Level, "49.49"});
    sheet.keys.push_back({"layer", {}, geometry::SheetSign::None});
    return sheet;
}

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8U | static_cast<std::uint8_t>(bytes[at + i]);
    return value;
}

} // namespace

TEST_CASE("A metre of a plan is as long on paper as its scale says") {
    ensure_qt_runtime();
    const MapPage page = lay_out_map(trench(), 20.0);
    CHECK(page.points_per_metre == Approx(50.0 / 25.4 * 72.0)); // 1 : 20 makes a metre 5 cm
    CHECK(page.frame.width() == Approx(4.0 * page.points_per_metre));
    CHECK(page.on_paper(trench(), 100.0, 202.0) == page.frame.topLeft());
    CHECK(page.frame.right() < page.width);
    CHECK(page.foot > page.frame.bottom());
    CHECK(page.keys.at(0).base_line < page.height);
}

TEST_CASE("A plan comes out the same twice, in its size") {
    const std::string png = render_map_png(trench(), {20.0, 100.0});
    CHECK(png == render_map_png(trench(), {20.0, 100.0}));
    CHECK(png.substr(1, 3) == "PNG");
    const MapPage page = lay_out_map(trench(), 20.0);
    CHECK(big_endian(png, 16) == static_cast<std::uint32_t>(std::ceil(page.width * 100.0 / 72.0)));
    const std::string pdf = render_map_pdf(trench(), {20.0, 100.0}, Progress::none());
    CHECK(pdf.substr(0, 5) == "%PDF-");
    CHECK(pdf == render_map_pdf(trench(), {20.0, 100.0}, Progress::none()));
    CHECK(pdf.find("/MediaBox [0 0 842") != std::string::npos); // A4 across holds it
}

TEST_CASE("A plan that has no extent, no scale or no end is refused with what would do") {
    CHECK_THROWS_AS(render_map_png({}, {}), Error);
    CHECK_THROWS_AS(render_map_png(trench(), {0.0, 100.0}), Error);
    try {
        (void)render_map_png(trench(), {0.05, 100.0});
        FAIL("a picture of 80 m was made");
    } catch (const Error& e) {
        const std::string message = e.what();
        const std::size_t at = message.rfind("1:");
        REQUIRE(at != std::string::npos);
        CHECK_NOTHROW((void)render_map_png(trench(), {std::stod(message.substr(at + 2)), 100.0}));
    }
}

TEST_CASE("Lengths of scale bars are round") {
    CHECK(round_length(3.7) == 2.0);
    CHECK(round_length(0.99) == 0.5);
    CHECK(round_length(10.0) == 10.0);
}

TEST_CASE("A section has at least three heights beside it, however low it is") {
    ensure_qt_runtime();
    for (const double high : {0.25, 0.4, 0.9, 1.3, 4.0}) {
        for (const double scale : {5.0, 10.0, 20.0}) {
            geometry::MapSheet section = trench();
            section.is_section = true;
            section.extent = {{0.0, 49.33}, {4.0, 49.33 + high}};
            const MapPage page = lay_out_map(section, scale);
            if (page.frame.height() < 40.0) continue; // no room for three numbers
            const double step = tick_step(section, page, 1);
            INFO(high << " m at 1:" << scale << ": a tick every " << step << " m");
            CHECK(std::floor(section.extent.high[1] / step) - std::ceil(section.extent.low[1] / step) >= 2.0);
            CHECK(step * page.points_per_metre >= 10.0);
        }
    }
}

TEST_CASE("A section that would be a strip on its paper has a page of its own size") {
    geometry::MapSheet section = trench();
    section.is_section = true;
    section.extent = {{0.0, 49.0}, {4.0, 49.9}};
    const std::string pdf = render_map_pdf(section, {20.0, 100.0}, Progress::none());
    CHECK(pdf.find("/MediaBox [0 0 842") == std::string::npos);
    CHECK(pdf.find("/MediaBox [0 0 595") == std::string::npos);
    section.extent.high[1] = 51.0; // this one fills A4
    const std::string full = render_map_pdf(section, {20.0, 100.0}, Progress::none());
    CHECK(full.find("/MediaBox [0 0 842") != std::string::npos);
}

TEST_CASE("A section is drawn at the largest scale at which it fits A4") {
    geometry::MapSheet section = trench();
    section.is_section = true;
    section.extent = {{0.0, 49.0}, {4.0, 49.9}};
    CHECK(section_scale(section) == 20.0);
    section.extent.high[0] = 2.0;
    CHECK(section_scale(section) == 10.0);
    section.extent = {{0.0, 49.0}, {0.8, 49.3}};
    CHECK(section_scale(section) == 5.0);
    section.extent = {{0.0, 49.0}, {40.0, 51.0}};
    CHECK(section_scale(section) == 20.0);
}

TEST_CASE("The ticks of a plan stand equally far apart both ways, two at least") {
    ensure_qt_runtime();
    geometry::MapSheet plan = trench();
    plan.extent = {{100.6, 201.6}, {104.1, 202.7}};
    const MapPage page = lay_out_map(plan, 20.0);
    CHECK(tick_step(plan, page, 0) == 0.5);
    CHECK(tick_step(plan, page, 1) == 0.5);
}

TEST_CASE("A dashed line in the key has room for two dashes") {
    ensure_qt_runtime();
    geometry::MapSheet sheet = trench();
    sheet.keys[0].look.width = 0.8;
    const double solid = lay_out_map(sheet, 20.0).keys[0].swatch.width();
    sheet.keys[0].look.dash = geometry::SheetDash::Dashed;
    const QRectF dashed = lay_out_map(sheet, 20.0).keys[0].swatch;
    CHECK(dashed.width() > solid);
    CHECK(dashed.width() >= (5.0 + 3.0 + 5.0) * 0.8 * kPointsPerMillimetre - 1e-9);
}

TEST_CASE("Sheets of a group lie below one another under their heading, each at its own scale") {
    geometry::SheetGroup group;
    group.title = "1 or 2: which lay above?";
    group.text = std::string(300, 'w'); // no room in one line, and no blank to break it at
    group.sheets = {{trench(), 20.0}, {trench(), 50.0}};
    const std::string png = render_sheet_group_png(group, 100.0);
    CHECK(png == render_sheet_group_png(group, 100.0));
    ensure_qt_runtime();
    const MapPage wide = lay_out_map(trench(), 20.0);
    const MapPage narrow = lay_out_map(trench(), 50.0, wide.width);
    CHECK(big_endian(png, 16) == static_cast<std::uint32_t>(std::ceil(wide.width * 100.0 / 72.0)));
    CHECK(big_endian(png, 20) >
          static_cast<std::uint32_t>((wide.frame.height() + narrow.frame.height()) * 100.0 / 72.0));
    const std::string pdf = render_sheet_group_pdf(group, Progress::none());
    CHECK(pdf.substr(0, 5) == "%PDF-");
    CHECK(pdf == render_sheet_group_pdf(group, Progress::none()));
}

TEST_CASE("A group that holds nothing, or would be endless, is refused") {
    CHECK_THROWS_AS(render_sheet_group_png({}, 100.0), Error);
    CHECK_THROWS_AS(render_sheet_group_png({"", "", "", {{{}, 20.0}}}, 100.0), Error);
    CHECK_THROWS_AS(render_sheet_group_png({"", "", "", {{trench(), 0.01}}}, 1200.0), Error);
}
