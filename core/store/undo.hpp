// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

#include "core/sqlite/changeset.hpp"
#include "core/store/project_file.hpp"

namespace planum::store {

/// Writes the undo step of the change that is under way: its row and the pieces of its changeset. Changes
/// that had been taken back can no longer be made again.
void keep_change(ProjectFile::State& state, std::int64_t number, std::string_view label,
                 const sqlite::Changeset& changes);

/// See ProjectFile::undo and ProjectFile::redo.
ChangeEntry take_back(ProjectFile::State& state);
ChangeEntry make_again(ProjectFile::State& state);

/// See ProjectFile::forget_changes.
std::size_t drop_changesets(ProjectFile::State& state, std::string_view before);

/// Whether a change older than this one can still be taken back: then its own changeset must be there, too.
[[nodiscard]] bool has_older_changeset(const sqlite::Database& database, std::int64_t change);

/// The changeset of one change, put together from its pieces.
[[nodiscard]] sqlite::Changeset read_changeset(const sqlite::Database& database, std::int64_t change);

} // namespace planum::store
