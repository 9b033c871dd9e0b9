// SPDX-License-Identifier: MIT
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include <rapidcheck.h>

#include "tests/property/core_store/random_change.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/core_store/filled_project.cpp"

using namespace planum;
using namespace planum::store;

namespace {

struct Seen {
    std::string dump;
    std::string rows;
    std::size_t changes = 0; ///< that are not undone

    friend bool operator==(const Seen&, const Seen&) = default;
};

Seen look(const std::filesystem::path& file) {
    test::TestEnvironment environment;
    const ProjectFile project = ProjectFile::open(file, OpenMode::ReadOnly, environment.get());
    Seen seen{project.canonical_dump(), test::raw_rows(file), 0};
    for (const ChangeEntry& entry : project.history(1000)) seen.changes += entry.undone ? 0 : 1;
    return seen;
}

/// Undoes or redoes in another process; true when that went well.
bool in_another_process(const std::filesystem::path& file, ChangeEntry (ProjectFile::*step)()) {
    const pid_t child = fork();
    if (child == 0) {
        int status = 1;
        try {
            test::TestEnvironment environment(3);
            ProjectFile project = ProjectFile::open(file, OpenMode::ReadWrite, environment.get("other"));
            (void)(project.*step)();
            status = 0;
        } catch (const std::exception& e) {
            dprintf(STDERR_FILENO, "%s\n", e.what());
        }
        _exit(status);
    }
    int status = -1;
    waitpid(child, &status, 0);
    return status == 0;
}

} // namespace

TEST_CASE("Undo after do, and redo after undo, are nothing at all, whoever does them") {
    // Every case starts a dozen processes and waits for the disk: fewer cases than usual, unless somebody asks.
    setenv("RC_PARAMS", "max_success=4", 0);
    const bool holds = rc::check("undo and redo by another process", [](std::uint64_t id_seed) {
        const auto seeds = *rc::gen::container<std::vector<std::uint32_t>>(6, rc::gen::arbitrary<std::uint32_t>());
        const test::TemporaryFolder folder;
        const auto file = folder / "site.gpkg";
        test::TestEnvironment environment(id_seed);
        (void)ProjectFile::create(file, test::some_settings(), environment.get());
        std::vector<Seen> states{look(file)};
        for (std::size_t i = 0; i < seeds.size(); ++i) {
            {
                ProjectFile project = ProjectFile::open(file, OpenMode::ReadWrite, environment.get());
                // Equal seeds would add two things of one name, which the project refuses rightly.
                test::make_random_change(project, seeds[i] * 6U + static_cast<std::uint32_t>(i));
            }
            Seen now = look(file);
            if (now.changes > states.back().changes) states.push_back(std::move(now));
        }
        for (std::size_t i = states.size() - 1; i > 0; --i) {
            RC_ASSERT(in_another_process(file, &ProjectFile::undo));
            RC_ASSERT(look(file) == states[i - 1]);
        }
        for (std::size_t i = 1; i < states.size(); ++i) {
            RC_ASSERT(in_another_process(file, &ProjectFile::redo));
            RC_ASSERT(look(file) == states[i]);
        }
        const ProjectFile project = ProjectFile::open(file, OpenMode::ReadOnly, environment.get());
        for (const VerifyProblem& problem : project.verify(Progress::none()))
            RC_FAIL(problem.where + ": " + problem.what);
    });
    CHECK(holds);
}
