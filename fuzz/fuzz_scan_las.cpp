// SPDX-License-Identifier: MIT
#include "fuzz/scan_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using planum::scans::ScanFormat;
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    planum::fuzz::read_everything(bytes, ScanFormat::Las);
    return 0;
}
