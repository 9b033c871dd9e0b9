// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace planum::bench {

/// Registration of the simulated trench whose files' headers hold the true poses (folders named by days), by pairs
/// from disturbed poses and by the whole chain without start values; prints worst errors.
void bench_trench(const std::filesystem::path& folder);

} // namespace planum::bench
