// SPDX-License-Identifier: MIT
// What happens where nothing can be written, the disk is full, or two processes write.
#include <chrono>
#include <csignal>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "core/sqlite/database.hpp"
#include "core/store/project_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/core_store/child_process.hpp"
#include "tests/unit/core_store/filled_project.hpp"

using namespace planum;
using namespace planum::store;
using planum::test::a_unit;
using planum::test::message_of;

namespace {

/// The message of a change that does not fit.
std::string add_too_much(const std::filesystem::path& file) {
    test::TestEnvironment environment(5);
    ProjectFile project = ProjectFile::open(file, OpenMode::ReadWrite, environment.get());
    return message_of([&] {
        project.change("Too much", [&] {
            for (int i = 0; i < 4000; ++i) project.insert(a_unit("n" + std::to_string(i)));
        });
    });
}

} // namespace

TEST_CASE("A project on read-only media can be read and not written") {
    const test::TemporaryFolder folder;
    test::TestEnvironment making;
    (void)test::fill_project(folder / "whole.gpkg", making);
    const auto file = folder / "whole.gpkg";
    for (const bool wal : {false, true}) {
        if (wal) sqlite::Database::open(file, sqlite::Access::ReadWrite).execute("PRAGMA journal_mode = WAL");
        std::filesystem::permissions(file, std::filesystem::perms{0444});
        std::filesystem::permissions(folder.path(), std::filesystem::perms{0555});
        const int status = test::in_child([&] {
            // Permissions do not bind root.
            if (getuid() == 0 && setuid(65534) != 0) return 1;
            test::TestEnvironment environment(5);
            if (ProjectFile::open(file, OpenMode::ReadOnly, environment.get()).load().units.size() != 6) return 2;
            const std::string said =
                message_of([&] { (void)ProjectFile::open(file, OpenMode::ReadWrite, environment.get()); });
            return said.find("read-only") != std::string::npos ? 0 : 3;
        });
        std::filesystem::permissions(folder.path(), std::filesystem::perms{0755});
        std::filesystem::permissions(file, std::filesystem::perms{0644});
        INFO("wal " << wal);
        CHECK(status == 0);
    }
}

TEST_CASE("A write that fails is an error, and nothing is changed") {
    const test::TemporaryFolder folder;
    test::TestEnvironment making;
    (void)test::fill_project(folder / "whole.gpkg", making);
    const auto file = folder / "whole.gpkg";
    const std::string before = test::raw_rows(file);
    const int status = test::in_child([&] {
        std::signal(SIGXFSZ, SIG_IGN);
        const auto size = static_cast<rlim_t>(std::filesystem::file_size(file));
        const rlimit limit{size + 8192, size + 8192};
        setrlimit(RLIMIT_FSIZE, &limit);
        return add_too_much(file).find("disk") != std::string::npos ? 0 : 3;
    });
    CHECK(status == 0);
    CHECK(test::raw_rows(file) == before);
    test::TestEnvironment environment(6);
    CHECK(ProjectFile::open(file, OpenMode::ReadWrite, environment.get()).verify(Progress::none()).empty());
}

TEST_CASE("A full disk is said by name, and nothing is changed") {
    const test::TemporaryFolder folder;
    test::TestEnvironment making;
    (void)test::fill_project(folder / "whole.gpkg", making);
    const auto disk = folder / "disk";
    std::filesystem::create_directory(disk);
    const int status = test::in_child([&] {
        // A disk of its own, seen by this process only; where even that is forbidden there is nothing to test.
        const int spaces = getuid() == 0 ? CLONE_NEWNS : CLONE_NEWNS | CLONE_NEWUSER;
        if (unshare(spaces) != 0 || mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
            mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=1500k") != 0) {
            return 77;
        }
        const auto file = disk / "site.gpkg";
        std::filesystem::copy_file(folder / "whole.gpkg", file);
        const std::string before = test::raw_rows(file);
        if (add_too_much(file).find("the disk is full") == std::string::npos) return 3;
        test::TestEnvironment environment(6);
        const ProjectFile project = ProjectFile::open(file, OpenMode::ReadWrite, environment.get());
        return test::raw_rows(file) == before && project.verify(Progress::none()).empty() ? 0 : 4;
    });
    if (status == 77) {
        WARN("skipped: no disk may be mounted here");
        return;
    }
    CHECK(status == 0);
}

namespace {

// SQLite's waiting is not fair: two loops without a pause can starve one another on a busy machine, which no
// two people do.
void take_breath() { std::this_thread::sleep_for(std::chrono::milliseconds(20)); }

} // namespace

TEST_CASE("Two processes write one project in turn, and each sees the other's work") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    const auto file = folder / "site.gpkg";
    ProjectFile project = ProjectFile::create(file, test::some_settings(), environment.get());
    constexpr int kEach = 20;
    const pid_t child = fork();
    if (child == 0) {
        int status = 0;
        try {
            test::TestEnvironment other(1234);
            ProjectFile same = ProjectFile::open(file, OpenMode::ReadWrite, other.get("Bea"));
            for (int i = 0; i < kEach; ++i) {
                same.change("Theirs", [&] { same.insert(a_unit("b" + std::to_string(i))); });
                take_breath();
            }
        } catch (...) {
            status = 1;
        }
        _exit(status);
    }
    for (int i = 0; i < kEach; ++i) {
        project.change("Mine", [&] { project.insert(a_unit("a" + std::to_string(i))); });
        take_breath();
    }
    int status = -1;
    waitpid(child, &status, 0);
    CHECK(status == 0);
    CHECK(project.load().units.size() == 2 * kEach);
    CHECK(project.history(100).size() == 2 * kEach);
    CHECK(project.verify(Progress::none()).empty());
}
