// SPDX-License-Identifier: MIT
#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLabel>
#include <QListView>
#include <QListWidget>
#include <QRegularExpression>
#include <QSignalSpy>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "app/demo/simulator.hpp"
#include "gui/render/flight_file.hpp"
#include "gui/widgets/flat/flat_canvas.hpp"
#include "gui/widgets/matrix/matrix_view.hpp"
#include "gui/widgets/space/flight_cameras.hpp"
#include "gui/widgets/space/space_canvas.hpp"
#include "tests/e2e/window_day/hands.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;
using namespace planum::gui;
namespace fs = std::filesystem;

namespace {

QString text(const fs::path& file) { return QString::fromStdString(file.string()); }

// `"a.csv" "b.csv"`, as the file dialog wants several names.
QString several(const fs::path& folder, const std::vector<const char*>& names) {
    QStringList quoted;
    for (const char* name : names) quoted << QStringLiteral("\"%1\"").arg(text(folder / name));
    return quoted.join(QLatin1Char(' '));
}

struct Place {
    double x = 0.0;
    double y = 0.0;
};

// Looks over the picture with the pointer for the pixel whose coordinates, as the window says them, come nearest.
std::optional<QPointF> pixel_of(FlatCanvas& canvas, const QLabel& label, Place wanted) {
    static const QRegularExpression numbers(QStringLiteral("x (-?[0-9.]+)  y (-?[0-9.]+)  height"));
    std::optional<QPointF> best;
    double least = 0.25; // [m]
    for (int y = 2; y < canvas.height(); y += 3) {
        for (int x = 2; x < canvas.width(); x += 5) {
            test::Hands::hover(&canvas, QPointF(x, y));
            const auto match = numbers.match(label.text());
            if (!match.hasMatch()) continue;
            const double apart =
                std::hypot(match.captured(1).toDouble() - wanted.x, match.captured(2).toDouble() - wanted.y);
            if (apart >= least) continue;
            least = apart;
            best = QPointF(x, y);
        }
    }
    return best;
}

Place centre_of(const app::demo::DemoDig& dig) {
    const auto& trench = dig.site.trench;
    return {0.5 * (trench.low.x + trench.high.x), 0.5 * (trench.low.y + trench.high.y)};
}

std::vector<Place> corners_in(const app::demo::DemoDig& dig, double size) {
    const auto [x, y] = centre_of(dig);
    return {{x - size, y - size}, {x + size, y - size}, {x + size, y + size}, {x - size, y + size}};
}

// Two clicks cut a slice of the scans, which the section view shows as well; Esc brings the rest back.
void lay_section_line(test::Hands& hands, SpaceCanvas& space) {
    SectionLine& line = hands.window.models().section_line;
    // A click between two points meets none: then a little beside it.
    const auto click = [&](double across, double down) {
        const SectionLine::State before = line.state();
        for (int step = 0; step < 40 && line.state() == before; ++step) {
            hands.click_at(&space,
                           QPointF(across * space.width() + 3 * (step % 8), down * space.height() + 3 * (step / 8)));
            hands.settle_all();
        }
    };
    QTest::keyClick(&space, Qt::Key_F);
    hands.settle_all();
    hands.click("spaceSection");
    click(0.4, 0.55);
    CHECK(line.state() == SectionLine::State::WantsSecond);
    click(0.6, 0.5);
    REQUIRE(line.state() == SectionLine::State::Set);
    hands.find<QDoubleSpinBox>("sectionLineThickness")->setValue(0.3);
    hands.click("faceSectionLine");
    hands.picture("14_section_line");
    hands.click("showSectionLine");
    CHECK(hands.find<QComboBox>("sectionChoice")->currentText().contains(QStringLiteral("3D")));
    hands.picture("14_shown_as_section");
    hands.window.show_view("3d");
    hands.settle_all();
    QTest::keyClick(&space, Qt::Key_Escape);
    CHECK(line.state() == SectionLine::State::Off);
    hands.settle_all();
}

} // namespace

TEST_CASE("A day in the window: project, scans, grid, outlines by hand, a problem mended, the matrix on paper") {
    const test::TemporaryFolder folder;
    const fs::path files = folder / "dig";
    Progress& progress = Progress::none();
    const app::demo::DemoDig dig = app::demo::simulate({}, progress);
    app::demo::write_demo(dig, files, progress);

    test::Hands hands("day");
    hands.picture("01_nothing_open");

    // A project of the director's own, and the sheets so far.
    hands.answer_next({text(folder / "hill.gpkg")});
    hands.find<QAction>("newProject")->trigger();
    hands.settle_all();
    REQUIRE(hands.window.models().workspace.is_open());
    hands.answer_next(
        {several(files / "with-mistakes", {"areas.csv", "units.csv", "relations.csv", "levels.csv", "finds.csv"})});
    hands.find<QAction>("importLists")->trigger();
    hands.settle_all();
    hands.picture("02_import_preview", hands.find<QWidget>("importDialog"));
    hands.click("importNow");
    CHECK(hands.record().units.size() >= 12);
    hands.picture("03_imported");

    // Scans are dropped on the window; markers put them on the site grid.
    hands.drop({files / "2025-06-01", files / "2025-06-02"});
    CHECK(hands.record().scans.size() == 4);
    hands.window.show_view("scans");
    hands.answer_next({text(files / "markers.csv")});
    hands.click("importMarkers");
    hands.click("registerScans");
    CHECK(hands.record().poses.size() == 4);
    hands.picture("04_registered");

    // A registration compared with itself moves nothing.
    const QString run = hands.window.models().inquiry.runs().back();
    hands.window.models().inquiry.compare_runs(run, run);
    hands.settle_all();
    auto* answer = hands.find<QDialog>("answer");
    auto* lines = answer->findChild<QListWidget*>(QStringLiteral("answerLines"));
    REQUIRE(lines != nullptr);
    REQUIRE(lines->count() > 0);
    CHECK(lines->item(0)->text().contains(QStringLiteral("moves 0.0 mm")));
    hands.picture("04_compared", answer);
    answer->close();

    // An outline on the panorama, corner by corner.
    hands.window.show_view("panorama");
    hands.settle_all();
    auto* panorama = hands.find<FlatCanvas>("panoramaCanvas");
    auto* place = hands.find<QLabel>("panoramaPlace");
    hands.picture("05_panorama");
    hands.click("panoramaDraw");
    QTest::keyClicks(hands.find<QLineEdit>("panoramaOutlineUnit"), QStringLiteral("900"));
    // First near to the ground, as anybody would: at six times the size.
    const auto middle = pixel_of(*panorama, *place, centre_of(dig));
    REQUIRE(middle.has_value());
    panorama->zoom(6.0, *middle);
    for (const Place& corner : corners_in(dig, 0.35)) {
        const auto pixel = pixel_of(*panorama, *place, corner);
        REQUIRE(pixel.has_value());
        hands.click_at(panorama, *pixel);
    }
    CHECK(hands.window.models().outline.corners().size() == 4);
    hands.picture("06_drawing_on_the_panorama");
    QTest::keyClick(panorama, Qt::Key_Return);
    hands.settle_all();
    REQUIRE(hands.record().regions.size() == 1);

    // One of its corners is dragged outwards, and that taken back by undo.
    hands.click("panoramaChange");
    const auto inside = panorama->to_screen(panorama->shapes().front().middle);
    hands.click_at(panorama, inside);
    OutlineEdit& edit = hands.window.models().edit;
    REQUIRE(edit.rings().size() == 1);
    REQUIRE(edit.rings().front().size() >= 4);
    const double area = panorama->shapes().front().area;
    const QPointF corner = panorama->to_screen(edit.rings().front().front().at);
    hands.drag(panorama, corner, corner + (corner - inside) * 0.3);
    hands.picture("06_changing_on_the_panorama");
    hands.click("panoramaFinish");
    hands.settle_all();
    CHECK(panorama->shapes().front().area > area);
    hands.find<QAction>("undo")->trigger();
    hands.settle_all();
    CHECK(std::abs(panorama->shapes().front().area - area) < 1e-9);
    hands.click("panoramaChange");

    // Another in plan, beside it, snapping to the first; it is seen at once in both views.
    hands.window.show_view("plan");
    hands.settle_all();
    auto* plan = hands.find<FlatCanvas>("planCanvas");
    hands.click("planDraw");
    CHECK(hands.window.width() == 1600); // the tools do not push the window wider than it was
    hands.find<QLineEdit>("planOutlineUnit")->selectAll();
    QTest::keyClicks(hands.find<QLineEdit>("planOutlineUnit"), QStringLiteral("901"));
    std::vector<Place> beside = corners_in(dig, 0.5);
    for (const Place& spot : beside) hands.click_at(plan, plan->to_screen({spot.x + 1.2, spot.y}));
    QTest::mouseClick(plan, Qt::LeftButton, {}, plan->to_screen({beside[0].x + 1.2, beside[0].y}).toPoint());
    hands.settle_all();
    REQUIRE(hands.record().regions.size() == 2);
    hands.picture("07_plan");
    hands.window.show_view("3d");
    hands.picture("08_3d");

    // What the draughtsman drew takes the place of both, and the surfaces say what they prove.
    hands.find<QAction>("undo")->trigger();
    hands.settle_all();
    hands.find<QAction>("undo")->trigger();
    hands.settle_all();
    REQUIRE(hands.record().regions.empty());
    hands.drop({files / "outlines" / "2025-06-01.geojson"});

    // What changed on the second day has no outline yet: the window offers it, and one patch is taken.
    hands.window.show_view("plan");
    hands.click("planOffer");
    PatchModel& patches = hands.window.models().patches;
    REQUIRE_FALSE(patches.patches().empty());
    hands.click_at(plan, plan->to_screen(patches.shapes().front().middle));
    CHECK(patches.chosen() >= 0);
    hands.find<QLineEdit>("planOutlineUnit")->selectAll();
    QTest::keyClicks(hands.find<QLineEdit>("planOutlineUnit"), QStringLiteral("1003"));
    hands.picture("08_offered");
    const std::size_t outlined = hands.record().regions.size();
    hands.click("planFinish");
    CHECK(hands.record().regions.size() == outlined + 1);
    hands.window.show_view("panorama");
    hands.click("panoramaOffer");
    hands.picture("08_offered_on_the_panorama");
    hands.click("panoramaOffer");
    hands.find<QAction>("undo")->trigger();
    hands.settle_all();

    hands.drop({files / "outlines" / "2025-06-02.geojson"});
    CHECK(hands.record().regions.size() > 4);
    hands.window.show_view("plan");
    hands.window.show_view("suggestions");
    hands.settle_all();
    auto* proposed = hands.find<QListView>("suggestionList");
    REQUIRE(proposed->model()->rowCount() > 0);
    hands.click_at(proposed->viewport(), proposed->visualRect(proposed->model()->index(0, 0)).center());
    hands.settle_all();
    hands.picture("09_suggestion");
    const int open = proposed->model()->rowCount();
    const std::size_t statements = hands.record().statements.size();
    hands.click("acceptSuggestion");
    CHECK(proposed->model()->rowCount() < open);
    CHECK(hands.record().statements.size() == statements + 1);
    hands.picture("10_accepted");

    // The first problem: looked at, and its likeliest suspect marked uncertain for a reason.
    hands.window.show_view("problems");
    hands.window.show_view("matrix");
    auto* list = hands.find<QListView>("problemList");
    REQUIRE(list->model()->rowCount() > 0);
    hands.click_at(list->viewport(), list->visualRect(list->model()->index(0, 0)).center());
    hands.settle_all();
    hands.picture("11_problem");
    const std::size_t before = hands.window.models().problems.check().problems.size();
    hands.answer_next({QStringLiteral("the lip of the cut had slumped")});
    hands.click("acceptProblem");
    CHECK(hands.window.models().problems.check().problems.size() + 1 == before);
    CHECK(hands.window.models().problems.check().accepted.size() == 1);
    hands.picture("12_known");

    // Undo says what it takes back, and takes it back.
    hands.find<QAction>("undo")->trigger();
    hands.settle_all();
    CHECK(hands.window.models().problems.check().accepted.empty());

    // Which lines of the matrix surfaces and levels confirm.
    hands.window.show_view("matrix");
    hands.click("matrixEvidence");
    auto* matrix = dynamic_cast<MatrixView*>(hands.window.view("matrix"));
    REQUIRE(matrix != nullptr);
    const LineVerdicts verdicts = matrix->model().verdicts();
    CHECK(verdicts.size() == matrix->model().drawing()->lines.size());
    CHECK(std::count(verdicts.begin(), verdicts.end(), model::EvidenceVerdict::Confirmed) > 0);
    hands.picture("13_evidence");
    hands.click("matrixEvidence");

    // A flight past two placed cameras; where there is no OpenGL there is no view to fly through.
    hands.window.show_view("3d");
    hands.settle_all();
    if (auto* space = hands.window.findChild<SpaceCanvas*>(QStringLiteral("spaceCanvas"))) {
        hands.click("spaceCut");
        hands.find<QAction>("placeCamera")->trigger();
        for (int i = 0; i < 3; ++i) QTest::keyClick(space, Qt::Key_Left);
        hands.find<QAction>("placeCamera")->trigger();
        hands.settle_all();
        auto* cameras = hands.find<FlightCameras>("flightCameras");
        CHECK(cameras->placed().size() == 2);
        CHECK(read_flight(flight_file_of(hands.window.models().workspace.file())).size() == 2);
        lay_section_line(hands, *space);
        fs::create_directories(folder / "flight");
        QSignalSpy flown(&space->flight(), &FlightWriter::flown);
        space->flight().start(cameras->placed(), folder / "flight", 2);
        REQUIRE(flown.wait(60'000));
        for (const char* frame : {"fly-0001.png", "fly-0002.png", "fly-0003.png"}) {
            const QImage picture(text(folder / "flight" / frame));
            CHECK(picture.size() == space->size() * space->devicePixelRatioF());
        }
        CHECK_FALSE(fs::exists(folder / "flight" / "fly-0004.png"));
        hands.picture("14_flown");
    }

    for (const char* name : {"matrix.pdf", "report.html"}) {
        hands.answer_next({text(folder / name)});
        hands.find<QAction>("export")->trigger();
        hands.settle_all();
        CHECK(fs::file_size(folder / name) > 1000);
    }
    // On paper: the report of one day, and the plan to scale. Each asks what, then where to.
    for (const auto& [action, name] : {std::pair("writeReport", "report.pdf"), std::pair("writePlan", "plan.pdf")}) {
        hands.answer_next({action == std::string_view("writeReport") ? QStringLiteral("2025-06-01") : QString()});
        QTimer::singleShot(300, &hands.window, [&hands, &folder, name] { hands.answer_next({text(folder / name)}); });
        hands.find<QAction>(action)->trigger();
        hands.settle_all();
        CHECK(fs::file_size(folder / name) > 1000);
    }
    hands.picture("15_written");
    CHECK(hands.failures.isEmpty());
    INFO(hands.failures.join(QLatin1Char('\n')).toStdString());
    CHECK(hands.said.size() >= 5);
}
