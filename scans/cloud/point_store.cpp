// SPDX-License-Identifier: MIT
#include "scans/cloud/point_store.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <queue>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "scans/cloud/mapped_store.hpp"
#include "scans/cloud/shape_overlap.hpp"
#include "scans/formats/block_builder.hpp"

namespace planum::scans {

namespace {

template<class Visit>
void for_children(const StoreNodeRecord& node, Visit visit) {
    const auto count = static_cast<std::uint32_t>(std::popcount(node.child_mask));
    for (std::uint32_t i = 0; i < count; ++i) visit(node.first_child + i);
}

void copy_point(const NodeView& view, std::uint32_t i, FoundPoints& found) {
    PointBlock& to = found.points;
    found.index.push_back(i);
    to.x.push_back(view.coordinate(0, i));
    to.y.push_back(view.coordinate(1, i));
    to.z.push_back(view.coordinate(2, i));
    to.validity.push_back(Validity::Valid);
    if (view.intensity != nullptr) to.intensity.push_back(view.intensity[i]);
    if (view.colour != nullptr) to.colour.push_back(view.colour[i]);
    if (view.row != nullptr) {
        to.row.push_back(view.row[i]);
        to.column.push_back(view.column[i]);
    }
}

void clear(FoundPoints& found, std::uint32_t node) {
    found.node = node;
    found.index.clear();
    found.points.resize(0, {});
}

void copy_all(const NodeView& view, FoundPoints& found, const Columns& columns) {
    const std::size_t count = view.count;
    found.index.resize(count);
    for (std::uint32_t i = 0; i < view.count; ++i) found.index[i] = i;
    PointBlock& to = found.points;
    to.resize(count, columns);
    for (std::size_t i = 0; i < count; ++i) {
        to.x[i] = view.coordinate(0, i);
        to.y[i] = view.coordinate(1, i);
        to.z[i] = view.coordinate(2, i);
    }
    std::fill(to.validity.begin(), to.validity.end(), Validity::Valid);
    if (view.intensity != nullptr) std::copy_n(view.intensity, count, to.intensity.begin());
    if (view.colour != nullptr) std::copy_n(view.colour, count, to.colour.begin());
    if (view.row != nullptr) {
        std::copy_n(view.row, count, to.row.begin());
        std::copy_n(view.column, count, to.column.begin());
    }
}

/// Keeps the first `count`, which in a block are a thinned sample of it.
void keep_first(FoundPoints& found, std::size_t count, const Columns& columns) {
    if (found.index.size() <= count) return;
    found.index.resize(count);
    found.points.resize(count, columns);
}

/// The points of one node that `contains` takes.
template<class Contains>
void filter_node(const NodeView& view, Overlap overlap, const Columns& columns, const Contains& contains,
                 FoundPoints& found) {
    if (overlap == Overlap::All) {
        copy_all(view, found, columns);
        return;
    }
    for (std::uint32_t i = 0; i < view.count; ++i) {
        if (contains(view.place(i))) copy_point(view, i, found);
    }
}

/// A node and how soon it is to be looked at; the smaller number wins, so that results do not depend on
/// chance.
struct Waiting {
    double urgency = 0.0;
    std::uint32_t node = 0;

    bool operator<(const Waiting& other) const noexcept {
        return urgency != other.urgency ? urgency < other.urgency : node > other.node;
    }
};

} // namespace

bool Prism::contains(const Eigen::Vector3d& x_in_scan) const noexcept {
    const Eigen::Vector3d x = prism_from_scan * x_in_scan;
    if (x.z() < z_minimum || x.z() > z_maximum) return false;
    bool inside = false;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const Eigen::Vector2d& a = corners[i];
        const Eigen::Vector2d& b = corners[j];
        if ((a.y() > x.y()) == (b.y() > x.y())) continue;
        if (x.x() < (b.x() - a.x()) * (x.y() - a.y()) / (b.y() - a.y()) + a.x()) inside = !inside;
    }
    return inside;
}

PointStore::PointStore(std::unique_ptr<State> state) : state_(std::move(state)) {}

PointStore::PointStore(PointStore&&) noexcept = default;
PointStore& PointStore::operator=(PointStore&&) noexcept = default;
PointStore::~PointStore() = default;

PointStore PointStore::open(const std::filesystem::path& file) {
    try {
        return PointStore(std::make_unique<State>(file));
    } catch (Error& e) {
        e.add_context(file.string());
        throw;
    }
}

const StoreInfo& PointStore::info() const noexcept { return state_->info; }

std::uint64_t PointStore::points() const noexcept { return state_->header.points; }

std::uint64_t PointStore::file_bytes() const noexcept { return state_->header.file_bytes; }

const Bounds& PointStore::bounds() const noexcept { return state_->bounds; }

std::span<const StoreNodeRecord> PointStore::nodes() const noexcept { return state_->nodes; }

PointBlock PointStore::read_node(std::uint32_t node) const {
    if (node >= state_->nodes.size())
        throw Error(ErrorCode::Usage, fmt::format("no node {}: the store has {}", node, state_->nodes.size()));
    FoundPoints found;
    copy_all(state_->view(node), found, state_->info.has);
    return std::move(found.points);
}

Eigen::Vector3d PointStore::place(const PointRef& ref) const {
    if (ref.node >= state_->nodes.size() || ref.index >= state_->nodes[ref.node].points) {
        throw Error(ErrorCode::Usage, fmt::format("no point {} in node {}", ref.index, ref.node));
    }
    return state_->view(ref.node).place(ref.index);
}

void PointStore::for_each(const FoundSink& sink, Progress& progress) const {
    Meter meter(progress, points());
    std::uint64_t done = 0;
    FoundPoints found;
    for (std::uint32_t node = 0; node < state_->nodes.size(); ++node) {
        meter.at(done);
        clear(found, node);
        copy_all(state_->view(node), found, state_->info.has);
        if (!found.index.empty()) sink(found);
        done += found.index.size();
    }
}

namespace {

/// Walks down from the roots: `overlap` of a node's box decides whether its points and children matter.
template<class OverlapOf, class Contains>
void walk(const std::vector<std::uint32_t>& roots, std::span<const StoreNodeRecord> nodes, const OverlapOf& overlap_of,
          const Contains& look_at) {
    std::vector<std::uint32_t> waiting(roots.rbegin(), roots.rend());
    while (!waiting.empty()) {
        const std::uint32_t node = waiting.back();
        waiting.pop_back();
        const Overlap overlap = overlap_of(node);
        if (overlap == Overlap::None) continue;
        look_at(node, overlap);
        const std::size_t before = waiting.size();
        for_children(nodes[node], [&](std::uint32_t child) { waiting.push_back(child); });
        std::reverse(waiting.begin() + static_cast<std::ptrdiff_t>(before), waiting.end());
    }
}

std::vector<std::uint32_t> first_nodes(std::uint64_t count) {
    std::vector<std::uint32_t> roots(static_cast<std::size_t>(count));
    for (std::uint32_t i = 0; i < roots.size(); ++i) roots[i] = i;
    return roots;
}

} // namespace

void PointStore::in_box(const Box& box, const FoundSink& sink) const {
    const State& s = *state_;
    FoundPoints found;
    walk(
        first_nodes(s.header.roots), s.nodes, [&](std::uint32_t node) { return box_overlap(box, s.box_of(node)); },
        [&](std::uint32_t node, Overlap overlap) {
            clear(found, node);
            filter_node(
                s.view(node), overlap, s.info.has, [&](const Eigen::Vector3d& x) { return box.contains(x); }, found);
            if (!found.index.empty()) sink(found);
        });
}

void PointStore::in_prism(const Prism& prism, const FoundSink& sink) const {
    const State& s = *state_;
    if (prism.corners.size() < 3) return;
    Box around{{1e300, 1e300, prism.z_minimum}, {-1e300, -1e300, prism.z_maximum}};
    for (const Eigen::Vector2d& corner : prism.corners) {
        around.minimum.head<2>() = around.minimum.head<2>().cwiseMin(corner);
        around.maximum.head<2>() = around.maximum.head<2>().cwiseMax(corner);
    }
    around.minimum.array() -= 1e-9;
    around.maximum.array() += 1e-9;
    const auto overlap_of = [&](std::uint32_t node) {
        // The polygon's own shape is tested point by point.
        return box_overlap(around, turned(prism.prism_from_scan, s.box_of(node))) == Overlap::None ? Overlap::None
                                                                                                   : Overlap::Some;
    };
    FoundPoints found;
    walk(first_nodes(s.header.roots), s.nodes, overlap_of, [&](std::uint32_t node, Overlap overlap) {
        clear(found, node);
        filter_node(
            s.view(node), overlap, s.info.has, [&](const Eigen::Vector3d& x) { return prism.contains(x); }, found);
        if (!found.index.empty()) sink(found);
    });
}

std::uint64_t PointStore::in_frustum(const Frustum& frustum, std::uint64_t budget, const FoundSink& sink) const {
    const State& s = *state_;
    std::priority_queue<Waiting> waiting;
    const auto offer = [&](std::uint32_t node) {
        const Box box = s.box_of(node);
        if (plane_overlap(frustum, box) == Overlap::None) return false;
        const double distance = std::sqrt(squared_distance(box, frustum.eye));
        const double edge = std::ldexp(kRootEdge, -s.nodes[node].depth);
        waiting.push({edge / std::max(distance, 0.01), node});
        return true;
    };
    FoundPoints found;
    const auto look_at = [&](std::uint32_t node) {
        const Overlap overlap = plane_overlap(frustum, s.box_of(node));
        clear(found, node);
        filter_node(
            s.view(node), overlap, s.info.has, [&](const Eigen::Vector3d& x) { return frustum.contains(x); }, found);
    };
    std::uint64_t in_roots = 0;
    for (std::uint32_t root = 0; root < s.header.roots; ++root) {
        if (offer(root)) in_roots += s.nodes[root].points;
    }
    // Where not even the roots fit, each gives the same share, so that nothing near or far is missing.
    const double share = in_roots <= budget ? 1.0 : static_cast<double>(budget) / static_cast<double>(in_roots);
    std::uint64_t given = 0;
    while (!waiting.empty() && given < budget) {
        const std::uint32_t node = waiting.top().node;
        waiting.pop();
        look_at(node);
        if (share < 1.0)
            keep_first(found, static_cast<std::size_t>(share * static_cast<double>(found.index.size())), s.info.has);
        keep_first(found, static_cast<std::size_t>(budget - given), s.info.has);
        given += found.index.size();
        if (!found.index.empty()) sink(found);
        if (share == 1.0) for_children(s.nodes[node], offer);
    }
    return given;
}

std::optional<PickedPoint> PointStore::pick(const Ray& ray) const {
    const State& s = *state_;
    std::priority_queue<Waiting> waiting;
    const auto offer = [&](std::uint32_t node) {
        const double reach = first_reach(ray, s.box_of(node));
        if (std::isfinite(reach)) waiting.push({-reach, node});
    };
    for (std::uint32_t root = 0; root < s.header.roots; ++root) offer(root);
    std::optional<PickedPoint> best;
    while (!waiting.empty()) {
        const Waiting next = waiting.top();
        waiting.pop();
        if (best && -next.urgency > best->distance) break;
        const NodeView view = s.view(next.node);
        for (std::uint32_t i = 0; i < view.count; ++i) {
            const Eigen::Vector3d x = view.place(i);
            const double along = ray.hit(x);
            const PointRef ref{next.node, i};
            const bool nearer = !best || along < best->distance || (along == best->distance && ref < best->ref);
            if (along >= 0.0 && nearer) best = PickedPoint{ref, x, along};
        }
        for_children(s.nodes[next.node], offer);
    }
    return best;
}

void PointStore::brush(const Ray& ray, double depth, const FoundSink& sink) const {
    const State& s = *state_;
    const std::optional<PickedPoint> first = pick(ray);
    if (!first) return;
    const double last = first->distance + depth;
    FoundPoints found;
    walk(
        first_nodes(s.header.roots), s.nodes,
        [&](std::uint32_t node) { return first_reach(ray, s.box_of(node)) <= last ? Overlap::Some : Overlap::None; },
        [&](std::uint32_t node, Overlap overlap) {
            clear(found, node);
            const auto touched = [&](const Eigen::Vector3d& x) {
                const double along = ray.hit(x);
                return along >= 0.0 && along <= last;
            };
            filter_node(s.view(node), overlap, s.info.has, touched, found);
            if (!found.index.empty()) sink(found);
        });
}

std::optional<PickedPoint> PointStore::nearest(const Eigen::Vector3d& x_in_scan, double most) const {
    const State& s = *state_;
    std::priority_queue<Waiting> waiting;
    const auto offer = [&](std::uint32_t node) { waiting.push({-squared_distance(s.box_of(node), x_in_scan), node}); };
    for (std::uint32_t root = 0; root < s.header.roots; ++root) offer(root);
    std::optional<PickedPoint> best;
    double best_squared = most * most;
    while (!waiting.empty()) {
        const Waiting next = waiting.top();
        waiting.pop();
        if (-next.urgency > best_squared) break;
        const NodeView view = s.view(next.node);
        for (std::uint32_t i = 0; i < view.count; ++i) {
            const Eigen::Vector3d x = view.place(i);
            const double squared = (x - x_in_scan).squaredNorm();
            const PointRef ref{next.node, i};
            const bool nearer = squared < best_squared || (squared == best_squared && (!best || ref < best->ref));
            if (!nearer) continue;
            best_squared = squared;
            best = PickedPoint{ref, x, std::sqrt(squared)};
        }
        for_children(s.nodes[next.node], offer);
    }
    return best;
}

std::vector<DamagedBlock> PointStore::verify(Progress& progress) const {
    const State& s = *state_;
    Meter meter(progress, points());
    std::vector<DamagedBlock> damaged;
    std::uint64_t done = 0;
    for (std::uint32_t node = 0; node < s.nodes.size(); ++node) {
        meter.at(done);
        const StoreNodeRecord& n = s.nodes[node];
        if (!s.is_sound(node)) damaged.push_back({node, n.block_at, n.points, s.box_of(node)});
        done += n.points;
    }
    return damaged;
}

} // namespace planum::scans
