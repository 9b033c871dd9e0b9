// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/error.hpp"
#include "strat/exchange/readers.hpp"

// hm goes by file names too, so they belong to the input: a line `=== NAME` begins the next file.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    std::string_view bytes(reinterpret_cast<const char*>(data), size);
    std::vector<planum::strat::InputFile> files;
    std::string_view name = "contexts.csv";
    while (true) {
        const std::size_t mark = files.size() < 8 ? bytes.find("\n=== ") : std::string_view::npos;
        planum::strat::InputFile& file = files.emplace_back();
        file.name = name;
        file.path = file.name;
        file.bytes = bytes.substr(0, mark);
        if (mark == std::string_view::npos) break;
        bytes.remove_prefix(mark + 5);
        const std::size_t end = bytes.find('\n');
        name = bytes.substr(0, end);
        bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end);
    }
    const planum::strat::Reader& reader = planum::strat::hm_tables_reader();
    for (const std::size_t file : reader.recognise(files).files) {
        if (file >= files.size()) __builtin_trap();
    }
    std::vector<const planum::strat::InputFile*> pointers;
    for (const planum::strat::InputFile& file : files) pointers.push_back(&file);
    try {
        (void)reader.read(pointers, {}, planum::Progress::none());
    } catch (const planum::Error&) {
        return 0;
    }
    return 0;
}
