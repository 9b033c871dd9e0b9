// SPDX-License-Identifier: MIT
#include "scans/formats/e57_pages.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "scans/formats/crc32c.hpp"

namespace planum::scans {

namespace {

constexpr std::uint64_t kHeaderBytes = 48;
constexpr std::uint64_t kChecksumBytes = 4;
constexpr std::uint64_t kWindowBytes = 1U << 20U;

[[noreturn]] void bad(const std::string& message) { throw Error(ErrorCode::BadInput, message); }

} // namespace

E57Pages::E57Pages(const ByteSource& source) : source_(&source) {
    if (source.size() < kHeaderBytes) bad(fmt::format("{} bytes are too few for an E57 file", source.size()));
    std::array<char, kHeaderBytes> bytes{};
    source.read(0, bytes);
    if (std::memcmp(bytes.data(), "ASTM-E57", 8) != 0) bad("no E57 file: it does not start with ASTM-E57");
    const auto major = little_endian<std::uint32_t>(bytes.data() + 8);
    const auto minor = little_endian<std::uint32_t>(bytes.data() + 12);
    if (major != 1) bad(fmt::format("E57 version {}.{}, this program knows 1.x", major, minor));
    header_.file_length = little_endian<std::uint64_t>(bytes.data() + 16);
    header_.xml_offset = little_endian<std::uint64_t>(bytes.data() + 24);
    header_.xml_length = little_endian<std::uint64_t>(bytes.data() + 32);
    header_.page_size = little_endian<std::uint64_t>(bytes.data() + 40);
    if (header_.page_size < 64 || header_.page_size > kWindowBytes || !std::has_single_bit(header_.page_size)) {
        bad(fmt::format("pages of {} bytes; a power of two from 64 to {} is expected", header_.page_size,
                        kWindowBytes));
    }
    if (header_.file_length != source.size()) {
        bad(fmt::format("the header says {} bytes, the file has {}: cut short or damaged", header_.file_length,
                        source.size()));
    }
    if (source.size() % header_.page_size != 0) {
        bad(fmt::format("{} bytes are no whole number of pages of {}", source.size(), header_.page_size));
    }
    payload_ = header_.page_size - kChecksumBytes;
    pages_ = source.size() / header_.page_size;
    load(0); // the header's own page shall be sound, too
}

std::uint64_t E57Pages::logical_of(std::uint64_t physical) const {
    const std::uint64_t page = physical / header_.page_size;
    const std::uint64_t within = physical % header_.page_size;
    if (page >= pages_) bad(fmt::format("offset {} lies beyond the {} bytes of the file", physical, source_->size()));
    if (within >= payload_) bad(fmt::format("offset {} points into the checksum of page {}", physical, page));
    return page * payload_ + within;
}

void E57Pages::load(std::uint64_t first_page) const {
    const std::uint64_t count =
        std::min(pages_ - first_page, std::max<std::uint64_t>(kWindowBytes / header_.page_size, 1));
    const auto page_size = static_cast<std::size_t>(header_.page_size);
    const auto payload = static_cast<std::size_t>(payload_);
    window_pages_ = 0; // invalid while it is being filled
    window_.resize(static_cast<std::size_t>(count) * page_size);
    source_->read(first_page * header_.page_size, window_);
    std::uint64_t sound = 0;
    for (; sound < count; ++sound) {
        char* page = window_.data() + sound * page_size;
        std::uint32_t stored = 0; // the only big-endian number in the format
        for (std::size_t i = 0; i < kChecksumBytes; ++i) {
            stored = (stored << 8U) | static_cast<unsigned char>(page[payload + i]);
        }
        if (crc32c({page, payload}) != stored) break;
        std::memmove(window_.data() + sound * payload, page, payload);
    }
    // A damaged page only matters to who wants something from it.
    if (sound == 0) {
        bad(fmt::format("page {} of {} (byte {}) is damaged: its checksum is wrong", first_page, pages_,
                        first_page * header_.page_size));
    }
    window_page_ = first_page;
    window_pages_ = sound;
}

void E57Pages::read(std::uint64_t logical, std::span<char> out) const {
    if (logical > logical_size() || out.size() > logical_size() - logical) {
        bad(fmt::format("{} bytes wanted at byte {}, beyond the end of the file", out.size(), logical));
    }
    while (!out.empty()) {
        const std::uint64_t page = logical / payload_;
        if (page < window_page_ || page >= window_page_ + window_pages_) load(page);
        const std::uint64_t within = logical - window_page_ * payload_;
        const std::uint64_t ready = window_pages_ * payload_ - within;
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(ready, out.size()));
        std::memcpy(out.data(), window_.data() + within, count);
        out = out.subspan(count);
        logical += count;
    }
}

std::string E57Pages::read_string(std::uint64_t logical, std::uint64_t count) const {
    if (logical > logical_size() || count > logical_size() - logical) {
        bad(fmt::format("{} bytes wanted at byte {}, beyond the end of the file", count, logical));
    }
    std::string bytes(static_cast<std::size_t>(count), '\0');
    read(logical, bytes);
    return bytes;
}

} // namespace planum::scans
