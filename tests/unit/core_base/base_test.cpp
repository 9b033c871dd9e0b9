// SPDX-License-Identifier: MIT
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/sha256.hpp"
#include "core/base/uuid.hpp"

#include <string>

#include "tests/support/catch.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;

TEST_CASE("An error says what was being done, then what went wrong") {
    try {
        try {
            throw Error(ErrorCode::Conflict, "number already used in area A");
        } catch (Error& e) {
            e.add_context("adding unit 1042");
            throw;
        }
    } catch (const Error& e) {
        CHECK(std::string(e.what()) == "adding unit 1042: number already used in area A");
        CHECK(e.code() == ErrorCode::Conflict);
    }
}

TEST_CASE("An id reads back from its text, and nothing else does") {
    SeededUuids ids(7);
    for (int i = 0; i < 100; ++i) {
        const Uuid id = ids.next();
        CHECK(Uuid::parse(id.to_string()) == id);
    }
    CHECK_FALSE(Uuid::parse("").has_value());
    CHECK_FALSE(Uuid::parse("0123456789abcdef0123456789abcdef0123").has_value());
    CHECK(Uuid::parse("0123ABCD-0000-7000-8000-0000000000ff")->to_string() == "0123abcd-0000-7000-8000-0000000000ff");
}

TEST_CASE("Ids made one after the other sort in that order, so that indexes grow at their end") {
    TimeOrderedUuids ids;
    Uuid before = ids.next();
    for (int i = 0; i < 10000; ++i) {
        const Uuid next = ids.next();
        REQUIRE(before < next);
        before = next;
    }
}

TEST_CASE("SHA-256 gives the digests of FIPS 180-4") {
    CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST_CASE("A file is written whole or not at all") {
    const test::TemporaryFolder folder;
    const auto file = folder / "out.txt";
    write_file_atomically(file, "first");
    write_file_atomically(file, "second");
    CHECK(read_file(file, 100) == "second");
    CHECK_THROWS_AS(read_file(file, 3), Error);
    CHECK_THROWS_AS(write_file_atomically(folder / "no/such/folder/out.txt", "x"), Error);
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("A link is written through, and what is no file is written into, never replaced") {
    namespace fs = std::filesystem;
    const test::TemporaryFolder folder;
    write_file_atomically(folder / "kept.txt", "first");
    fs::create_symlink("kept.txt", folder / "link.txt");
    write_file_atomically(folder / "link.txt", "second");
    CHECK(fs::is_symlink(folder / "link.txt"));
    CHECK(read_file(folder / "kept.txt", 100) == "second");
    // Through links, so that nothing of the system is lost if this fails.
    for (const char* device : {"/dev/null", "/dev/full"}) {
        const auto link = folder / fs::path(device).filename().string();
        fs::create_symlink(device, link);
        INFO(device);
        if (std::string_view(device) == "/dev/full") {
            CHECK_THROWS_AS(write_file_atomically(link, "x"), Error);
        } else {
            CHECK_NOTHROW(write_file_atomically(link, "x"));
        }
        CHECK(fs::is_symlink(link));
    }
    CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 4);
}

TEST_CASE("A database is not replaced by another kind of file") {
    const test::TemporaryFolder folder;
    const auto project = folder / "site.gpkg";
    const std::string database("SQLite format 3\0 and the record of years", 40);
    write_file_atomically(project, database);
    try {
        write_file_atomically(project, "<svg/>");
        FAIL("replaced");
    } catch (const Error& e) {
        CHECK(e.code() == ErrorCode::BadInput);
    }
    std::filesystem::create_symlink("site.gpkg", folder / "drawing.svg");
    CHECK_THROWS_AS(write_file_atomically(folder / "drawing.svg", "<svg/>"), Error);
    CHECK(read_file(project, 100) == database);
}
