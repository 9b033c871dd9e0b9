// SPDX-License-Identifier: MIT
#include "scans/formats/e57_fields.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "scans/formats/e57_pages.hpp"

namespace planum::scans {

namespace {

static_assert(std::endian::native == std::endian::little, "E57 streams are read as little-endian words");

constexpr std::size_t kSlack = 16;

std::uint64_t load_word(const char* at) noexcept {
    std::uint64_t word = 0;
    std::memcpy(&word, at, sizeof word);
    return word;
}

// The `bits` wide number at `bit`, LSB first. A field over 57 bits may touch nine bytes.
std::uint64_t load_bits(const char* bytes, std::uint64_t bit, unsigned bits, std::uint64_t mask) noexcept {
    const char* at = bytes + bit / 8U;
    const unsigned shift = static_cast<unsigned>(bit % 8U);
    std::uint64_t value = load_word(at) >> shift;
    if (shift + bits > 64U) value |= static_cast<std::uint64_t>(static_cast<unsigned char>(at[8])) << (64U - shift);
    return value & mask;
}

std::uint64_t mask_of(unsigned bits) noexcept { return bits >= 64U ? ~0ULL : (1ULL << bits) - 1U; }

// Calls `emit(i, raw)` for each of the next numbers; the narrow case is kept free of branches.
template<class Emit>
void unpack(const char* bytes, std::uint64_t bit, unsigned bits, std::size_t count, Emit emit) {
    const std::uint64_t mask = mask_of(bits);
    if (bits <= 56U) {
        for (std::size_t i = 0; i < count; ++i, bit += bits)
            emit(i, (load_word(bytes + bit / 8U) >> (bit % 8U)) & mask);
        return;
    }
    for (std::size_t i = 0; i < count; ++i, bit += bits) emit(i, load_bits(bytes, bit, bits, mask));
}

// minimum + raw without signed overflow: a range may span all 64 bits.
std::int64_t offset_by(std::int64_t minimum, std::uint64_t raw) noexcept {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(minimum) + raw);
}

} // namespace

char* E57Stream::append(std::size_t count) {
    const auto used = static_cast<std::size_t>(bit_ / 8U);
    // Moving only once half of it is used up keeps the work linear where one field runs far ahead.
    if (used > filled_ / 2) {
        std::memmove(bytes_.data(), bytes_.data() + used, filled_ - used);
        filled_ -= used;
        bit_ %= 8U;
    }
    if (bytes_.size() < filled_ + count + kSlack) bytes_.resize(filled_ + count + kSlack);
    char* room = bytes_.data() + filled_;
    filled_ += count;
    return room;
}

std::uint64_t E57Stream::available(std::uint64_t wanted) const {
    if (field_.kind == E57Kind::String) return count_texts(wanted);
    if (field_.bits == 0) return wanted;
    return std::min(wanted, (static_cast<std::uint64_t>(filled_) * 8U - bit_) / field_.bits);
}

void E57Stream::take_values(double* out, std::size_t count) {
    const char* bytes = bytes_.data();
    switch (field_.kind) {
    case E57Kind::Integer:
    case E57Kind::ScaledInteger: {
        const std::int64_t minimum = field_.minimum;
        const double scale = field_.scale;
        const double offset = field_.offset;
        if (field_.bits == 0) {
            std::fill_n(out, count, field_.scaled(minimum));
            break;
        }
        unpack(bytes, bit_, field_.bits, count, [=](std::size_t i, std::uint64_t raw) {
            out[i] = static_cast<double>(offset_by(minimum, raw)) * scale + offset;
        });
        break;
    }
    case E57Kind::Float:
        for (std::size_t i = 0; i < count; ++i) {
            float value = 0.0F;
            std::memcpy(&value, bytes + bit_ / 8U + i * 4U, sizeof value);
            out[i] = static_cast<double>(value);
        }
        break;
    case E57Kind::Double: std::memcpy(out, bytes + bit_ / 8U, count * sizeof(double)); break;
    case E57Kind::String:
        std::fill_n(out, count, 0.0);
        skip_texts(count);
        return;
    }
    bit_ += static_cast<std::uint64_t>(field_.bits) * count;
}

void E57Stream::take_integers(std::int64_t* out, std::size_t count) {
    if (field_.kind == E57Kind::Integer || field_.kind == E57Kind::ScaledInteger) {
        const std::int64_t minimum = field_.minimum;
        if (field_.bits == 0) {
            std::fill_n(out, count, minimum);
            return;
        }
        unpack(bytes_.data(), bit_, field_.bits, count,
               [=](std::size_t i, std::uint64_t raw) { out[i] = offset_by(minimum, raw); });
        bit_ += static_cast<std::uint64_t>(field_.bits) * count;
        return;
    }
    // Some programs write states and indexes as floating point.
    std::vector<double> values(count);
    take_values(values.data(), count);
    for (std::size_t i = 0; i < count; ++i) {
        const bool fits = values[i] > -9e18 && values[i] < 9e18;
        out[i] = fits ? static_cast<std::int64_t>(values[i]) : 0;
    }
}

void E57Stream::skip(std::size_t count) {
    if (field_.kind == E57Kind::String) {
        skip_texts(count);
        return;
    }
    bit_ += static_cast<std::uint64_t>(field_.bits) * count;
}

// Where the text that starts at byte `at` ends; beyond filled_ when it is not complete yet.
std::size_t E57Stream::text_end(std::size_t at) const {
    if (at >= filled_) return filled_ + 1;
    if ((static_cast<unsigned char>(bytes_[at]) & 1U) == 0) {
        return at + 1 + (static_cast<unsigned char>(bytes_[at]) >> 1U);
    }
    if (filled_ - at < 8) return filled_ + 1;
    const std::uint64_t length = little_endian<std::uint64_t>(bytes_.data() + at) >> 1U;
    return length > filled_ ? filled_ + 1 : at + 8 + static_cast<std::size_t>(length);
}

std::uint64_t E57Stream::count_texts(std::uint64_t wanted) const {
    auto at = static_cast<std::size_t>(bit_ / 8U);
    std::uint64_t count = 0;
    while (count < wanted) {
        const std::size_t end = text_end(at);
        if (end > filled_) break;
        at = end;
        ++count;
    }
    return count;
}

void E57Stream::skip_texts(std::size_t count) {
    auto at = static_cast<std::size_t>(bit_ / 8U);
    for (std::size_t i = 0; i < count; ++i) at = text_end(at);
    bit_ = static_cast<std::uint64_t>(at) * 8U;
}

} // namespace planum::scans
