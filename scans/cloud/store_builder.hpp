// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "scans/formats/cloud_header.hpp"
#include "scans/formats/scan_reader.hpp"

namespace planum::scans {

/// What a store says about the scan it was made from.
struct StoreInfo {
    std::string name;          ///< of the scan, `DAY/STEM`
    std::string source_sha256; ///< of the original file; checked by verify and on rebuild, never on open
    std::uint64_t source_cloud = 0;
    Columns has;
    IntensityCoding intensity;
    std::uint64_t rows = 0; ///< of the scanner's grid; 0: none
    std::uint64_t columns = 0;
    std::vector<std::string> attributes; ///< all that the original has per point; not all are stored

    friend bool operator==(const StoreInfo&, const StoreInfo&) = default;
};

struct StoreOptions {
    std::uint64_t memory_bytes = 256ULL << 20U; ///< for points; about as much again is used while sorting
};

struct StoreSummary {
    std::uint64_t points = 0;
    std::uint64_t too_far = 0; ///< left out: over 131 km from the first point
    std::uint64_t nodes = 0;
    std::uint64_t file_bytes = 0;
    std::uint64_t coordinate_bytes = 0; ///< coordinates, node table and header
};

/// Makes a point store from a stream of points, out of core.
///
/// The store appears under its name only when finish() returns; a builder that is dropped leaves nothing
/// behind. The same points in the same order give the same bytes, whatever the memory.
class StoreBuilder {
  public:
    /// Throws Io when the file cannot be made.
    StoreBuilder(const std::filesystem::path& file, StoreInfo info, StoreOptions options = {});
    ~StoreBuilder();
    StoreBuilder(const StoreBuilder&) = delete;
    StoreBuilder& operator=(const StoreBuilder&) = delete;

    /// Takes the valid points of a block. Throws Io when temporary space runs out.
    void add(const PointBlock& block);

    StoreSummary finish(Progress& progress);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// What a reader's cloud becomes in a store; a grid of more than 65,536 rows or columns is left out.
[[nodiscard]] StoreInfo store_info(const CloudHeader& header, std::string name, std::string source_sha256,
                                   std::uint64_t source_cloud);

/// Reads a cloud and makes its store. The caller names the step of reading.
StoreSummary build_store(ScanReader& reader, std::size_t cloud, const std::filesystem::path& file, StoreInfo info,
                         const StoreOptions& options, Progress& progress);

} // namespace planum::scans
