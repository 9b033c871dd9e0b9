// SPDX-License-Identifier: MIT
#include <QLabel>
#include <QTest>

#include <cstdlib>
#include <string>

#include "app/records/record_kind.hpp"
#include "core/base/file.hpp"
#include "gui/viewmodels/paper_file.hpp"
#include "gui/widgets/card/photo_button.hpp"
#include "gui/widgets/card/photo_window.hpp"
#include "gui/widgets/card/picture_file.hpp"
#include "gui/widgets/window/main_window.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_application.hpp"
#include "tests/support/gui_project.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

namespace {

void write_picture(const std::filesystem::path& file, int width, int height, const char* format) {
    QImage image(width, height, QImage::Format_RGB32);
    image.fill(Qt::darkGreen);
    REQUIRE(image.save(QString::fromStdString(file.string()), format));
}

// The head of a PNG that claims this size, and nothing sound behind it.
std::string claiming_png(unsigned width, unsigned height) {
    const auto number = [](unsigned v) {
        std::string bytes;
        for (int shift = 24; shift >= 0; shift -= 8)
            bytes += static_cast<char>((v >> static_cast<unsigned>(shift)) & 0xffU);
        return bytes;
    };
    const std::string chunk = "IHDR" + number(width) + number(height) + std::string("\x08\x02\x00\x00\x00", 5);
    unsigned crc = 0xffffffffU;
    for (const char c : chunk) {
        crc ^= static_cast<unsigned char>(c);
        for (int k = 0; k < 8; ++k) crc = (crc & 1U) != 0 ? 0xedb88320U ^ (crc >> 1U) : crc >> 1U;
    }
    return std::string("\x89PNG\r\n\x1a\n", 8) + number(13) + chunk + number(~crc) + number(40) + "IDAT" +
           std::string(64, '\0');
}

// Unit 1 with two photos that can be shown and two that cannot.
struct Photos {
    const int application = (test::ensure_application(), 0); // before what would make one without widgets
    test::GuiProject site;
    MainWindow window{app::Session{"Ada"}};

    Photos() {
        std::filesystem::create_directories(site.folder / "photos");
        write_picture(site.folder / "photos/1.jpg", 3000, 2000, "JPEG");
        write_picture(site.folder / "photos/2.png", 40, 30, "PNG");
        static_cast<void>(site.folder.write("photos/3.jpg", "no picture at all"));
        {
            app::Project project = app::Project::open(site.file, store::OpenMode::ReadWrite, {"Ada"});
            const auto add = [&](const char* number, const char* path) {
                app::record_kind("document").add(project, number, {{"unit", "1"}, {"type", "photo"}, {"path", path}});
            };
            add("1", "photos/1.jpg");
            add("2", "photos/2.png");
            add("3", "photos/3.jpg");
            add("4", "../outside.jpg");
        }
        window.open(site.file, store::OpenMode::ReadWrite);
        window.show();
        settle_all();
        const auto& snapshot = window.models().workspace.snapshot();
        window.models().workspace.select(snapshot->record().units[snapshot->index().named("1").front()].id);
        settle_all();
    }

    void settle_all() {
        for (int i = 0; i < 3; ++i) settle(window.models().workspace);
    }

    [[nodiscard]] PhotoButton& button(int number) const {
        auto* found = window.findChild<PhotoButton*>(QStringLiteral("photo%1").arg(number));
        REQUIRE(found != nullptr);
        return *found;
    }
};

} // namespace

TEST_CASE("The photos of a unit are small pictures in its card; what cannot be shown is said with its path") {
    const Photos photos;
    CHECK_FALSE(photos.button(1).picture().isNull());
    CHECK(photos.button(1).picture().width() <= 2 * PhotoButton::room().width());
    CHECK(std::abs(2 * photos.button(1).picture().width() - 3 * photos.button(1).picture().height()) <= 3);
    CHECK(photos.button(2).picture().size() == QSize(40, 30)); // never larger than it is
    CHECK(photos.button(3).isHidden());
    CHECK(photos.button(4).isHidden());
    const auto* said = photos.window.findChild<QLabel*>(QStringLiteral("photoTrouble"));
    REQUIRE(said != nullptr);
    CHECK(said->text().contains(QStringLiteral("photos/3.jpg")));
    CHECK(said->text().contains(QStringLiteral("../outside.jpg")));
}

TEST_CASE("A click or Enter opens a photo large, and the arrows go to the others") {
    Photos photos;
    QTest::mouseClick(&photos.button(1), Qt::LeftButton);
    photos.settle_all();
    auto* large = photos.window.findChild<PhotoWindow*>(QStringLiteral("photoWindow"));
    REQUIRE(large != nullptr);
    CHECK(large->picture().width() > 3 * photos.button(1).picture().width());
    const auto* caption = large->findChild<QLabel*>(QStringLiteral("photoCaption"));
    CHECK(caption->text().contains(QStringLiteral("3000 × 2000")));
    QTest::keyClick(large, Qt::Key_Right);
    photos.settle_all();
    CHECK(large->picture().size() == QSize(40, 30));
    QTest::keyClick(large, Qt::Key_Right);
    photos.settle_all();
    CHECK(large->picture().isNull());
    QTest::keyClick(large, Qt::Key_Escape);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    CHECK(photos.window.findChild<PhotoWindow*>() == nullptr);
    QTest::keyClick(&photos.button(2), Qt::Key_Return);
    photos.settle_all();
    large = photos.window.findChild<PhotoWindow*>(QStringLiteral("photoWindow"));
    REQUIRE(large != nullptr);
    CHECK(large->picture().size() == QSize(40, 30));
}

TEST_CASE("Another change of the record reads no photo again; another unit has its own") {
    Photos photos;
    const PhotoButton* before = &photos.button(1);
    photos.window.models().card.set_field("title", QStringLiteral("ash"));
    photos.settle_all();
    CHECK(before == &photos.button(1));
    const auto& snapshot = photos.window.models().workspace.snapshot();
    photos.window.models().workspace.select(snapshot->record().units[snapshot->index().named("2").front()].id);
    photos.settle_all();
    CHECK(photos.window.findChild<QWidget*>(QStringLiteral("photoStrip"))->isHidden());
}

TEST_CASE("A file that claims to be enormous is not unpacked, a broken or foreign one is a sentence") {
    test::ensure_application();
    const test::TemporaryFolder folder;
    const auto project = folder / "site.gpkg";
    const auto read = [&](const char* path) { return read_picture(project, QString::fromUtf8(path), {100, 100}); };
    static_cast<void>(folder.write("bomb.png", claiming_png(60'000, 60'000)));
    CHECK(read("bomb.png").sentence.contains(QStringLiteral("too large")));
    static_cast<void>(folder.write("cut.png", claiming_png(600, 600)));
    CHECK(read("cut.png").image.isNull());
    CHECK(read("cut.png").sentence.startsWith(QStringLiteral("cut.png cannot be read")));
    static_cast<void>(folder.write("drawing.png", "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/>"));
    CHECK(read("drawing.png").sentence.startsWith(QStringLiteral("drawing.png is no picture")));
    static_cast<void>(folder.write("empty.jpg", ""));
    CHECK_FALSE(read("empty.jpg").sentence.isEmpty());
    std::filesystem::resize_file(folder.write("long.jpg", "x"), static_cast<std::uintmax_t>(kMostPictureBytes) + 1);
    CHECK(read("long.jpg").sentence.contains(QStringLiteral("too large")));
    CHECK(read("gone.jpg").sentence.startsWith(QStringLiteral("gone.jpg is not there")));
}

TEST_CASE("A photo stands upright as the camera says") {
    test::ensure_application();
    const test::TemporaryFolder folder;
    write_picture(folder / "plain.jpg", 400, 200, "JPEG");
    std::string bytes = read_file(folder / "plain.jpg", 1'000'000);
    // An EXIF block that says orientation 6: turn right.
    const std::string exif("Exif\0\0MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0", 32);
    const auto length = static_cast<char>(exif.size() + 2);
    bytes.insert(2, std::string("\xff\xe1\0", 3) + length + exif);
    static_cast<void>(folder.write("turned.jpg", bytes));
    const ReadPicture turned = read_picture(folder / "site.gpkg", QStringLiteral("turned.jpg"), {100, 50});
    CHECK(turned.whole == QSize(200, 400));
    CHECK(turned.image.size() == QSize(25, 50));
}
