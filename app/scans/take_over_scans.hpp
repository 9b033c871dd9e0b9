// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"

namespace planum::app {

/// Takes over what another project knows of scans, as one undo step: the scans that this one lacks (by hash and number
/// of the cloud), each on its area's surface of that day, and the registration runs with their poses. Originals are
/// not copied: both projects refer to the same files. Point stores are links to those of the other project where the
/// disk allows it; else, as every missing store, they are made when they are first wanted. Says how many scans came.
///
/// Throws Conflict when the project has another scan or run of the same name, Io, Cancelled.
std::size_t take_over_scans(Project& into, Project& from, Progress& progress);

} // namespace planum::app
