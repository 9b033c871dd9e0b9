// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/project/project.hpp"

namespace planum::app {

/// What somebody who drew an outline should know of where it lies: far from all scans, or on ground that other outlines
/// of its surface or section claim too; a sentence each. `wished` stands for the region of the same id.
[[nodiscard]] std::vector<std::string> outline_remarks(const model::Record& record, const model::RecordIndex& index,
                                                       const model::Region& wished);

} // namespace planum::app
