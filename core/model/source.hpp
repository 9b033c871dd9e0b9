// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "core/model/ids.hpp"

namespace planum::model {

/// A file something was imported from. The same name again is the same source, longer than yesterday.
struct Source {
    SourceId id;
    std::string name; ///< file name without folders
    std::string format;
    std::string sha256; ///< of the last content seen
    std::string imported_at;
    bool states_both_sides = false; ///< at least half of its relations are stated from both sides

    friend bool operator==(const Source&, const Source&) = default;
};

/// Something in a file that could not be understood, kept with the record until somebody mends it.
struct ImportNote {
    ImportNoteId id;
    SourceId source;
    std::int64_t line = 0; ///< from 1; 0: the whole file
    std::string code;      ///< unparsed, empty-target, unknown-relation, conflicting-value, …
    std::string raw_text;
    std::string message; ///< a plain sentence

    friend bool operator==(const ImportNote&, const ImportNote&) = default;
};

} // namespace planum::model
