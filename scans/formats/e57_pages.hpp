// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scans/formats/byte_source.hpp"

namespace planum::scans {

/// The 48 bytes at the start of an E57 file, checked.
struct E57FileHeader {
    std::uint64_t file_length = 0;  ///< [bytes]
    std::uint64_t xml_offset = 0;   ///< physical
    std::uint64_t xml_length = 0;   ///< logical
    std::uint64_t page_size = 1024; ///< [bytes], with checksum
};

/// An E57 file without its checksums: pages of payload and 4 bytes CRC-32C. Every page is verified
/// before any of its bytes is given out. "Physical" offsets count the checksums, "logical" ones do not.
class E57Pages {
  public:
    /// Reads the header. Throws BadInput when the file is none, is of another version, or its length
    /// is not what the header says.
    explicit E57Pages(const ByteSource& source);

    [[nodiscard]] const E57FileHeader& header() const noexcept { return header_; }

    [[nodiscard]] std::uint64_t logical_size() const noexcept { return pages_ * payload_; }

    /// Throws BadInput for an offset beyond the end or inside a checksum.
    [[nodiscard]] std::uint64_t logical_of(std::uint64_t physical) const;

    /// Fills `out`. Throws BadInput that names the page for a wrong checksum, and when it reaches
    /// beyond the end.
    void read(std::uint64_t logical, std::span<char> out) const;

    [[nodiscard]] std::string read_string(std::uint64_t logical, std::uint64_t count) const;

  private:
    void load(std::uint64_t first_page) const;

    const ByteSource* source_;
    E57FileHeader header_;
    std::uint64_t payload_ = 1020;
    std::uint64_t pages_ = 0;
    // The window of verified pages that was read last; checksums are squeezed out in place.
    mutable std::vector<char> window_;
    mutable std::uint64_t window_page_ = 0;
    mutable std::uint64_t window_pages_ = 0;
};

/// Little-endian numbers out of bytes.
template<class T>
[[nodiscard]] T little_endian(const char* bytes) noexcept {
    T value = 0;
    for (std::size_t i = sizeof(T); i-- > 0;) {
        value =
            static_cast<T>(static_cast<T>(value << 7U << 1U) | static_cast<T>(static_cast<unsigned char>(bytes[i])));
    }
    return value;
}

} // namespace planum::scans
