// SPDX-License-Identifier: MIT
#include "gui/widgets/space/flight_writer.hpp"

#include <QApplication>
#include <QSignalSpy>

#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;
using namespace planum::gui;

namespace {

struct Flying {
    Flying() {
        static int argc = 1;
        static char name[] = "test";
        static char* argv[] = {name, nullptr};
        if (QCoreApplication::instance() == nullptr) new QApplication(argc, argv);
        QObject::connect(&writer, &FlightWriter::wanted, [this](const Camera& camera) {
            QImage picture(8, 8, QImage::Format_RGB32);
            picture.fill(qRgb(static_cast<int>(camera.target.x()), 0, 0));
            writer.take(picture);
        });
    }

    static Camera at(double x) {
        Camera camera;
        camera.target.x() = x;
        return camera;
    }

    test::TemporaryFolder folder;
    JobRunner jobs;
    FlightWriter writer{jobs};
};

} // namespace

TEST_CASE("A flight writes one numbered picture for each camera of the way, and says how many") {
    Flying f;
    QSignalSpy flown(&f.writer, &FlightWriter::flown);
    f.writer.start({}, f.folder.path(), 4);
    CHECK_FALSE(f.writer.is_flying()); // no camera, no flight
    f.writer.start({Flying::at(10.0), Flying::at(90.0)}, f.folder.path(), 4);
    REQUIRE(flown.wait(test::kPatience));
    CHECK(flown.front().front().toInt() == 5);
    CHECK(qRed(QImage(QString::fromStdString((f.folder / "fly-0001.png").string())).pixel(0, 0)) == 10);
    CHECK(qRed(QImage(QString::fromStdString((f.folder / "fly-0005.png").string())).pixel(0, 0)) == 90);
    CHECK_FALSE(std::filesystem::exists(f.folder / "fly-0006.png"));
}

TEST_CASE("Frames of a longer flight in the same folder go, other files stay") {
    Flying f;
    const std::vector<Camera> cameras = {Flying::at(1.0), Flying::at(2.0)};
    QSignalSpy flown(&f.writer, &FlightWriter::flown);
    f.writer.start(cameras, f.folder.path(), 6);
    REQUIRE(flown.wait(test::kPatience));
    REQUIRE(QImage(8, 8, QImage::Format_RGB32).save(QString::fromStdString((f.folder / "fly-notes.png").string())));
    f.writer.start(cameras, f.folder.path(), 3);
    REQUIRE(flown.wait(test::kPatience));
    CHECK(std::filesystem::exists(f.folder / "fly-0004.png"));
    CHECK_FALSE(std::filesystem::exists(f.folder / "fly-0005.png"));
    CHECK_FALSE(std::filesystem::exists(f.folder / "fly-0007.png"));
    CHECK(std::filesystem::exists(f.folder / "fly-notes.png"));
}

TEST_CASE("A flight that is stopped says what it wrote; one into a folder that is gone is a sentence") {
    Flying f;
    const std::vector<Camera> cameras = {Flying::at(1.0), Flying::at(2.0)};
    QSignalSpy flown(&f.writer, &FlightWriter::flown);
    f.writer.start(cameras, f.folder.path(), 50);
    f.writer.stop();
    CHECK(flown.size() == 1);
    CHECK_FALSE(f.writer.is_flying());
    REQUIRE(f.jobs.wait_until_idle(test::kPatience));
    QSignalSpy troubled(&f.writer, &FlightWriter::troubled);
    f.writer.start(cameras, f.folder / "gone", 2);
    REQUIRE(f.jobs.wait_until_idle(test::kPatience));
    CHECK(troubled.size() == 1);
    CHECK_FALSE(f.writer.is_flying());
}
