// SPDX-License-Identifier: MIT
#include "strat/exchange/reader.hpp"

#include <fstream>
#include <set>

#include "core/base/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary.hpp"
#include "tests/unit/strat_exchange/support.hpp"

using namespace planum;
using namespace planum::strat;
using Catch::Matchers::Contains;

namespace {

std::string failure(const std::vector<InputFile>& files, std::string_view format = {}) {
    try {
        (void)plan_reading(files, format);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

} // namespace

TEST_CASE("Every reader has a name of its own") {
    std::set<std::string_view> names;
    for (const Reader& reader : all_readers()) {
        CHECK(names.insert(reader.format).second);
        CHECK_FALSE(reader.title.empty());
    }
}

TEST_CASE("A file that no reader knows is named, with what was looked for") {
    const std::string message = failure({test::a_file("x.lst", "t\n\nName\n1\n  below: 2\n"),
                                         test::a_file("letter.txt", "Dear all,\nthe trench is flooded.\n")});
    CHECK_THAT(message, Contains("letter.txt: not recognised") && Contains("lst") && Contains("--format"));
    CHECK_THAT(failure({test::a_file("empty.csv", "")}), Contains("empty.csv: the file is empty"));
}

TEST_CASE("An unknown format is a usage error that lists the formats") {
    CHECK_THAT(failure({test::a_file("a.lst", "x")}, "wordstar"), Contains("no format wordstar") && Contains("lst"));
}

TEST_CASE("A named format takes all files") {
    const std::vector files = {test::a_file("a", "t\n\nName\n1\n  below: 2\n"), test::a_file("b", "t\n\nName\n3\n")};
    const auto plan = plan_reading(files, "lst");
    REQUIRE(plan.size() == 1);
    CHECK(plan[0].files == std::vector<std::size_t>{0, 1});
}

TEST_CASE("A file larger than a record may be is refused before it is read") {
    const test::TemporaryFolder folder;
    const auto path = folder.write("long.csv", "unit,title\n");
    std::filesystem::resize_file(path, 1U << 30U); // sparse: a line of 1 GB
    try {
        (void)load_input_file(path);
        FAIL("a 1 GB line was read");
    } catch (const Error& error) {
        CHECK(error.code() == ErrorCode::BadInput);
        CHECK_THAT(error.what(), Contains("long.csv") && Contains("MB") && Contains("split it"));
    }
}

TEST_CASE("An endless line is refused by file and line before it is decoded") {
    const test::TemporaryFolder folder;
    const std::string endless((16U << 20U) + 1, 'a');
    const auto refusal = [&](const std::string& name, const std::string& bytes) -> std::string {
        try {
            (void)load_input_file(folder.write(name, bytes));
        } catch (const Error& error) {
            CHECK(error.code() == ErrorCode::BadInput);
            return error.what();
        }
        return {};
    };
    CHECK_THAT(refusal("a.csv", "unit,title\n1,b\n2," + endless + "\n"), Contains("a.csv: line 3: a line of 16 MB"));
    CHECK_THAT(refusal("b.lst", "t\n\nName\n" + endless), Contains("b.lst: line 4: a line"));
    CHECK_THAT(refusal("c.json", "{\"units\":\n[\"" + endless + "\"]}"), Contains("c.json: line 2: a value"));
    CHECK_THAT(refusal("d.graphml", "<graphml>" + endless + "</graphml>"), Contains("d.graphml: line 1: a value"));
    std::string one_line = "[";
    while (one_line.size() < endless.size()) one_line += "\"a\",";
    CHECK(refusal("e.json", one_line + "1]").empty());
    CHECK(refusal("f.csv", "unit,title\n1," + endless.substr(3) + "\n").empty());
}

TEST_CASE("A database is known by its header and left on disk") {
    const test::TemporaryFolder folder;
    const auto path = folder.write("a.bin", std::string_view{"SQLite format 3\0 and more", 25});
    const InputFile file = load_input_file(path);
    CHECK(file.is_database);
    CHECK(file.bytes.empty());
    CHECK(file.name == "a.bin");
}
