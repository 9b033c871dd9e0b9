// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/store/project_file.hpp"
#include "strat/exchange/imported_record.hpp"
#include "strat/exchange/reader.hpp"

namespace planum::app {

/// Where the input is a project file of ours, also one that may only be read, puts its record in place of it, as the
/// JSON that the readers know, and returns a note on what that does not carry. Nothing for any other file. The file is
/// not written, but for a change that was cut short in it and is taken back. Throws as ProjectFile::open() for a
/// project that is damaged or newer than this program.
[[nodiscard]] std::vector<strat::ReadNote> read_as_project(strat::InputFile& input,
                                                           const store::Environment& environment);

} // namespace planum::app
