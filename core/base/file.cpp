// SPDX-License-Identifier: MIT
#include "core/base/file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "core/base/error.hpp"

namespace planum {

namespace {

[[noreturn]] void fail(const std::filesystem::path& file, std::string_view doing, int problem) {
    throw Error(ErrorCode::Io, fmt::format("{}: {}: {}", file.string(), doing, std::strerror(problem)));
}

void write_all(int descriptor, std::string_view bytes, const std::filesystem::path& file) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(file, "writing", errno);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    // Pipes and terminals have no disk behind them.
    if (::fsync(descriptor) != 0 && errno != EINVAL && errno != EROFS && errno != ENOTSUP)
        fail(file, "writing to disk", errno);
}

/// A device, a pipe, a terminal: renaming a file over it would put an ordinary file in its place.
void write_into(const std::filesystem::path& device, std::string_view bytes) {
    const int descriptor = ::open(device.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) fail(device, "cannot be written", errno);
    try {
        write_all(descriptor, bytes, device);
    } catch (...) {
        ::close(descriptor);
        throw;
    }
    ::close(descriptor);
}

} // namespace

std::string read_file(const std::filesystem::path& file, std::uintmax_t limit) {
    std::error_code problem;
    if (!std::filesystem::exists(file, problem)) {
        throw Error(ErrorCode::NotFound, file.string() + ": no such file");
    }
    if (!std::filesystem::is_regular_file(file, problem)) {
        throw Error(ErrorCode::BadInput, file.string() + ": not an ordinary file");
    }
    const std::uintmax_t size = std::filesystem::file_size(file, problem);
    if (size > limit) {
        throw Error(ErrorCode::BadInput, fmt::format("{}: {} MB, more than the {} MB that such a file may have",
                                                     file.string(), size / 1000000, limit / 1000000));
    }
    std::ifstream in(file, std::ios::binary);
    if (!in) fail(file, "opening", errno);
    std::string bytes(static_cast<std::size_t>(size), '\0');
    in.read(bytes.data(), static_cast<std::streamsize>(size));
    bytes.resize(static_cast<std::size_t>(in.gcount()));
    if (in.bad()) fail(file, "reading", errno);
    return bytes;
}

void refuse_to_replace_database(const std::filesystem::path& file) {
    constexpr std::string_view kDatabase("SQLite format 3\0", 16);
    std::string start(kDatabase.size(), '\0');
    std::ifstream in(file, std::ios::binary);
    if (!in.read(start.data(), static_cast<std::streamsize>(start.size())) || start != kDatabase) return;
    throw Error(ErrorCode::BadInput, file.string() + ": is a project or another database; name another file to write");
}

void write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
    std::error_code none;
    const auto status = std::filesystem::status(path, none);
    if (std::filesystem::is_other(status)) return write_into(path, bytes);
    refuse_to_replace_database(path);
    // Through a link to what it points to; where that is not there yet, the link itself becomes the file.
    const bool is_link = std::filesystem::is_symlink(std::filesystem::symlink_status(path, none));
    const std::filesystem::path file =
        is_link && std::filesystem::exists(status) ? std::filesystem::canonical(path, none) : path;
    const std::filesystem::path temporary = file.string() + fmt::format(".{}.part", ::getpid());
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor < 0) fail(file, "cannot be written", errno);
    try {
        write_all(descriptor, bytes, file);
    } catch (...) {
        ::close(descriptor);
        ::unlink(temporary.c_str());
        throw;
    }
    if (::close(descriptor) != 0 || std::rename(temporary.c_str(), file.c_str()) != 0) {
        const int problem = errno;
        ::unlink(temporary.c_str());
        fail(file, "cannot be written", problem);
    }
}

} // namespace planum
