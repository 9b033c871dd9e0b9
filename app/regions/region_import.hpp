// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/project/project.hpp"
#include "app/regions/outline.hpp"
#include "core/base/progress.hpp"

namespace planum::app {

struct RegionImportOptions {
    bool create_units = false; ///< make the units that outlines name and the record has not
    bool update = false;       ///< redrawn outlines and differing fields replace those of the project
    bool dry_run = false;
    std::string area;  ///< of outlines that name none
    std::string day;   ///< of outlines that name neither day nor surface
    std::string label; ///< of the undo step; empty: `Import 3 outlines`
};

/// A number that no unit has.
struct UnknownNumber {
    std::string where;
    std::string region;
    std::string drawn;
    std::vector<std::string> near; ///< issued numbers it may stand for
};

/// Two regions of one surface on the same ground.
struct OverlapReport {
    std::string surface;
    std::string first;
    std::string second;
    double area = 0.0; ///< [m²]
};

struct RegionImportReport {
    std::vector<std::string> fresh;    ///< names of new regions
    std::vector<std::string> redrawn;  ///< whose outline or fields were replaced
    std::vector<std::string> named;    ///< that had no unit and now have
    std::size_t same = 0;              ///< outlines that the project has already
    std::vector<std::string> units;    ///< made because of create_units
    std::vector<std::string> areas;    ///< made
    std::vector<std::string> surfaces; ///< made
    std::vector<std::string> sections; ///< made
    std::vector<UnknownNumber> unknown;
    std::vector<OutlineNote> refused;   ///< outlines that were not taken, and why
    std::vector<OutlineNote> repaired;  ///< outlines that were mended, and how
    std::vector<OutlineNote> conflicts; ///< kept as they were: what the file says differently
    std::vector<OutlineNote> notes;     ///< of the reader
    std::vector<OverlapReport> overlaps;
    bool changed = false; ///< something is new or other, or would be
};

/// Takes outlines into the project as one undo step: numbers become units, days become surfaces. An outline that
/// the project has already (same place and unit, or same number as drawn; points within 0.5 mm) is left alone; one that
/// lies on another such by more than half is the same drawn anew: kept as it was unless `update`. A number means the
/// unit of the outline's area, else of its surface's; a refused outline leaves nothing behind.
/// Throws BadInput when not one of the outlines can be used, Usage when `day` is no day.
RegionImportReport import_outlines(Project& project, const OutlineFile& file, const RegionImportOptions& options);

/// Reads files of outlines (GeoJSON, or pixel polygons of panoramas) and takes them in together, as one step.
RegionImportReport import_outline_files(Project& project, const std::vector<std::filesystem::path>& files,
                                        const RegionImportOptions& options, Progress& progress);

} // namespace planum::app
