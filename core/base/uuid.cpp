// SPDX-License-Identifier: MIT
#include "core/base/uuid.hpp"

#include <chrono>
#include <random>

namespace planum {

namespace {

constexpr std::string_view kDigits = "0123456789abcdef";

int hex_value(char c) noexcept {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

bool is_hyphen_place(std::size_t i) noexcept {
    return i == 8 || i == 13 || i == 18 || i == 23;
}

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
    Uuid id;
    std::size_t nibble = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (is_hyphen_place(i)) {
            if (text[i] != '-') return std::nullopt;
            continue;
        }
        const int value = hex_value(text[i]);
        if (value < 0) return std::nullopt;
        std::uint64_t& half = nibble < 16 ? id.high : id.low;
        half = (half << 4U) | static_cast<std::uint64_t>(value);
        ++nibble;
    }
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
