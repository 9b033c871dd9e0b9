// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/project/project.hpp"

namespace planum::app {

struct ExportOptions {
    std::string format;         ///< of strat::all_writers(); empty: as the file's ending says
    std::string interpretation; ///< empty: the field record
};

/// What an export wrote, and sentences about what the format could not carry.
struct Exported {
    std::vector<std::filesystem::path> files;
    std::vector<std::string> lost;
};

/// Writes the record in the format that the ending names (lst, hmcx, csv, json, graphml, dot, geojson, ttl, xlsx, dxf,
/// oxcal) or that was asked for. A format of several files puts them beside each other: `-o out.csv` gives
/// `out-units.csv`, `out-relations.csv`, …. Throws Usage for an unknown ending, with those that are known.
Exported export_record(Project& project, const std::filesystem::path& file, const ExportOptions& options);

} // namespace planum::app
