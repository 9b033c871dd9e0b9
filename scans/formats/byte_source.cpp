// SPDX-License-Identifier: MIT
#include "scans/formats/byte_source.hpp"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/error.hpp"

namespace planum::scans {

namespace {

void check_range(std::uint64_t offset, std::uint64_t count, std::uint64_t size) {
    if (offset > size || count > size - offset) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("ends too early: {} bytes wanted at byte {}, the file has {}", count, offset, size));
    }
}

class FileSource final : public ByteSource {
  public:
    explicit FileSource(const std::filesystem::path& file) {
        descriptor_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
        if (descriptor_ < 0) {
            const ErrorCode code = errno == ENOENT ? ErrorCode::NotFound : ErrorCode::Io;
            throw Error(code, std::string("cannot be opened: ") + std::strerror(errno));
        }

        struct stat status {};

        if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) {
            ::close(descriptor_);
            throw Error(ErrorCode::BadInput, "not an ordinary file");
        }
        size_ = static_cast<std::uint64_t>(status.st_size);
        ::posix_fadvise(descriptor_, 0, 0, POSIX_FADV_SEQUENTIAL);
    }

    ~FileSource() override { ::close(descriptor_); }

    [[nodiscard]] std::uint64_t size() const noexcept override { return size_; }

    void read(std::uint64_t offset, std::span<char> out) const override {
        check_range(offset, out.size(), size_);
        while (!out.empty()) {
            const ssize_t got = ::pread(descriptor_, out.data(), out.size(), static_cast<off_t>(offset));
            if (got < 0 && errno == EINTR) continue;
            if (got < 0) throw Error(ErrorCode::Io, std::string("reading failed: ") + std::strerror(errno));
            if (got == 0) throw Error(ErrorCode::Io, "became shorter while it was read");
            out = out.subspan(static_cast<std::size_t>(got));
            offset += static_cast<std::uint64_t>(got);
        }
    }

  private:
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

class MemorySource final : public ByteSource {
  public:
    explicit MemorySource(std::string bytes) : bytes_(std::move(bytes)) {}

    [[nodiscard]] std::uint64_t size() const noexcept override { return bytes_.size(); }

    void read(std::uint64_t offset, std::span<char> out) const override {
        check_range(offset, out.size(), bytes_.size());
        if (!out.empty()) std::memcpy(out.data(), bytes_.data() + offset, out.size());
    }

  private:
    std::string bytes_;
};

} // namespace

std::string ByteSource::read_string(std::uint64_t offset, std::uint64_t count) const {
    check_range(offset, count, size());
    std::string bytes(static_cast<std::size_t>(count), '\0');
    read(offset, bytes);
    return bytes;
}

std::unique_ptr<ByteSource> open_file_source(const std::filesystem::path& file) {
    try {
        return std::make_unique<FileSource>(file);
    } catch (Error& e) {
        e.add_context(file.string());
        throw;
    }
}

std::unique_ptr<ByteSource> memory_source(std::string bytes) {
    return std::make_unique<MemorySource>(std::move(bytes));
}

} // namespace planum::scans
