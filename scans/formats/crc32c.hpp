// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

namespace planum::scans {

/// CRC-32C (Castagnoli, reflected polynomial 0x82F63B78, start and final xor all ones), with the
/// processor's instruction where it has one.
[[nodiscard]] std::uint32_t crc32c(std::span<const char> bytes) noexcept;

/// The same from tables alone; the oracle for the instruction, and what other processors use.
[[nodiscard]] std::uint32_t crc32c_by_table(std::span<const char> bytes) noexcept;

} // namespace planum::scans
