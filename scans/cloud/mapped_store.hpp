// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "scans/cloud/point_store.hpp"

namespace planum::scans {

/// Read-only memory map of a whole file.
class FileMap {
  public:
    explicit FileMap(const std::filesystem::path& file);
    FileMap(const FileMap&) = delete;
    FileMap& operator=(const FileMap&) = delete;
    ~FileMap();

    [[nodiscard]] std::span<const char> bytes() const noexcept { return {data_, size_}; }

  private:
    const char* data_ = nullptr;
    std::size_t size_ = 0;
};

/// One node's columns, as they lie in the map.
struct NodeView {
    Eigen::Vector3d corner = Eigen::Vector3d::Zero(); ///< of step 0 [m]
    double step = 0.0;                                ///< [m]
    std::uint32_t count = 0;
    const std::uint16_t* axis[3] = {nullptr, nullptr, nullptr};
    const std::uint16_t* intensity = nullptr;
    const std::uint16_t* row = nullptr;
    const std::uint16_t* column = nullptr;
    const Rgb* colour = nullptr;

    /// The middle of the step, so that the error is at most half of one.
    [[nodiscard]] double coordinate(std::size_t k, std::size_t i) const noexcept {
        return corner[static_cast<Eigen::Index>(k)] + (static_cast<double>(axis[k][i]) + 0.5) * step;
    }

    [[nodiscard]] Eigen::Vector3d place(std::size_t i) const noexcept {
        return {coordinate(0, i), coordinate(1, i), coordinate(2, i)};
    }
};

struct PointStore::State {
    explicit State(const std::filesystem::path& path);

    /// Box around the points of a node and all below it; places are middles of steps.
    [[nodiscard]] Box box_of(std::uint32_t node) const noexcept;

    /// The node's columns; checks the block when it is first asked for.
    [[nodiscard]] NodeView view(std::uint32_t node) const;

    /// Whether the block's bytes are what was written.
    [[nodiscard]] bool is_sound(std::uint32_t node) const noexcept;

    std::filesystem::path file;
    FileMap map;
    StoreHeaderRecord header;
    std::span<const StoreNodeRecord> nodes;
    StoreInfo info;
    Bounds bounds;
    mutable std::vector<std::atomic<std::uint8_t>> checked; ///< a node each

  private:
    void check_header();
    void check_nodes() const;
    void check_children(std::size_t node) const;
    void read_text();
    [[nodiscard]] std::span<const char> block_of(std::uint32_t node) const noexcept;
};

} // namespace planum::scans
