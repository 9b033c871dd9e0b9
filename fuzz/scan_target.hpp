// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/error.hpp"
#include "scans/formats/scan_reader.hpp"

namespace planum::fuzz {

/// Opens the bytes and reads every cloud and image to its end. planum::Error is an answer; anything
/// else, or a value the reader must not give out, is a finding.
inline void read_everything(std::string bytes, scans::ScanFormat format,
                            std::optional<std::string> companion = std::nullopt) {
    try {
        const auto reader = scans::open_scan(scans::memory_source(std::move(bytes)), format, {}, Progress::none(),
                                             std::move(companion));
        scans::ReadOptions options;
        options.misses = scans::Misses::Keep;
        options.block_points = 256;
        for (std::size_t i = 0; i < reader->clouds().size(); ++i) {
            const scans::CloudHeader& header = reader->clouds()[i];
            const auto check = [&](const scans::PointBlock& block) {
                for (std::size_t k = 0; k < block.row.size(); ++k) {
                    if (block.row[k] >= header.rows || block.column[k] >= header.columns) __builtin_trap();
                }
            };
            reader->read(i, check, options, Progress::none());
        }
        for (std::size_t i = 0; i < reader->info().images.size(); ++i) static_cast<void>(reader->read_image(i));
    } catch (const Error&) {
        return;
    }
}

} // namespace planum::fuzz
