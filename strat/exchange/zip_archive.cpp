// SPDX-License-Identifier: MIT
#include "strat/exchange/zip_archive.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include "core/base/error.hpp"

namespace planum::strat {

namespace {

constexpr std::size_t kMaxMembers = 10'000;
constexpr std::size_t kMaxRatio = 200;            // project files shrink to a tenth or twentieth
constexpr std::size_t kAlwaysAllowed = 1U << 20U; // small members may be as repetitive as they like

struct ReadCloser {
    void operator()(archive* a) const noexcept { archive_read_free(a); }
};

struct WriteCloser {
    void operator()(archive* a) const noexcept { archive_write_free(a); }
};

struct EntryCloser {
    void operator()(archive_entry* e) const noexcept { archive_entry_free(e); }
};

[[noreturn]] void fail(std::string_view file, std::string_view problem) {
    throw Error(ErrorCode::BadInput, fmt::format("{}: {}", file, problem));
}

std::string reason(archive* a) {
    const char* text = archive_error_string(a);
    return text == nullptr ? "unreadable" : text;
}

std::string read_member(archive* a, std::string_view file, std::string_view member, std::size_t limit) {
    std::string content;
    std::array<char, 65536> buffer{};
    while (true) {
        const la_ssize_t count = archive_read_data(a, buffer.data(), buffer.size());
        if (count < 0) fail(file, fmt::format("{} in the archive is damaged: {}", member, reason(a)));
        if (count == 0) return content;
        content.append(buffer.data(), static_cast<std::size_t>(count));
        if (content.size() > limit) {
            fail(file, fmt::format("{} in the archive unpacks to more than {} bytes, which no project of that size "
                                   "does",
                                   member, limit));
        }
    }
}

la_ssize_t append_bytes(archive* /*a*/, void* target, const void* bytes, size_t size) {
    static_cast<std::string*>(target)->append(static_cast<const char*>(bytes), size);
    return static_cast<la_ssize_t>(size);
}

} // namespace

bool is_zip(std::string_view bytes) noexcept { return bytes.starts_with(std::string_view{"PK\x03\x04", 4}); }

std::map<std::string, std::string> read_zip(std::string_view bytes, std::string_view file_name,
                                            std::span<const std::string_view> wanted, std::size_t limit) {
    const std::unique_ptr<archive, ReadCloser> reader(archive_read_new());
    archive_read_support_format_zip(reader.get());
    if (archive_read_open_memory(reader.get(), bytes.data(), bytes.size()) != ARCHIVE_OK) {
        fail(file_name, "the archive cannot be opened: " + reason(reader.get()));
    }
    const std::size_t cap = std::min(limit, std::max(kAlwaysAllowed, bytes.size() * kMaxRatio));
    std::map<std::string, std::string> members;
    archive_entry* entry = nullptr;
    for (std::size_t count = 0;; ++count) {
        if (count > kMaxMembers) fail(file_name, fmt::format("more than {} files in the archive", kMaxMembers));
        const int state = archive_read_next_header(reader.get(), &entry);
        if (state == ARCHIVE_EOF) return members;
        if (state != ARCHIVE_OK && state != ARCHIVE_WARN) {
            fail(file_name, "the archive is damaged: " + reason(reader.get()));
        }
        const char* path = archive_entry_pathname(entry);
        const std::string_view full = path == nullptr ? std::string_view{} : std::string_view{path};
        const std::string name{full.substr(full.rfind('/') == std::string_view::npos ? 0 : full.rfind('/') + 1)};
        if (std::find(wanted.begin(), wanted.end(), name) == wanted.end() || members.contains(name)) continue;
        members.emplace(name, read_member(reader.get(), file_name, name, cap));
    }
}

std::string write_zip(std::span<const std::pair<std::string, std::string>> members) {
    std::string bytes;
    const std::unique_ptr<archive, WriteCloser> writer(archive_write_new());
    archive_write_set_format_zip(writer.get());
    archive_write_set_bytes_in_last_block(writer.get(), 1);
    const auto check = [&](int state) {
        if (state < ARCHIVE_WARN) throw Error(ErrorCode::Internal, "writing a zip: " + reason(writer.get()));
    };
    check(archive_write_open(writer.get(), &bytes, nullptr, append_bytes, nullptr));
    for (const auto& [name, content] : members) {
        const std::unique_ptr<archive_entry, EntryCloser> entry(archive_entry_new());
        archive_entry_set_pathname(entry.get(), name.c_str());
        archive_entry_set_size(entry.get(), static_cast<la_int64_t>(content.size()));
        archive_entry_set_filetype(entry.get(), AE_IFREG);
        archive_entry_set_perm(entry.get(), 0644);
        archive_entry_set_mtime(entry.get(), 315532800, 0); // 1980-01-01, where zip begins
        check(archive_write_header(writer.get(), entry.get()));
        const la_ssize_t written = archive_write_data(writer.get(), content.data(), content.size());
        if (written != static_cast<la_ssize_t>(content.size())) {
            throw Error(ErrorCode::Internal, "writing a zip: " + reason(writer.get()));
        }
    }
    check(archive_write_close(writer.get()));
    return bytes;
}

} // namespace planum::strat
