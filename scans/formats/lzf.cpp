// SPDX-License-Identifier: MIT
#include "scans/formats/lzf.hpp"

#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "core/base/error.hpp"

namespace planum::scans {

namespace {

// The longest reference: three bytes that stand for 264.
constexpr std::size_t kMostFromThree = 264;

[[noreturn]] void damaged(std::size_t at) {
    throw Error(ErrorCode::BadInput, fmt::format("compressed data damaged at their byte {}", at));
}

} // namespace

std::string unpack_lzf(std::string_view packed, std::size_t size) {
    if (size / kMostFromThree > packed.size() / 3 + 1) {
        throw Error(ErrorCode::BadInput, fmt::format("{} compressed bytes cannot hold {}", packed.size(), size));
    }
    std::string out(size, '\0');
    const auto byte = [&](std::size_t i) {
        if (i >= packed.size()) damaged(i);
        return static_cast<std::size_t>(static_cast<unsigned char>(packed[i]));
    };
    std::size_t in = 0;
    std::size_t filled = 0;
    while (in < packed.size()) {
        const std::size_t start = in;
        const std::size_t control = byte(in++);
        if (control < 32) { // control + 1 bytes as they are
            const std::size_t count = control + 1;
            if (count > packed.size() - in || count > size - filled) damaged(start);
            std::memcpy(out.data() + filled, packed.data() + in, count);
            in += count;
            filled += count;
            continue;
        }
        // Three bits of length (7: one more byte follows), thirteen of distance.
        std::size_t length = control >> 5U;
        if (length == 7) length += byte(in++);
        length += 2;
        const std::size_t distance = ((control & 31U) << 8U | byte(in++)) + 1;
        if (distance > filled || length > size - filled) damaged(start);
        // Byte by byte: source and target overlap when a pattern is repeated.
        for (std::size_t i = 0; i < length; ++i, ++filled) out[filled] = out[filled - distance];
    }
    if (filled != size) {
        throw Error(ErrorCode::BadInput, fmt::format("compressed data hold {} bytes, {} are expected", filled, size));
    }
    return out;
}

} // namespace planum::scans
