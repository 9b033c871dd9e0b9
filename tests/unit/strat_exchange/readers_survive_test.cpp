// SPDX-License-Identifier: MIT
// Every reader, whatever it is given, answers with a record or with a sentence.
#include <algorithm>
#include <array>
#include <set>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strat_exchange/support.hpp"

using namespace planum;
using namespace planum::strat;

namespace {

// True when it was read or refused with BadInput and the file's name; anything else fails the test.
void read_or_refuse(const Reader& reader, const InputFile& file) {
    const std::array<const InputFile*, 1> files = {&file};
    try {
        (void)reader.recognise({&file, 1});
        const auto read = reader.read(files, {}, Progress::none());
        for (const ReadNote& note : read.diagnostics) {
            if (!text::is_valid_utf8(note.message) || !text::is_valid_utf8(note.raw_text)) FAIL("note is no UTF-8");
        }
    } catch (const Error& error) {
        if (error.code() != ErrorCode::BadInput) FAIL(reader.format << ": " << error.what());
        if (std::string_view{error.what()}.find(file.name) == std::string_view::npos) {
            FAIL(reader.format << " does not name the file: " << error.what());
        }
    }
}

} // namespace

TEST_CASE("Samples are taken for their format") {
    for (const auto& [format, files] : test::all_samples()) {
        INFO(format);
        std::set<std::string> formats;
        for (const Reading& reading : plan_reading(files, {})) formats.insert(std::string{reading.reader->format});
        CHECK(formats == std::set<std::string>{format});
    }
}

TEST_CASE("Every reader survives every sample of every format, cut off at every byte") {
    for (const auto& [format, files] : test::all_samples()) {
        for (const InputFile& whole : files) {
            if (whole.is_database) continue;
            for (const Reader& reader : all_readers()) {
                const bool own = reader.format == format;
                const std::size_t step = own ? 1 + whole.bytes.size() / 4000 : 1 + whole.bytes.size() / 40;
                for (std::size_t end = 0; end <= whole.bytes.size(); end += step) {
                    read_or_refuse(reader, test::a_file(whole.name, std::string_view{whole.bytes}.substr(0, end)));
                }
            }
        }
    }
    SUCCEED();
}

TEST_CASE("Every reader survives binary, wrong encodings and long lines") {
    std::string binary;
    for (int i = 0; i < 4096; ++i) binary.push_back(static_cast<char>((i * 7919) >> 3));
    const std::string utf16 = std::string{"\xFF\xFE"} + std::string("u\0n\0i\0t\0,\0a\0\n\0"
                                                                    "1\0,\0x\0\0\xD8",
                                                                    22);
    const std::string long_line(2'000'000, 'a');
    const std::string long_row = "unit,relation,other\n1,covers," + std::string(2'000'000, ',');
    const std::string open_quotes = "unit,title\n" + std::string(500'000, '"') + "\n1,\"\n";
    for (const Reader& reader : all_readers()) {
        for (const std::string& bytes : {binary, utf16, long_line, long_row, open_quotes, std::string{"\n\n\n"},
                                         std::string{"\0\0\0\0", 4}, std::string{"\xFF\xFF\xFE,\xC3"}}) {
            for (const std::string_view name : {"a.csv", "a.lst", "a.xml", "a.json", "a.hmcx", "a.ini"}) {
                read_or_refuse(reader, test::a_file(name, bytes));
            }
        }
    }
    SUCCEED();
}

TEST_CASE("Samples in another encoding give the same record") {
    for (const auto& [format, files] : test::all_samples()) {
        if (format == "hmcx" || files.front().is_database) continue;
        INFO(format);
        std::vector<InputFile> wide;
        for (const InputFile& file : files) {
            std::string bytes = "\xFF\xFE";
            const bool ascii =
                std::all_of(file.bytes.begin(), file.bytes.end(), [](char c) { return (c & 0x80) == 0; });
            if (ascii) {
                for (const char c : file.bytes) bytes += {c, '\0'};
            }
            wide.push_back(test::a_file(file.name, ascii ? bytes : file.bytes));
        }
        CHECK(test::relations_of(test::read_all(files, format).values) ==
              test::relations_of(test::read_all(wide, format).values));
    }
}
