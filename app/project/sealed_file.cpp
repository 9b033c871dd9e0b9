// SPDX-License-Identifier: MIT
#include "app/project/sealed_file.hpp"

#include <cstddef>
#include <cstdint>
#include <system_error>

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/sha256.hpp"

namespace planum::app {

namespace {

constexpr std::size_t kHash = 64;
constexpr std::uintmax_t kLargest = std::uintmax_t{4} << 30U; // bytes

} // namespace

std::optional<std::string> read_sealed(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return std::nullopt;
    try {
        std::string bytes = read_file(file, kLargest);
        if (bytes.size() < kHash) return std::nullopt;
        const std::string hash = bytes.substr(bytes.size() - kHash);
        bytes.resize(bytes.size() - kHash);
        if (sha256(bytes) != hash) return std::nullopt;
        return bytes;
    } catch (const Error&) {
        return std::nullopt;
    }
}

void write_sealed(const std::filesystem::path& file, std::string bytes) {
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    bytes += sha256(bytes);
    try {
        write_file_atomically(file, bytes);
    } catch (const Error&) {
        return;
    }
}

} // namespace planum::app
