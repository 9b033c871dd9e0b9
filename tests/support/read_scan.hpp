// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/base/error.hpp"
#include "scans/formats/scan_reader.hpp"

namespace planum::test {

/// A cloud in one piece, for tests.
struct WholeCloud {
    scans::PointBlock points;
    scans::ReadSummary summary;
};

inline void append(scans::PointBlock& all, const scans::PointBlock& more) {
    const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    add(all.x, more.x);
    add(all.y, more.y);
    add(all.z, more.z);
    add(all.intensity, more.intensity);
    add(all.colour, more.colour);
    add(all.row, more.row);
    add(all.column, more.column);
    add(all.time, more.time);
    add(all.validity, more.validity);
}

inline WholeCloud read_whole(scans::ScanReader& reader, std::size_t cloud = 0,
                             scans::Misses misses = scans::Misses::Skip, std::size_t block_points = 16384) {
    WholeCloud whole;
    scans::ReadOptions options;
    options.misses = misses;
    options.block_points = block_points;
    whole.summary = reader.read(
        cloud, [&](const scans::PointBlock& block) { append(whole.points, block); }, options, Progress::none());
    return whole;
}

inline std::unique_ptr<scans::ScanReader> open_bytes(std::string bytes, scans::ScanFormat format,
                                                     std::optional<std::string> companion = std::nullopt,
                                                     const std::string& columns = {}) {
    return scans::open_scan(scans::memory_source(std::move(bytes)), format, {columns}, Progress::none(),
                            std::move(companion));
}

inline std::unique_ptr<scans::ScanReader> open_file(const std::filesystem::path& file) {
    return scans::open_scan(file, {}, Progress::none());
}

/// The message of the BadInput that opening and reading everything throws; empty when nothing does.
/// Anything but planum::Error passes through.
inline std::string refusal(const std::string& bytes, scans::ScanFormat format) {
    try {
        const auto reader = open_bytes(bytes, format);
        for (std::size_t i = 0; i < reader->clouds().size(); ++i) read_whole(*reader, i);
        for (std::size_t i = 0; i < reader->info().images.size(); ++i) static_cast<void>(reader->read_image(i));
    } catch (const Error& e) {
        return e.code() == ErrorCode::BadInput ? e.what() : std::string("another code: ") + e.what();
    }
    return {};
}

} // namespace planum::test
