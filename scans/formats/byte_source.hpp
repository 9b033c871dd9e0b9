// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace planum::scans {

/// Bytes of known number that can be read from any place: a file, or memory in tests.
///
/// Originals are read, not mapped: a stick that is pulled out must be an Error, and a mapped page
/// that cannot be read kills the program.
class ByteSource {
  public:
    ByteSource() = default;
    ByteSource(const ByteSource&) = delete;
    ByteSource& operator=(const ByteSource&) = delete;
    virtual ~ByteSource() = default;

    [[nodiscard]] virtual std::uint64_t size() const noexcept = 0;

    /// Fills `out` with the bytes from `offset`. Throws BadInput when they reach beyond the end, Io
    /// when the disk fails.
    virtual void read(std::uint64_t offset, std::span<char> out) const = 0;

    /// `count` bytes from `offset`, as above; checked against the size before anything is allocated.
    [[nodiscard]] std::string read_string(std::uint64_t offset, std::uint64_t count) const;
};

/// An ordinary file, opened read-only. Throws NotFound, BadInput (no ordinary file) or Io.
[[nodiscard]] std::unique_ptr<ByteSource> open_file_source(const std::filesystem::path& file);

/// Bytes in memory; owned.
[[nodiscard]] std::unique_ptr<ByteSource> memory_source(std::string bytes);

} // namespace planum::scans
