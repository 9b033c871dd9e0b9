// SPDX-License-Identifier: MIT
#include "scans/cloud/store_file.hpp"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "core/base/error.hpp"

namespace planum::scans {

namespace {

constexpr std::size_t kBuffer = 4U << 20U;

[[noreturn]] void fail(const std::filesystem::path& file, int problem) {
    throw Error(ErrorCode::Io, fmt::format("{}: cannot be written: {}", file.string(), std::strerror(problem)));
}

} // namespace

StoreFile::StoreFile(std::filesystem::path target)
    : target_(std::move(target)), temporary_(target_.string() + fmt::format(".{}.part", ::getpid())) {
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0) fail(target_, errno);
    buffer_.reserve(kBuffer);
}

StoreFile::~StoreFile() {
    if (descriptor_ < 0) return;
    ::close(descriptor_);
    ::unlink(temporary_.c_str());
}

void StoreFile::append(std::span<const char> bytes) {
    if (buffer_.size() + bytes.size() > kBuffer) flush();
    if (bytes.size() >= kBuffer) {
        write_at(size_, bytes);
        flushed_ += bytes.size();
    } else {
        buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    }
    size_ += bytes.size();
}

void StoreFile::flush() {
    write_at(flushed_, buffer_);
    flushed_ += buffer_.size();
    buffer_.clear();
}

void StoreFile::write_at(std::uint64_t at, std::span<const char> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(at));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(target_, errno);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
        at += static_cast<std::uint64_t>(written);
    }
}

void StoreFile::commit(std::span<const char> head) {
    flush();
    write_at(0, head);
    if (::fsync(descriptor_) != 0) fail(target_, errno);
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(target_, errno);
    ::close(descriptor_);
    descriptor_ = -1;
}

} // namespace planum::scans
