// SPDX-License-Identifier: MIT
#include <algorithm>

#include "fuzz/scan_target.hpp"
#include "scans/formats/crc32c.hpp"

namespace {

constexpr std::size_t kPayload = 1020;

// The input is the file without its checksums: with them no change would get past the first page.
std::string with_checksums(std::string logical) {
    logical.resize((logical.size() + kPayload - 1) / kPayload * kPayload, '\0');
    const std::uint64_t length = logical.size() / kPayload * (kPayload + 4);
    for (std::size_t i = 0; i < 8; ++i) logical[16 + i] = static_cast<char>(length >> (8 * i));
    for (std::size_t i = 0; i < 8; ++i) logical[40 + i] = static_cast<char>(i == 1 ? 4 : 0); // 1024
    std::string file;
    for (std::size_t at = 0; at < logical.size(); at += kPayload) {
        file.append(logical, at, kPayload);
        const std::uint32_t crc = planum::scans::crc32c({logical.data() + at, kPayload});
        for (int shift = 24; shift >= 0; shift -= 8) file.push_back(static_cast<char>(crc >> shift));
    }
    return file;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    planum::fuzz::read_everything(bytes, planum::scans::ScanFormat::E57);
    if (size >= 48) planum::fuzz::read_everything(with_checksums(bytes), planum::scans::ScanFormat::E57);
    return 0;
}
