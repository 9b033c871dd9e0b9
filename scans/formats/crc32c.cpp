// SPDX-License-Identifier: MIT
#include "scans/formats/crc32c.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

#if defined(__x86_64__)
#include <nmmintrin.h>
#endif

namespace planum::scans {

namespace {

using Tables = std::array<std::array<std::uint32_t, 256>, 8>;

// Table k advances a byte by k further zero bytes ("slicing by eight", Kounavis and Berry 2005).
constexpr Tables make_tables() {
    Tables tables{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t crc = byte;
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0x82F63B78U : 0U);
        tables[0][byte] = crc;
    }
    for (std::size_t k = 1; k < 8; ++k) {
        for (std::size_t byte = 0; byte < 256; ++byte) {
            const std::uint32_t before = tables[k - 1][byte];
            tables[k][byte] = (before >> 8U) ^ tables[0][before & 0xFFU];
        }
    }
    return tables;
}

constexpr Tables kTables = make_tables();

#if defined(__x86_64__)
__attribute__((target("sse4.2"))) std::uint32_t crc32c_by_instruction(std::span<const char> bytes) noexcept {
    std::uint64_t crc = 0xFFFFFFFFU;
    const char* p = bytes.data();
    std::size_t left = bytes.size();
    for (; left >= 8; left -= 8, p += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, p, 8);
        crc = _mm_crc32_u64(crc, word);
    }
    auto short_crc = static_cast<std::uint32_t>(crc);
    for (; left > 0; --left, ++p) short_crc = _mm_crc32_u8(short_crc, static_cast<unsigned char>(*p));
    return ~short_crc;
}
#endif

} // namespace

std::uint32_t crc32c_by_table(std::span<const char> bytes) noexcept {
    std::uint32_t crc = 0xFFFFFFFFU;
    const char* p = bytes.data();
    std::size_t left = bytes.size();
    if constexpr (std::endian::native == std::endian::little) {
        for (; left >= 8; left -= 8, p += 8) {
            std::uint64_t word = 0;
            std::memcpy(&word, p, 8);
            word ^= crc;
            crc = 0;
            for (std::size_t k = 0; k < 8; ++k) crc ^= kTables[7 - k][(word >> (8U * k)) & 0xFFU];
        }
    }
    for (; left > 0; --left, ++p) crc = (crc >> 8U) ^ kTables[0][(crc ^ static_cast<unsigned char>(*p)) & 0xFFU];
    return ~crc;
}

std::uint32_t crc32c(std::span<const char> bytes) noexcept {
#if defined(__x86_64__)
    static const bool has_instruction = __builtin_cpu_supports("sse4.2") != 0;
    if (has_instruction) return crc32c_by_instruction(bytes);
#endif
    return crc32c_by_table(bytes);
}

} // namespace planum::scans
