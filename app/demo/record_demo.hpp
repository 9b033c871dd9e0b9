// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "strat/layout/text_measure.hpp"

namespace planum::app {

/// What the demo on a generated record made.
struct RecordDemo {
    std::filesystem::path project;
    std::vector<std::filesystem::path> files; ///< to look at
    std::size_t units = 0;
    std::size_t errors = 0;
    std::size_t warnings = 0;
};

/// Generates a record (small 60, medium 300, large 1,500 units), puts mistakes into it as people make them, writes
/// it as our own tables into `folder/record`, and runs the whole job on those files: project, import, check,
/// matrix, reports. The tables are the same bytes for the same seed. Throws Conflict when the folder holds a
/// project already.
[[nodiscard]] RecordDemo make_record_demo(const std::filesystem::path& folder, std::uint64_t seed, const std::string& size,
                                          const Session& session, const strat::TextMeasure& measure, Progress& progress);

} // namespace planum::app
