// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace planum::scans {

enum class E57Kind { Integer, ScaledInteger, Float, Double, String };

/// One element of a prototype: how its values stand in the byte stream.
struct E57Field {
    std::string name; ///< with prefix, as `nor:normalX`
    E57Kind kind = E57Kind::Integer;
    std::int64_t minimum = 0; ///< of the raw integer
    std::int64_t maximum = 0;
    double scale = 1.0;
    double offset = 0.0;
    unsigned bits = 0; ///< per record; 0: constant, or text

    /// Value of a raw integer.
    [[nodiscard]] double scaled(std::int64_t raw) const noexcept { return static_cast<double>(raw) * scale + offset; }
};

/// One field's byte stream, put together from the pieces in the packets, and read as whole records.
class E57Stream {
  public:
    explicit E57Stream(E57Field field) : field_(std::move(field)) {}

    [[nodiscard]] const E57Field& field() const noexcept { return field_; }

    /// Room for `count` further bytes, to be filled at once by the caller.
    [[nodiscard]] char* append(std::size_t count);

    /// How many whole records can be read now; at most `wanted`.
    [[nodiscard]] std::uint64_t available(std::uint64_t wanted) const;

    /// Takes `count` ≤ available() records as values in the file's unit (scaled), as raw integers, or
    /// skips them. Text counts as 0.
    void take_values(double* out, std::size_t count);
    void take_integers(std::int64_t* out, std::size_t count);
    void skip(std::size_t count);

    /// Bytes waiting to be read.
    [[nodiscard]] std::size_t waiting() const noexcept { return filled_ - static_cast<std::size_t>(bit_ / 8U); }

  private:
    [[nodiscard]] std::uint64_t count_texts(std::uint64_t wanted) const;
    [[nodiscard]] std::size_t text_end(std::size_t at) const;
    void skip_texts(std::size_t count);

    E57Field field_;
    std::vector<char> bytes_; ///< always 16 more than filled_, so that a word may be read at any place
    std::size_t filled_ = 0;
    std::uint64_t bit_ = 0; ///< where the next record starts in bytes_
};

} // namespace planum::scans
