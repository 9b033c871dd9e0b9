// SPDX-License-Identifier: MIT
#include "gui/viewmodels/section_line.hpp"

#include <optional>

#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"

using namespace planum;
using namespace planum::gui;

namespace {

struct Desk {
    Workspace workspace;
    SectionLine line{workspace};
    std::optional<model::Section> shown;
    double thickness = 0.0;

    Desk() {
        QObject::connect(&line, &SectionLine::handedOver, [this](const model::Section& section, double thick) {
            shown = section;
            thickness = thick;
        });
    }
};

const int kApplication = (test::ensure_core_application(), 0);

} // namespace

TEST_CASE("Two places make a section line, which the section view can show") {
    static_cast<void>(kApplication);
    Desk desk;
    desk.line.take({1.0, 2.0, 3.0});
    CHECK(desk.line.state() == SectionLine::State::Off); // nobody asked for a line
    desk.line.begin();
    CHECK(desk.line.wants_place());
    desk.line.take({1.0, 2.0, 3.0});
    CHECK(desk.line.state() == SectionLine::State::WantsSecond);
    desk.line.hand_over();
    CHECK_FALSE(desk.shown); // half a line
    desk.line.take({4.0, 6.0, 9.0});
    CHECK(desk.line.state() == SectionLine::State::Set);
    CHECK(desk.line.length() == Approx(5.0)); // in plan
    CHECK(desk.line.said().contains(QStringLiteral("5.00 m")));
    desk.line.take({0.0, 0.0, 0.0});
    CHECK(desk.line.length() == Approx(5.0));
    desk.line.set_thickness(0.3);
    desk.line.hand_over();
    REQUIRE(desk.shown);
    CHECK(desk.shown->from_in_site == std::array<double, 2>{1.0, 2.0});
    CHECK(desk.shown->to_in_site == std::array<double, 2>{4.0, 6.0});
    CHECK(desk.thickness == Approx(0.3));
}

TEST_CASE("A second place straight above the first is no line, and is asked for again") {
    Desk desk;
    desk.line.begin();
    const QString asked = [&] {
        desk.line.take({1.0, 2.0, 3.0});
        return desk.line.said();
    }();
    desk.line.take({1.0, 2.01, 8.0});
    CHECK(desk.line.state() == SectionLine::State::WantsSecond);
    CHECK(desk.line.said() != asked);
    desk.line.take({1.0, 3.0, 8.0});
    CHECK(desk.line.state() == SectionLine::State::Set);
}

TEST_CASE("A section line can be cleared at any step, and its thickness stays within bounds") {
    Desk desk;
    for (int places = 0; places <= 2; ++places) {
        desk.line.begin();
        for (int i = 0; i < places; ++i) desk.line.take({1.0 * i, 0.0, 0.0});
        desk.line.clear();
        CHECK(desk.line.state() == SectionLine::State::Off);
        CHECK_FALSE(desk.line.from());
        CHECK_FALSE(desk.line.to());
        CHECK(desk.line.length() == 0.0);
    }
    desk.line.set_thickness(0.0);
    CHECK(desk.line.thickness() == Approx(SectionLine::kThinnest));
    desk.line.set_thickness(1e6);
    CHECK(desk.line.thickness() == Approx(SectionLine::kThickest));
}
