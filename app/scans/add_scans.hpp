// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "core/model/scan.hpp"

namespace planum::app {

struct AddScansOptions {
    std::string day;     ///< of all files; empty: the folder named by its date, else the file's own time
    std::string surface; ///< name, `DAY` or `DAY.2`; empty: that of the day
    std::string area;    ///< whose surface; empty: the only one, or none
    std::string columns; ///< of XYZ and CSV, see scans::OpenOptions
};

struct AddedScan {
    model::Scan scan;
    std::vector<std::string> notes; ///< what a person should know: guessed columns, clamped values, …
};

struct ScanThere {
    std::string file;
    std::string scan;  ///< under which it is in the project already
    std::string moved; ///< where it was looked for until now, when it was no longer there; else empty
};

struct AddScansReport {
    std::vector<AddedScan> added;
    std::vector<ScanThere> there_already;
    std::vector<std::string> left_aside; ///< files of the folders that are no scans, with the reason
    std::int64_t change = 0;             ///< 0: nothing was new or had moved
};

/// Adds scan files, and all scan files of folders, to the project: names them `DAY/STEM`, makes their point
/// stores and records them in one change. A file that the project knows by its content and no longer finds is looked
/// for where it is now from then on. The originals are only read. Either all are added or, when one
/// cannot be read or the user stops, none, and what was made for them is gone again.
///
/// Throws BadInput (named file, page, record or line), Usage (no day known), Conflict (another file of that
/// name on that day), NotFound, Io, Cancelled.
AddScansReport add_scans(Project& project, const std::vector<std::filesystem::path>& inputs,
                         const AddScansOptions& options, Progress& progress);

} // namespace planum::app
