// SPDX-License-Identifier: MIT
#include "fuzz/reader_fuzz.hpp"
#include "strat/exchange/readers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    return planum::fuzz::try_reader(planum::strat::planum_csv_reader(), data, size, ".csv");
}
