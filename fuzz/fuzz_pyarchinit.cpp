// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "fuzz/reader_fuzz.hpp"
#include "strat/exchange/readers.hpp"

namespace {

// Databases are opened by path: one file for each process.
void try_database(std::string_view bytes) {
    using namespace planum;
    const auto path = std::filesystem::temp_directory_path() / ("planum-fuzz-" + std::to_string(getpid()) + ".db");
    {
        std::ofstream out(path, std::ios::binary | std::ios::trunc);
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }
    const strat::InputFile file = strat::load_input_file(path);
    const strat::InputFile* const files[] = {&file};
    static_cast<void>(strat::pyarchinit_reader().recognise(std::span(&file, 1)));
    try {
        static_cast<void>(strat::pyarchinit_reader().read(files, {}, Progress::none()));
    } catch (const Error&) {
        return;
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    if (bytes.starts_with("SQLite format 3")) {
        try_database(bytes);
        return 0;
    }
    return planum::fuzz::try_reader(planum::strat::pyarchinit_reader(), data, size, ".csv");
}
