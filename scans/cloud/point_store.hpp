// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "scans/cloud/store_builder.hpp"
#include "scans/cloud/store_layout.hpp"
#include "scans/cloud/store_shapes.hpp"

namespace planum::scans {

/// Which point of a store; the same as long as the store is not made anew.
struct PointRef {
    std::uint32_t node = 0;
    std::uint32_t index = 0;

    friend auto operator<=>(const PointRef&, const PointRef&) = default;
};

/// Points of one node that a query found: `index[i]` is the place of point i in the node.
struct FoundPoints {
    std::uint32_t node = 0;
    std::vector<std::uint32_t> index;
    PointBlock points;
};

using FoundSink = std::function<void(const FoundPoints&)>;

struct PickedPoint {
    PointRef ref;
    Eigen::Vector3d x_in_scan = Eigen::Vector3d::Zero();
    double distance = 0.0; ///< along the ray, or from the place that was asked for [m]
};

struct DamagedBlock {
    std::uint32_t node = 0;
    std::uint64_t at = 0; ///< [byte]
    std::uint64_t points = 0;
    Box where;
};

/// A point store, mapped for reading. Any number of threads may query one object.
///
/// Invariant: what open() let through cannot lead outside of the file. A block is checked by its checksum
/// when it is first read; a damaged one is Error{BadInput} that names it, and is mended by making the
/// store anew from the original (build_store with the same StoreInfo).
class PointStore {
  public:
    /// Reads header and node table. Throws NotFound, Io, or BadInput when it is no sound store.
    [[nodiscard]] static PointStore open(const std::filesystem::path& file);

    PointStore(PointStore&&) noexcept;
    PointStore& operator=(PointStore&&) noexcept;
    ~PointStore();

    [[nodiscard]] const StoreInfo& info() const noexcept;
    [[nodiscard]] std::uint64_t points() const noexcept;
    [[nodiscard]] std::uint64_t file_bytes() const noexcept;
    [[nodiscard]] const Bounds& bounds() const noexcept; ///< of the points as they came
    [[nodiscard]] std::span<const StoreNodeRecord> nodes() const noexcept;

    /// All points of one node. Throws Usage for a node that is not there, BadInput for a damaged block.
    [[nodiscard]] PointBlock read_node(std::uint32_t node) const;
    [[nodiscard]] Eigen::Vector3d place(const PointRef& ref) const;

    /// All points, node by node in the order of the file.
    void for_each(const FoundSink& sink, Progress& progress) const;

    void in_box(const Box& box, const FoundSink& sink) const;
    void in_prism(const Prism& prism, const FoundSink& sink) const;

    /// At most `budget` points: nodes from coarse to fine, what looks largest from the eye first; where not
    /// even the coarsest nodes fit, the same share of each. With a budget of points() or more these are
    /// all points in the frustum. Returns their number.
    std::uint64_t in_frustum(const Frustum& frustum, std::uint64_t budget, const FoundSink& sink) const;

    /// The first point along a ray; of equally near ones the one with the smaller PointRef.
    [[nodiscard]] std::optional<PickedPoint> pick(const Ray& ray) const;

    /// All points along the ray from the first one to `depth` [m] behind it: what a brush touches.
    void brush(const Ray& ray, double depth, const FoundSink& sink) const;

    /// The nearest point no farther than `most` [m]; of equally near ones the one with the smaller PointRef.
    [[nodiscard]] std::optional<PickedPoint> nearest(const Eigen::Vector3d& x_in_scan, double most) const;

    /// Checks every block, read before or not.
    [[nodiscard]] std::vector<DamagedBlock> verify(Progress& progress) const;

  private:
    struct State;
    explicit PointStore(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace planum::scans
