// SPDX-License-Identifier: MIT
#include "gui/viewmodels/models.hpp"
#include "gui/viewmodels/paper_file.hpp"

#include <algorithm>
#include <limits>

#include "app/records/record_kind.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

TEST_CASE("Documents that are pictures stand apart from those that are not, by natural number") {
    test::GuiProject site;
    {
        app::Project project = app::Project::open(site.file, store::OpenMode::ReadWrite, {"Ada"});
        const app::RecordKind& documents = app::record_kind("document");
        documents.add(project, "10", {{"unit", "1"}, {"type", "photo"}, {"path", "photos/b.JPG"}});
        documents.add(project, "2",
                      {{"unit", "1"},
                       {"type", "photo"},
                       {"title", "from the east"},
                       {"path", "photos/a.png"},
                       {"made-on", "2025-06-01"},
                       {"author", "Ada"}});
        documents.add(project, "3", {{"unit", "1"}, {"type", "sheet"}, {"path", "sheets/1.pdf"}});
        documents.add(project, "4", {{"unit", "1"}, {"type", "drawing"}});
        documents.add(project, "5", {{"unit", "2"}, {"type", "photo"}, {"path", "photos/c.jpg"}});
    }
    Models models;
    models.workspace.open(site.file, store::OpenMode::ReadOnly);
    settle(models.workspace);
    const auto& snapshot = models.workspace.snapshot();
    models.workspace.select(snapshot->record().units[snapshot->index().named("1").front()].id);
    const auto& pictures = models.card.pictures();
    REQUIRE(pictures.size() == 2);
    CHECK(pictures[0].title == QStringLiteral("photo 2, from the east"));
    CHECK(pictures[0].path == QStringLiteral("photos/a.png"));
    CHECK(pictures[0].made == QStringLiteral("2025-06-01, Ada"));
    CHECK(pictures[1].title == QStringLiteral("photo 10"));
    const auto& lines = models.card.lines();
    const auto sheet =
        std::find_if(lines.begin(), lines.end(), [](const CardLine& l) { return l.kind == QStringLiteral("sheet"); });
    REQUIRE(sheet != lines.end());
    CHECK(sheet->path == QStringLiteral("sheets/1.pdf"));
    CHECK(std::any_of(lines.begin(), lines.end(),
                      [](const CardLine& l) { return l.kind == QStringLiteral("drawing") && l.path.isEmpty(); }));
    models.workspace.select({});
    CHECK(models.card.pictures().empty());
}

TEST_CASE("A document's file that cannot be shown is a sentence with its path") {
    const test::TemporaryFolder folder;
    static_cast<void>(folder.write("a.jpg", "x"));
    std::filesystem::create_directories(folder / "photos");
    const auto project = folder / "site.gpkg";
    CHECK(paper_file(project, QStringLiteral("a.jpg")).sentence.isEmpty());
    CHECK_FALSE(paper_file(project, QStringLiteral("a.jpg")).file.empty());
    for (const char* path : {"b.jpg", "../a.jpg", "/etc/hostname", "photos"}) {
        const PaperFile none = paper_file(project, QString::fromUtf8(path));
        INFO(none.sentence.toStdString());
        CHECK(none.file.empty());
        CHECK(none.sentence.startsWith(QString::fromUtf8(path)));
    }
}

TEST_CASE("Pictures are opened up to a size in bytes and in pixels, whatever a file claims") {
    const QString path = QStringLiteral("a.jpg");
    CHECK(picture_too_large(path, 8'000'000, 6000, 4000).isEmpty());
    CHECK(picture_too_large(path, kMostPictureBytes + 1, 10, 10).contains(QStringLiteral("301 MB")));
    CHECK_FALSE(picture_too_large(path, 100, 65500, 65500).isEmpty());
    const qint64 most = std::numeric_limits<int>::max();
    CHECK_FALSE(picture_too_large(path, 100, most, most).isEmpty());
    CHECK(picture_too_large(path, 100, -1, -1).isEmpty()); // it does not say: the decoder's own limit holds
}

TEST_CASE("What is shown as a picture is told from the ending") {
    for (const char* path : {"a.jpg", "photos/IMG_1.JPEG", "plan.tif", "DSC1"})
        CHECK(names_picture(QString::fromUtf8(path)));
    for (const char* path : {"", "a.pdf", "a.svg", "a.jpg.docx"}) CHECK_FALSE(names_picture(QString::fromUtf8(path)));
}
