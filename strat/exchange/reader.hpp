// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.hpp"
#include "strat/exchange/imported_record.hpp"

namespace planum::strat {

/// Records are text that people wrote: more than this in one file is not a record.
inline constexpr std::uintmax_t kMaxRecordFile = 256U << 20U; // bytes

/// A file given to the readers. `bytes` is empty for databases, which are opened by path.
struct InputFile {
    std::filesystem::path path;
    std::string name; ///< without folders
    std::string bytes;
    bool is_database = false; ///< starts with the SQLite header
    bool found = false;       ///< in a folder that was named, not itself: left out when no reader knows it
};

struct ReadOptions {
    /// Numbers in files without an area column belong to this area; empty: none.
    std::string area;
    /// Of files with several sites, the one to read; empty: the one with most units; `*`: all.
    std::string site;
};

/// How sure a reader is that files are its own.
enum class Confidence { No, Possible, Likely, Certain };

/// What a reader would take of the files offered.
struct Recognition {
    Confidence confidence = Confidence::No;
    std::vector<std::size_t> files; ///< indices of the files it would read together
    std::string why;                ///< "columns younger, older" – shown when two readings remain
};

/// One format. Recognising looks at content first, then at names and companion files; it never throws.
/// Reading throws Error{BadInput} with the file's name when nothing can be got out of it, and otherwise
/// reports line by line.
struct Reader {
    std::string_view format; ///< for --format: `lst`, `hmcx`, `pyarchinit`, …
    std::string_view title;  ///< "Harris Matrix Composer project (.hmcx)"
    Recognition (*recognise)(std::span<const InputFile> files);
    Imported<ImportedRecord> (*read)(std::span<const InputFile* const> files, const ReadOptions& options,
                                     Progress& progress);
};

/// All readers, in the order in which they are asked.
[[nodiscard]] std::span<const Reader> all_readers();

/// Reads a file for the readers: at most kMaxRecordFile bytes, no endless lines (text_limits.hpp), databases only by
/// their header. Throws BadInput naming the file, and the line.
[[nodiscard]] InputFile load_input_file(const std::filesystem::path& file);

/// One set of files that one reader will read together.
struct Reading {
    const Reader* reader = nullptr;
    std::vector<std::size_t> files;
    std::string note; ///< "could also be read as …; --format overrules" or empty
};

/// Which files go to which reader. `format` empty: by content; else that reader takes all files. Files that no
/// reader knows and that merely lay in a folder are in no reading. Throws BadInput naming the first other file that no
/// reader knows, and what was looked for.
[[nodiscard]] std::vector<Reading> plan_reading(std::span<const InputFile> files, std::string_view format);

} // namespace planum::strat
