// SPDX-License-Identifier: MIT
#include "core/base/uuid.hpp"

#include <chrono>
#include <random>

namespace planum {

namespace {

constexpr std::string_view kDigits = "0123456789abcdef";

// Value of every hexadecimal digit, -1 for all else; loading a project parses half a million ids.
constexpr std::array<signed char, 256> kHexValues = [] {
    std::array<signed char, 256> values{};
    values.fill(-1);
    for (std::size_t i = 0; i < 10; ++i) values[static_cast<std::size_t>('0') + i] = static_cast<signed char>(i);
    for (std::size_t i = 0; i < 6; ++i) {
        values[static_cast<std::size_t>('a') + i] = static_cast<signed char>(10 + i);
        values[static_cast<std::size_t>('A') + i] = static_cast<signed char>(10 + i);
    }
    return values;
}();

bool is_hyphen_place(std::size_t i) noexcept { return i == 8 || i == 13 || i == 18 || i == 23; }

// splitmix64, Steele et al. 2014: small, and good enough for ids.
std::uint64_t splitmix(std::uint64_t& state) noexcept {
    state += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
}

Uuid version_7(std::uint64_t time_48, std::uint64_t sequence_12, std::uint64_t random) noexcept {
    Uuid id;
    id.high = (time_48 << 16U) | 0x7000U | (sequence_12 & 0xFFFU);
    id.low = (random & 0x3FFFFFFFFFFFFFFFULL) | 0x8000000000000000ULL;
    return id;
}

} // namespace

std::string Uuid::to_string() const {
    std::string text(36, '-');
    std::size_t nibble = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (is_hyphen_place(i)) continue;
        const std::uint64_t half = nibble < 16 ? high : low;
        text[i] = kDigits[(half >> (60U - 4U * (nibble % 16))) & 0xFU];
        ++nibble;
    }
    return text;
}

std::optional<Uuid> Uuid::parse(std::string_view text) noexcept {
    if (text.size() != 36) return std::nullopt;
    if (text[8] != '-' || text[13] != '-' || text[18] != '-' || text[23] != '-') return std::nullopt;
    int wrong = 0; // becomes negative with the first character that is no digit
    const auto digits = [&](std::size_t from, std::size_t to) {
        std::uint64_t value = 0;
        for (std::size_t i = from; i < to; ++i) {
            const int digit = kHexValues[static_cast<unsigned char>(text[i])];
            wrong |= digit;
            value = (value << 4U) | static_cast<std::uint64_t>(digit & 0xF);
        }
        return value;
    };
    Uuid id;
    id.high = (digits(0, 8) << 32U) | (digits(9, 13) << 16U) | digits(14, 18);
    id.low = (digits(19, 23) << 48U) | digits(24, 36);
    if (wrong < 0) return std::nullopt;
    return id;
}

TimeOrderedUuids::TimeOrderedUuids() {
    std::random_device device;
    for (std::uint64_t& word : state_) {
        word = (static_cast<std::uint64_t>(device()) << 32U) | device();
    }
}

Uuid TimeOrderedUuids::next() {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    const auto micros = static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(now).count());
    // 60 bits of time: milliseconds as RFC 9562 wants them, the rest as a fraction; never backwards.
    const std::uint64_t stamp = ((micros / 1000U) << 12U) | ((micros % 1000U) * 4096U / 1000U);
    last_ = stamp > last_ ? stamp : last_ + 1;
    return version_7(last_ >> 12U, last_, splitmix(state_[0]) ^ state_[1]);
}

Uuid SeededUuids::next() {
    ++counter_;
    return version_7(counter_ >> 12U, counter_, splitmix(state_));
}

} // namespace planum
