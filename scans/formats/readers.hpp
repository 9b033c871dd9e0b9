// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "scans/formats/scan_reader.hpp"

namespace planum::scans {

// One factory a format; open_scan chooses among them.

[[nodiscard]] std::unique_ptr<ScanReader> make_ptx_reader(std::unique_ptr<ByteSource> source, Progress& progress);
[[nodiscard]] std::unique_ptr<ScanReader> make_e57_reader(std::unique_ptr<ByteSource> source);
[[nodiscard]] std::unique_ptr<ScanReader> make_las_reader(std::unique_ptr<ByteSource> source);
[[nodiscard]] std::unique_ptr<ScanReader> make_ply_reader(std::unique_ptr<ByteSource> source);
[[nodiscard]] std::unique_ptr<ScanReader> make_pcd_reader(std::unique_ptr<ByteSource> source);
[[nodiscard]] std::unique_ptr<ScanReader> make_pts_reader(std::unique_ptr<ByteSource> source, Progress& progress);
[[nodiscard]] std::unique_ptr<ScanReader> make_xyz_reader(std::unique_ptr<ByteSource> source,
                                                          const OpenOptions& options, Progress& progress);

/// `pose`: the text of the .pose file, nullopt when there is none.
[[nodiscard]] std::unique_ptr<ScanReader> make_3dtk_reader(std::unique_ptr<ByteSource> source,
                                                           const std::optional<std::string>& pose, Progress& progress);

} // namespace planum::scans
