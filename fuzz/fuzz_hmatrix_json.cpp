// SPDX-License-Identifier: MIT
#include "fuzz/reader_fuzz.hpp"
#include "strat/exchange/readers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return planum::fuzz::try_reader(planum::strat::hmatrix_json_reader(), data, size, ".json");
}
