// SPDX-License-Identifier: MIT
#include "tests/unit/core_store/kill_rounds.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <random>

#include "tests/support/catch.hpp"
#include "tests/unit/core_store/filled_project.hpp"

namespace planum::test {

using store::OpenMode;
using store::ProjectFile;

namespace {

constexpr std::size_t kUnitsAChange = 300;

/// Imports for ever, telling through the pipe whenever a change was acknowledged.
[[noreturn]] void import_until_killed(const std::filesystem::path& file, int pipe, std::uint64_t seed) {
    TestEnvironment environment(seed);
    ProjectFile project = ProjectFile::open(file, OpenMode::ReadWrite, environment.get("child"));
    for (;;) {
        project.change("Import", [&] {
            const std::string start = environment.uuids.next().to_string();
            model::UnitId before;
            for (std::size_t i = 0; i < kUnitsAChange; ++i) {
                const model::UnitId unit = project.insert(a_unit(start + "/" + std::to_string(i)));
                model::PhysicalRelation relation;
                relation.subject = unit;
                relation.object = before.is_nil() ? unit : before;
                project.insert(relation);
                before = unit;
            }
        });
        if (write(pipe, "x", 1) != 1) _exit(1);
    }
}

std::size_t acknowledged_until_kill(const std::filesystem::path& file, std::mt19937& random) {
    std::array<int, 2> ends{};
    REQUIRE(pipe(ends.data()) == 0);
    const std::uint64_t seed = random();
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        import_until_killed(file, ends[1], seed);
    }
    close(ends[1]);
    // Some rounds die before the first change ends, some inside the second or third, however slow the machine is.
    std::size_t acknowledged = 0;
    std::array<char, 256> buffer{};
    for (std::size_t awaited = random() % 3; acknowledged < awaited;) {
        if (read(ends[0], buffer.data(), 1) != 1) break;
        ++acknowledged;
    }
    usleep(static_cast<useconds_t>(random() % 40'000));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    for (ssize_t got = read(ends[0], buffer.data(), buffer.size()); got > 0;
         got = read(ends[0], buffer.data(), buffer.size())) {
        acknowledged += static_cast<std::size_t>(got);
    }
    close(ends[0]);
    return acknowledged;
}

} // namespace

void kill_during_imports(int rounds) {
    const TemporaryFolder folder;
    TestEnvironment environment;
    const auto file = folder / "site.gpkg";
    (void)ProjectFile::create(file, some_settings(), environment.get());
    std::mt19937 random(4711);
    std::size_t changes = 0;
    for (int round = 0; round < rounds; ++round) {
        INFO("round " << round);
        const std::size_t acknowledged = acknowledged_until_kill(file, random);
        const OpenMode mode = round % 2 == 0 ? OpenMode::ReadOnly : OpenMode::ReadWrite;
        const ProjectFile project = ProjectFile::open(file, mode, environment.get());
        const std::size_t there = project.history(1'000'000).size();
        CHECK(there >= changes + acknowledged);
        CHECK(there <= changes + acknowledged + 1);
        const model::Record record = project.load();
        CHECK(record.units.size() == there * kUnitsAChange);
        CHECK(record.relations.size() == there * kUnitsAChange);
        if (round % 10 == 9) CHECK(project.verify(Progress::none()).empty());
        changes = there;
    }
    CHECK(changes > 0);
}

} // namespace planum::test
