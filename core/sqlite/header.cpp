// SPDX-License-Identifier: MIT
#include <array>
#include <fstream>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/sqlite/database.hpp"

namespace planum::sqlite {

namespace {

constexpr std::string_view kMagic{"SQLite format 3\0", 16};

using HeaderBytes = std::array<unsigned char, 100>;

std::uint32_t big_endian(const HeaderBytes& bytes, std::size_t at, std::size_t count) noexcept {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) value = (value << 8U) | bytes[at + i];
    return value;
}

HeaderBytes read_first_bytes(const std::filesystem::path& file, std::int64_t size) {
    if (size == 0) throw Error(ErrorCode::BadInput, file.string() + ": the file is empty");
    HeaderBytes bytes{};
    std::ifstream in(file, std::ios::binary);
    if (!in) throw Error(ErrorCode::Io, file.string() + ": cannot be opened: check the permissions");
    in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    const auto magic_read = std::string_view{reinterpret_cast<const char*>(bytes.data()), kMagic.size()};
    if (magic_read != kMagic) throw Error(ErrorCode::BadInput, file.string() + ": not a SQLite database");
    if (in.gcount() != static_cast<std::streamsize>(bytes.size())) {
        throw Error(ErrorCode::BadInput, file.string() + ": the file is cut short: restore a backup");
    }
    return bytes;
}

// Looks again at the size: the header may have been written after the first look, by a commit just then.
bool is_short(const std::filesystem::path& file, FileHeader& header) {
    const std::int64_t stated = header.pages * header.page_size;
    if (header.file_size >= stated) return false;
    std::error_code failure;
    const auto size = std::filesystem::file_size(file, failure);
    if (!failure) header.file_size = static_cast<std::int64_t>(size);
    return header.file_size < stated;
}

bool has_journal(const std::filesystem::path& file) {
    std::error_code failure;
    const auto size = std::filesystem::file_size(file.string() + "-journal", failure);
    return !failure && size > 0;
}

} // namespace

FileHeader read_header(const std::filesystem::path& file) {
    std::error_code failure;
    const auto status = std::filesystem::status(file, failure);
    if (!std::filesystem::exists(status)) throw Error(ErrorCode::NotFound, file.string() + ": no such file");
    if (!std::filesystem::is_regular_file(status)) {
        throw Error(ErrorCode::BadInput, file.string() + ": not an ordinary file");
    }
    FileHeader header;
    header.file_size = static_cast<std::int64_t>(std::filesystem::file_size(file, failure));
    if (failure) throw Error(ErrorCode::Io, file.string() + ": " + failure.message());
    const HeaderBytes bytes = read_first_bytes(file, header.file_size);
    // Offsets: SQLite file format, section 1.3. A page size of 65,536 is written as 1.
    header.page_size = big_endian(bytes, 16, 2) == 1 ? 65536 : big_endian(bytes, 16, 2);
    header.wal = bytes[18] == 2 || bytes[19] == 2;
    header.user_version = big_endian(bytes, 60, 4);
    header.application_id = big_endian(bytes, 68, 4);
    // The page count counts only where "version valid for" repeats the change counter.
    if (big_endian(bytes, 24, 4) == big_endian(bytes, 92, 4)) header.pages = big_endian(bytes, 28, 4);
    const bool power_of_two = header.page_size >= 512 && (header.page_size & (header.page_size - 1)) == 0;
    if (!power_of_two) throw Error(ErrorCode::BadInput, file.string() + ": the file is damaged: restore a backup");
    if (!header.wal && is_short(file, header) && !has_journal(file)) {
        throw Error(ErrorCode::BadInput, fmt::format("{}: the file is cut short ({} of {} bytes): restore a backup",
                                                     file.string(), header.file_size, header.pages * header.page_size));
    }
    return header;
}

} // namespace planum::sqlite
