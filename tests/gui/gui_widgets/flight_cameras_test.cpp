// SPDX-License-Identifier: MIT
#include "gui/widgets/space/flight_cameras.hpp"

#include <QSignalSpy>

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "gui/render/flight_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_application.hpp"
#include "tests/support/gui_project.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

namespace {

Camera at(double x) {
    Camera camera;
    camera.target = {x, 2.25, 101.0};
    return camera;
}

// One window's cameras.
struct Desk {
    explicit Desk(const std::filesystem::path& file, store::OpenMode mode = store::OpenMode::ReadWrite) {
        QObject::connect(&cameras, &FlightCameras::troubled, [this](const QString& s) { troubles << s; });
        workspace.open(file, mode);
        settle(workspace);
        settle(workspace);
    }

    void place(double x) {
        cameras.place(at(x));
        settle(workspace);
    }

    [[nodiscard]] std::size_t placed() const { return cameras.placed().size(); }

    Workspace workspace{app::Session{"Ada"}};
    FlightCameras cameras{workspace};
    QStringList troubles;
};

struct Site {
    const int application = (test::ensure_application(), 0); // before what would make one without widgets
    test::GuiProject project;
    std::filesystem::path kept = project.folder / "site.flight.json";
};

} // namespace

TEST_CASE("Cameras of a flight are there again when the project is opened again") {
    const Site site;
    {
        Desk desk(site.project.file);
        CHECK(desk.placed() == 0);
        CHECK_FALSE(std::filesystem::exists(site.kept));
        desk.place(1.0);
        desk.place(2.0);
    }
    Desk again(site.project.file, store::OpenMode::ReadOnly);
    REQUIRE(again.placed() == 2);
    CHECK(again.cameras.placed()[1].target.x() == 2.0);
    again.workspace.close();
    CHECK(again.placed() == 0);
    CHECK(again.troubles.isEmpty());
}

TEST_CASE("Placing and forgetting cameras can be taken back") {
    const Site site;
    Desk desk(site.project.file);
    CHECK(desk.cameras.former_label().isEmpty());
    desk.place(1.0);
    desk.place(2.0);
    desk.cameras.forget();
    settle(desk.workspace);
    CHECK(desk.placed() == 0);
    CHECK_FALSE(std::filesystem::exists(site.kept));
    desk.cameras.take_back();
    settle(desk.workspace);
    CHECK(desk.placed() == 2);
    CHECK(read_flight(site.kept).size() == 2);
    desk.cameras.take_back();
    settle(desk.workspace);
    CHECK(desk.placed() == 1);
    desk.cameras.take_back();
    settle(desk.workspace);
    CHECK(desk.placed() == 0);
    CHECK(desk.cameras.former_label().isEmpty());
    CHECK(desk.troubles.isEmpty());
}

TEST_CASE("Two windows on one project add cameras to the same flight, and none takes back what the other did") {
    const Site site;
    Desk one(site.project.file);
    Desk two(site.project.file);
    one.place(1.0);
    two.place(2.0);
    CHECK(two.placed() == 2);
    one.cameras.take_back();
    settle(one.workspace);
    CHECK(one.placed() == 2);
    CHECK(one.troubles.size() == 1);
    CHECK(read_flight(site.kept).size() == 2);
}

TEST_CASE("Where cameras cannot be kept they stay in the window, with a sentence") {
    const Site site;
    static_cast<void>(site.project.folder.write("site.flight.json", "{ somebody's own"));
    Desk desk(site.project.file);
    CHECK(desk.troubles.size() == 1);
    desk.place(1.0);
    CHECK(desk.placed() == 1);
    REQUIRE(desk.troubles.size() == 2);
    CHECK(desk.troubles.last().contains(QStringLiteral("site.flight.json")));
    CHECK(read_file(site.kept, 100) == "{ somebody's own");
    Desk reader(site.project.file, store::OpenMode::ReadOnly);
    reader.place(1.0);
    CHECK(reader.placed() == 1);
    CHECK(reader.troubles.size() == 2);
}

TEST_CASE("Cameras are read as they were written, and written as they were read") {
    Camera camera = at(-3.00004);
    camera.yaw = 2.0;
    camera.pitch = -0.1;
    camera.distance = 12.5;
    camera.from_above = true;
    const std::string text = flight_text({camera, at(1.0)});
    const std::vector<Camera> read = flight_from(text);
    REQUIRE(read.size() == 2);
    CHECK((read[0].target - camera.target).norm() < 1e-4);
    CHECK(read[0].yaw == Approx(2.0));
    CHECK(read[0].pitch == Approx(-0.1));
    CHECK(read[0].distance == Approx(12.5));
    CHECK(read[0].from_above);
    CHECK(read[1].opening == Approx(Camera{}.opening));
    CHECK_FALSE(read[1].from_above);
    CHECK(flight_text(read) == text);
    CHECK(flight_from(flight_text({})).empty());
    CHECK(flight_file_of("/dig/site.planum.gpkg") == std::filesystem::path("/dig/site.planum.flight.json"));
}

TEST_CASE("What is no camera is refused with its place") {
    const auto refused = [](const std::string& text) {
        try {
            static_cast<void>(flight_from(text));
        } catch (const Error& error) {
            CHECK(error.code() == ErrorCode::BadInput);
            return std::string(error.what());
        }
        return std::string("taken");
    };
    const auto cameras = [](const std::string& list) {
        return R"({"format": "planum-flight", "version": 1, "cameras": )" + list + "}";
    };
    CHECK(refused("{\n\n oh").find("line 3") == 0);
    CHECK(refused("[]").find("planum-flight") != std::string::npos);
    CHECK(refused(R"({"format": "planum-flight", "version": 2, "cameras": []})").find("version 2") == 0);
    CHECK(refused(cameras("7")).find("cameras") == 0);
    const std::string sound = R"({"target": [1, 2, 3], "distance": 4})";
    CHECK(refused(cameras("[" + sound + "]")) == "taken");
    CHECK(refused(cameras("[" + sound + R"(, {"target": [1, 2], "distance": 4}])")).find("camera 2: target") == 0);
    CHECK(refused(cameras(R"([{"target": [1, 2, 3]}])")).find("camera 1: distance") == 0);
    CHECK(refused(cameras(R"([{"target": [1, 2, 1e99], "distance": 4}])")).find("camera 1: target") == 0);
    CHECK(refused(cameras(R"([{"target": [1, 2, 3], "distance": 0}])")).find("camera 1: distance") == 0);
    CHECK(refused(cameras(R"([{"target": [1, 2, 3], "distance": 4, "pitch_deg": "up"}])")).find("camera 1: pitch") ==
          0);
}
