// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace planum::bench {

/// The real pair against its reference: time with preparation, error; PCL's GICP and ICP beside it where there is PCL.
void bench_pair(const std::filesystem::path& folder);

/// The 3DTK sequence from its odometry: pairs and the relaxed whole; PCL beside it.
void bench_sequence(const std::filesystem::path& folder);

/// Cost of known pose graphs after relaxation, from the start values of the file and from along a tree.
void bench_graphs(const std::filesystem::path& folder);

/// Two scans of 2.5 million points, simulated: time of the coarse and of the fine alignment from open stores, error,
/// and whether one thread gives the same bits.
void bench_large_pair();

} // namespace planum::bench
