// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/store/project_file.hpp"
#include "tests/support/temporary.hpp"

namespace planum::test {

/// Clock and ids that repeat themselves.
struct TestEnvironment {
    FixedClock clock{"2025-06-01T12:00:00.000Z"};
    SeededUuids uuids{7};

    explicit TestEnvironment(std::uint64_t seed = 7) : uuids(seed) {}

    [[nodiscard]] store::Environment get(std::string author = "Ada") { return {&clock, &uuids, std::move(author)}; }
};

[[nodiscard]] model::ProjectSettings some_settings();
[[nodiscard]] model::StratigraphicUnit a_unit(std::string number, model::AreaId area = {});

/// A project in which every record table holds something, every optional member set somewhere; two changes.
[[nodiscard]] store::ProjectFile fill_project(const std::filesystem::path& file, TestEnvironment& environment);

/// All rows of all record tables as they stand, deleted ones too; for comparing two moments of one file.
[[nodiscard]] std::string raw_rows(const std::filesystem::path& file);

/// The message of the Error that `work` throws; "nothing was thrown" otherwise.
template<class Work>
[[nodiscard]] std::string message_of(Work work) {
    try {
        work();
    } catch (const std::exception& e) {
        return e.what();
    }
    return "nothing was thrown";
}

} // namespace planum::test
