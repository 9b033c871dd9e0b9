// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.hpp"
#include "scans/formats/byte_source.hpp"

namespace planum::scans {

/// Walks over the lines of a text in windows of fixed size.
///
/// Invariant: begin() … end() is the current line without its end (LF or CR LF), and *end() may be
/// read and is no part of a number.
class LineReader {
  public:
    /// Starts at byte `offset`, whose line has the number `first_line`. A small `window` [bytes] is for
    /// who needs a few lines only.
    explicit LineReader(const ByteSource& source, std::uint64_t offset = 0, std::uint64_t first_line = 1,
                        std::uint64_t window = 1U << 20U);

    /// Goes to the next line; false when there is none. Throws BadInput for a line over kLongest.
    bool next();

    /// Skips lines, quicker than reading them; returns how many there were.
    std::uint64_t skip(std::uint64_t lines);

    [[nodiscard]] const char* begin() const noexcept { return line_; }

    [[nodiscard]] const char* end() const noexcept { return line_end_; }

    [[nodiscard]] std::string_view line() const noexcept {
        return {line_, static_cast<std::size_t>(line_end_ - line_)};
    }

    /// Number of the current line, from 1.
    [[nodiscard]] std::uint64_t number() const noexcept { return number_; }

    /// Where the line after the current one starts.
    [[nodiscard]] std::uint64_t offset() const noexcept {
        return window_offset_ + static_cast<std::uint64_t>(next_ - buffer_.data());
    }

    /// BadInput `line 12: …`.
    [[noreturn]] void fail(std::string_view message) const;

    static constexpr std::size_t kLongest = 65536; ///< bytes in a line

  private:
    bool refill();

    const ByteSource* source_;
    std::vector<char> buffer_;
    std::uint64_t window_offset_; ///< file offset of buffer_[0]
    std::uint64_t read_to_;       ///< file offset behind what was read
    std::uint64_t number_;
    const char* line_ = nullptr;
    const char* line_end_ = nullptr;
    const char* next_ = nullptr;
    const char* filled_ = nullptr;
};

} // namespace planum::scans
