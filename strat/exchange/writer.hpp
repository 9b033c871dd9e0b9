// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/record.hpp"

namespace planum::strat {

/// One file of a written record.
struct WrittenFile {
    std::string name; ///< `units.csv`; empty where the format is a single file, whose name the caller chooses
    std::string bytes;
};

/// What a writer made, and what it could not carry: plain sentences, one a kind of loss, with numbers.
struct Written {
    std::vector<WrittenFile> files;
    std::vector<std::string> lost;
};

struct WriteOptions {
    /// What the caller puts before the names of several files (`mill-`), for files that name each other.
    std::string prefix;
    char delimiter = ',';         ///< of our own tables
    bool byte_order_mark = false; ///< before our own tables, for spreadsheets that guess
    bool guard_formulas = true;   ///< an apostrophe before = + - @ in our own tables
};

/// One format that can be written. The same record gives the same bytes. A writer never fails for what
/// a record holds: what the format lacks is written as near as it goes and said in `lost`.
struct Writer {
    std::string_view format; ///< the name its reader has
    std::string_view title;
    std::string_view extension; ///< of the single file, or of the archive; empty: several files, or only by name
    Written (*write)(const model::Record& record, const WriteOptions& options);
};

[[nodiscard]] std::span<const Writer> all_writers();

/// Throws Usage naming the formats when there is none of that name.
[[nodiscard]] const Writer& writer_for(std::string_view format);

} // namespace planum::strat
