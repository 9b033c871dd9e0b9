// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/import/merge.hpp"
#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "strat/exchange/imported_record.hpp"

namespace planum::app {

struct ImportOptions {
    std::string format;                        ///< empty: by content
    std::optional<model::NumberScope> numbers; ///< unset: as the project says
    std::string area;                          ///< for files that name none
    std::string site;                          ///< of files with several sites; empty: the largest, `*`: all
    bool update = false;
    bool dry_run = false;
};

/// What one reader took, and as what.
struct ImportedFiles {
    std::string format;
    std::string title;
    std::vector<std::string> files;
    std::string note; ///< what to know about the reading: "could also be read as …", headings only; or empty
};

/// What an import did, or would do.
struct ImportReport {
    std::vector<ImportedFiles> readings;
    std::int64_t new_units = 0;
    std::int64_t filled_units = 0;
    std::int64_t new_relations = 0;
    std::int64_t new_statements = 0;
    std::int64_t new_others = 0;      ///< areas, periods, phases, groups, datings, levels, finds, samples, documents
    std::int64_t mentioned_units = 0; ///< of the new units, those that no file has a sheet for
    std::vector<MergeConflict> conflicts;
    std::vector<std::string> warnings;
    std::vector<strat::ReadNote> notes;
    bool changed = false; ///< something is new, or would be
};

/// Reads the files, whatever their format, and merges them into the project as one undo step. The order of
/// the files does not matter. Throws BadInput when a file cannot be used; then nothing was changed.
ImportReport import_files(Project& project, const std::vector<std::filesystem::path>& files,
                          const ImportOptions& options, Progress& progress);

/// Writes a plan into the project as one undo step; for the importer and the demo.
void apply_merge(Project& project, const MergePlan& plan, std::string_view label);

} // namespace planum::app
