// SPDX-License-Identifier: MIT
#include "fuzz/scan_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using planum::scans::ScanFormat;
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    // The pose stands behind the first zero byte.
    const std::size_t cut = bytes.find(static_cast<char>(0));
    if (cut == std::string::npos) {
        planum::fuzz::read_everything(bytes, ScanFormat::ThreeDtk);
    } else {
        planum::fuzz::read_everything(bytes.substr(0, cut), ScanFormat::ThreeDtk, bytes.substr(cut + 1));
    }
    return 0;
}
