// SPDX-License-Identifier: MIT
#include "scans/cloud/point_spill.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <unistd.h>

#include "core/base/error.hpp"

namespace planum::scans {

namespace {

constexpr std::size_t kSmallestChunk = 64;
constexpr std::size_t kLargestChunk = 16384;
constexpr std::size_t kPiece = 65536; // points read back at once

[[noreturn]] void fail(const std::filesystem::path& folder, const char* doing) {
    throw Error(ErrorCode::Io, folder.string() + ": " + doing + " a temporary file: " + std::strerror(errno));
}

} // namespace

SpillFile::~SpillFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

std::uint64_t SpillFile::write(std::span<const PackedPoint> points) {
    if (descriptor_ < 0) {
        std::string name = (folder_ / ".planum-spill-XXXXXX").string();
        descriptor_ = ::mkstemp(name.data());
        if (descriptor_ < 0) fail(folder_, "making");
        ::unlink(name.c_str()); // whatever happens, nothing stays behind
    }
    const char* from = reinterpret_cast<const char*>(points.data());
    std::size_t left = points.size_bytes();
    auto at = static_cast<off_t>(points_ * sizeof(PackedPoint));
    while (left > 0) {
        const ssize_t written = ::pwrite(descriptor_, from, left, at);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(folder_, "writing");
        from += written;
        at += written;
        left -= static_cast<std::size_t>(written);
    }
    const std::uint64_t first = points_;
    points_ += points.size();
    return first;
}

void SpillFile::read(std::uint64_t first, std::span<PackedPoint> out) const {
    char* to = reinterpret_cast<char*>(out.data());
    std::size_t left = out.size_bytes();
    auto at = static_cast<off_t>(first * sizeof(PackedPoint));
    while (left > 0) {
        const ssize_t got = ::pread(descriptor_, to, left, at);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) fail(folder_, "reading");
        to += got;
        at += got;
        left -= static_cast<std::size_t>(got);
    }
}

void PointBucket::grow() {
    const std::size_t size = chunks_.empty() ? kSmallestChunk : std::min(chunks_.back().capacity() * 2, kLargestChunk);
    chunks_.emplace_back();
    chunks_.back().reserve(size);
    memory_ += size * sizeof(PackedPoint);
}

void PointBucket::spill(SpillFile& file) {
    for (const std::vector<PackedPoint>& chunk : chunks_) {
        const std::uint64_t first = file.write(chunk);
        if (!extents_.empty() && extents_.back().first + extents_.back().count == first) {
            extents_.back().count += chunk.size();
        } else {
            extents_.push_back({first, chunk.size()});
        }
    }
    chunks_ = {};
    memory_ = 0;
}

void PointBucket::for_each_piece(const SpillFile& file,
                                 const std::function<void(std::span<const PackedPoint>)>& take) const {
    std::vector<PackedPoint> piece;
    for (const Extent& extent : extents_) {
        for (std::uint64_t done = 0; done < extent.count; done += piece.size()) {
            piece.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kPiece, extent.count - done)));
            file.read(extent.first + done, piece);
            take(piece);
        }
    }
    for (const std::vector<PackedPoint>& chunk : chunks_) take(chunk);
}

std::vector<PackedPoint> PointBucket::take_all(const SpillFile& file) {
    std::vector<PackedPoint> all(static_cast<std::size_t>(count_));
    std::size_t filled = 0;
    for (const Extent& extent : extents_) {
        file.read(extent.first, std::span(all).subspan(filled, static_cast<std::size_t>(extent.count)));
        filled += static_cast<std::size_t>(extent.count);
    }
    for (const std::vector<PackedPoint>& chunk : chunks_) {
        std::copy(chunk.begin(), chunk.end(), all.begin() + static_cast<std::ptrdiff_t>(filled));
        filled += chunk.size();
    }
    clear();
    return all;
}

void PointBucket::clear() {
    chunks_ = {};
    extents_ = {};
    count_ = 0;
    memory_ = 0;
}

} // namespace planum::scans
