// SPDX-License-Identifier: MIT
// A file that says it is a project: opened for reading and for writing, loaded, verified, undone.
#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/base/clock.hpp"
#include "core/base/error.hpp"
#include "core/base/uuid.hpp"
#include "core/store/project_file.hpp"

namespace {

using namespace planum;
using namespace planum::store;

// In memory where that exists: the disk would be most of the time.
std::filesystem::path scratch_file() {
    static const std::filesystem::path file = [] {
        const std::filesystem::path memory = "/dev/shm";
        const auto folder = std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path();
        return folder / ("planum-fuzz-" + std::to_string(getpid()) + ".gpkg");
    }();
    return file;
}

void write_input(const std::filesystem::path& file, const std::uint8_t* data, std::size_t size) {
    const int handle = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (handle < 0) std::abort();
    std::size_t at = 0;
    while (at < size) {
        const ssize_t written = ::write(handle, data + at, size - at);
        if (written <= 0) std::abort();
        at += static_cast<std::size_t>(written);
    }
    ::close(handle);
}

template<class Work>
void expect_error_at_most(Work work) {
    try {
        work();
    } catch (const Error&) {
        // Refused in a sentence, which is what is wanted.
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const FixedClock clock("2025-06-01T12:00:00.000Z");
    SeededUuids uuids(1);
    const Environment environment{&clock, &uuids, "fuzz"};
    const std::filesystem::path file = scratch_file();
    write_input(file, data, size);
    expect_error_at_most([&] {
        const ProjectFile project = ProjectFile::open(file, OpenMode::ReadOnly, environment);
        (void)project.canonical_dump();
        (void)project.verify(Progress::none());
    });
    expect_error_at_most([&] {
        ProjectFile project = ProjectFile::open(file, OpenMode::ReadWrite, environment);
        (void)project.log(std::nullopt, 10);
        (void)project.undo();
        (void)project.load();
    });
    for (const char* ending : {"", "-journal", "-wal", "-shm"}) {
        std::error_code ignored;
        std::filesystem::remove(file.string() + ending, ignored);
    }
    return 0;
}
