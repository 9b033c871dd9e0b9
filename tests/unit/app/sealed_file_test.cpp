// SPDX-License-Identifier: MIT
#include "app/project/sealed_file.hpp"

#include <fstream>
#include <string>

#include "core/base/file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;

TEST_CASE("A sealed file gives back what was written, and nothing once any byte of it changed") {
    const test::TemporaryFolder folder;
    const auto file = folder / "below/two/a.grid";
    CHECK_FALSE(app::read_sealed(file));
    const std::string content("some\0thing\n", 11);
    app::write_sealed(file, content);
    CHECK(app::read_sealed(file) == content);
    const std::string bytes = read_file(file, 1000);
    for (std::size_t i = 0; i <= bytes.size(); ++i) {
        std::string damaged = bytes;
        if (i < bytes.size()) {
            damaged[i] = static_cast<char>(damaged[i] ^ 1);
        } else {
            damaged.resize(bytes.size() - 1);
        }
        std::ofstream(file, std::ios::binary) << damaged;
        INFO(i);
        CHECK_FALSE(app::read_sealed(file));
    }
}

TEST_CASE("Where nothing can be written a cache is done without") {
    const test::TemporaryFolder folder;
    const auto in_the_way = folder.write("taken", "a file, no folder");
    app::write_sealed(in_the_way / "a.grid", "content");
    CHECK_FALSE(app::read_sealed(in_the_way / "a.grid"));
    CHECK(read_file(in_the_way, 100) == "a file, no folder");
}
