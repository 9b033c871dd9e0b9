// SPDX-License-Identifier: MIT
#include "app/records/document_file.hpp"

#include <filesystem>

#include "tests/support/catch.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;
using app::DocumentPlace;

namespace {

// A folder with the project in `dig`, a photo below it and a file beside it that is nobody's business.
struct Dig {
    test::TemporaryFolder folder;
    std::filesystem::path project = folder / "dig/site.gpkg";

    Dig() {
        std::filesystem::create_directories(folder / "dig/photos");
        static_cast<void>(folder.write("dig/photos/1.jpg", "a photo"));
        static_cast<void>(folder.write("secret.jpg", "somebody's own"));
        std::filesystem::create_directories(folder / "dig-two");
        static_cast<void>(folder.write("dig-two/1.jpg", "of another dig"));
    }

    [[nodiscard]] DocumentPlace place(const std::string& path) const { return app::document_file(project, path).place; }
};

} // namespace

TEST_CASE("A document's path leads to the file beside the project, wherever the program runs") {
    const Dig dig;
    const app::DocumentFile found = app::document_file(dig.project, "photos/1.jpg");
    REQUIRE(found.place == DocumentPlace::Inside);
    CHECK(std::filesystem::equivalent(found.file, dig.folder / "dig/photos/1.jpg"));
    CHECK(dig.place("./photos//1.jpg") == DocumentPlace::Inside);
    CHECK(dig.place((dig.folder / "dig/photos/1.jpg").string()) == DocumentPlace::Inside);
}

TEST_CASE("A document's path never leads out of the project's folder") {
    const Dig dig;
    std::filesystem::create_symlink(dig.folder / "secret.jpg", dig.folder / "dig/photos/link.jpg");
    std::filesystem::create_directory_symlink(dig.folder.path(), dig.folder / "dig/up");
    std::filesystem::create_symlink("1.jpg", dig.folder / "dig/photos/again.jpg");
    CHECK(dig.place("../secret.jpg") == DocumentPlace::Outside);
    CHECK(dig.place("photos/../../secret.jpg") == DocumentPlace::Outside);
    CHECK(dig.place("../nothing.jpg") == DocumentPlace::Outside);
    CHECK(dig.place((dig.folder / "secret.jpg").string()) == DocumentPlace::Outside);
    CHECK(dig.place((dig.folder / "dig-two/1.jpg").string()) == DocumentPlace::Outside);
    CHECK(dig.place("/etc/hostname") == DocumentPlace::Outside);
    CHECK(dig.place("/nothing/of/the/kind") == DocumentPlace::Outside);
    CHECK(dig.place("photos/link.jpg") == DocumentPlace::Outside);
    CHECK(dig.place("up/secret.jpg") == DocumentPlace::Outside);
    CHECK(dig.place("up/nothing.jpg") == DocumentPlace::Outside);
    CHECK(dig.place("photos/again.jpg") == DocumentPlace::Inside);
}

TEST_CASE("What is no file is not given out as one") {
    const Dig dig;
    std::filesystem::create_symlink("circle.jpg", dig.folder / "dig/circle.jpg");
    CHECK(dig.place("") == DocumentPlace::NoPath);
    CHECK(dig.place("photos/2.jpg") == DocumentPlace::Missing);
    CHECK(dig.place("photos/1.jpg/deeper.jpg") == DocumentPlace::Missing);
    CHECK(dig.place(std::string(5000, 'x')) == DocumentPlace::Missing);
    CHECK(dig.place("circle.jpg") == DocumentPlace::Missing);
    CHECK(dig.place("photos") == DocumentPlace::NoFile);
    CHECK(app::document_file(dig.folder / "gone/site.gpkg", "1.jpg").place == DocumentPlace::Missing);
}
