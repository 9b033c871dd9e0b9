// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace planum::scans {

/// Number types of PLY and PCD.
enum class BinaryType : std::uint8_t { Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64 };

[[nodiscard]] constexpr std::size_t size_of(BinaryType type) noexcept {
    switch (type) {
    case BinaryType::Int8:
    case BinaryType::UInt8: return 1;
    case BinaryType::Int16:
    case BinaryType::UInt16: return 2;
    case BinaryType::Int32:
    case BinaryType::UInt32:
    case BinaryType::Float32: return 4;
    case BinaryType::Int64:
    case BinaryType::UInt64:
    case BinaryType::Float64: return 8;
    }
    return 1;
}

template<class T>
[[nodiscard]] T load_as(const char* at, std::endian order) noexcept {
    char bytes[sizeof(T)];
    std::memcpy(bytes, at, sizeof(T));
    if (order != std::endian::native) std::reverse(bytes, bytes + sizeof(T));
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

/// The number at `at` as a double.
[[nodiscard]] inline double load_value(const char* at, BinaryType type, std::endian order) noexcept {
    switch (type) {
    case BinaryType::Int8: return load_as<std::int8_t>(at, order);
    case BinaryType::UInt8: return load_as<std::uint8_t>(at, order);
    case BinaryType::Int16: return load_as<std::int16_t>(at, order);
    case BinaryType::UInt16: return load_as<std::uint16_t>(at, order);
    case BinaryType::Int32: return load_as<std::int32_t>(at, order);
    case BinaryType::UInt32: return load_as<std::uint32_t>(at, order);
    case BinaryType::Int64: return static_cast<double>(load_as<std::int64_t>(at, order));
    case BinaryType::UInt64: return static_cast<double>(load_as<std::uint64_t>(at, order));
    case BinaryType::Float32: return static_cast<double>(load_as<float>(at, order));
    case BinaryType::Float64: return load_as<double>(at, order);
    }
    return 0.0;
}

} // namespace planum::scans
