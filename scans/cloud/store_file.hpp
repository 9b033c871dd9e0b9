// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace planum::scans {

/// A file that is written under a temporary name and only gets its own when it is complete; until then,
/// and whenever something fails, there is nothing or the old file.
class StoreFile {
  public:
    /// Throws Io when it cannot be made.
    explicit StoreFile(std::filesystem::path target);
    StoreFile(const StoreFile&) = delete;
    StoreFile& operator=(const StoreFile&) = delete;
    ~StoreFile(); ///< without commit: removes what was written

    /// Appends; throws Io, which names the file (disk full).
    void append(std::span<const char> bytes);

    /// How much was appended so far [bytes].
    [[nodiscard]] std::uint64_t size() const noexcept { return size_; }

    /// Writes over the first bytes, brings all to disk, renames.
    void commit(std::span<const char> head);

  private:
    void flush();
    void write_at(std::uint64_t at, std::span<const char> bytes);

    std::filesystem::path target_;
    std::filesystem::path temporary_;
    int descriptor_ = -1;
    std::vector<char> buffer_;
    std::uint64_t size_ = 0;
    std::uint64_t flushed_ = 0;
};

} // namespace planum::scans
