// SPDX-License-Identifier: MIT
#include "scans/cloud/store_builder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <tuple>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "scans/cloud/point_spill.hpp"
#include "scans/cloud/store_file.hpp"
#include "scans/cloud/store_layout.hpp"
#include "scans/cloud/thinning.hpp"
#include "scans/formats/block_builder.hpp"
#include "scans/formats/crc32c.hpp"

namespace planum::scans {

namespace {

/// A node with no more points than this is not divided.
constexpr std::uint64_t kLeafPoints = 20000;
constexpr std::uint64_t kGridLimit = 65536;

using Cell = std::array<std::int32_t, 3>;

struct CellLess {
    bool operator()(const Cell& a, const Cell& b) const noexcept {
        return std::tie(a[2], a[1], a[0]) < std::tie(b[2], b[1], b[0]);
    }
};

/// A node while the tree is being made.
struct BuiltNode {
    StoreNodeRecord record;
    std::array<std::int64_t, 8> children = {-1, -1, -1, -1, -1, -1, -1, -1};
};

void widen(StoreNodeRecord& node, const PackedPoint& point) noexcept {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::uint16_t step = point.step(axis, node.depth);
        node.low[axis] = std::min(node.low[axis], step);
        node.high[axis] = std::max(node.high[axis], step);
    }
}

StoreNodeRecord empty_node(const Cell& cell, unsigned depth) noexcept {
    StoreNodeRecord node;
    node.cell = cell;
    node.depth = static_cast<std::uint8_t>(depth);
    node.low.fill(65535);
    return node;
}

Cell child_cell(const Cell& cell, unsigned octant) noexcept {
    return {2 * cell[0] + static_cast<std::int32_t>(octant & 1U),
            2 * cell[1] + static_cast<std::int32_t>(octant >> 1U & 1U),
            2 * cell[2] + static_cast<std::int32_t>(octant >> 2U & 1U)};
}

std::string info_text(const StoreInfo& info) {
    std::string out;
    const auto line = [&](std::string_view key, std::string_view value) {
        out += fmt::format("{} {}\n", key, text::replace_all(text::clean_utf8(value).text, "\n", " "));
    };
    line("name", info.name);
    line("sha256", info.source_sha256);
    line("cloud", fmt::format("{}", info.source_cloud));
    line("intensity_offset", fmt::format("{}", info.intensity.offset));
    line("intensity_scale", fmt::format("{}", info.intensity.scale));
    line("rows", fmt::format("{}", info.rows));
    line("columns", fmt::format("{}", info.columns));
    for (const std::string& attribute : info.attributes) line("attribute", attribute);
    return out;
}

} // namespace

struct StoreBuilder::State {
    State(const std::filesystem::path& target, StoreInfo stored, StoreOptions chosen)
        : file(target), spill(target.has_parent_path() ? target.parent_path() : std::filesystem::path(".")),
          info(std::move(stored)), options(chosen) {
        header.flags = (info.has.intensity ? kStoreIntensity : 0U) | (info.has.grid ? kStoreGrid : 0U) |
                       (info.has.colour ? kStoreColour : 0U);
        const std::array<char, sizeof(StoreHeaderRecord)> room{};
        file.append(room);
    }

    void add_point(const PackedPoint& point, PointBucket& bucket) {
        const std::uint64_t before = bucket.memory();
        bucket.add(point);
        in_memory += bucket.memory() - before;
    }

    [[nodiscard]] PointBucket& root_of(const Cell& cell) {
        if (last_root != nullptr && cell == last_cell) return *last_root;
        last_cell = cell;
        last_root = &roots[cell];
        return *last_root;
    }

    void spill_all() {
        for (auto& [cell, bucket] : roots) bucket.spill(spill);
        in_memory = 0;
    }

    std::int64_t build_bucket(PointBucket& bucket, const Cell& cell, unsigned depth, Meter& meter);
    std::int64_t divide_on_disk(PointBucket& bucket, const Cell& cell, unsigned depth, Meter& meter);
    std::int64_t build_in_memory(std::span<PackedPoint> points, std::span<PackedPoint> scratch, const Cell& cell,
                                 unsigned depth);
    void write_block(StoreNodeRecord& node, std::span<const PackedPoint> unordered);
    std::vector<StoreNodeRecord> ordered_nodes(const std::vector<std::int64_t>& root_nodes) const;

    StoreFile file;
    SpillFile spill;
    StoreInfo info;
    StoreOptions options;
    StoreHeaderRecord header;
    Bounds bounds;
    bool has_origin = false;
    std::uint64_t too_far = 0;
    std::uint64_t in_memory = 0;
    std::uint64_t written = 0; ///< points
    std::map<Cell, PointBucket, CellLess> roots;
    Cell last_cell{};
    PointBucket* last_root = nullptr;
    std::vector<BuiltNode> nodes;
    CoarseToFine coarse_to_fine;
    std::vector<char> block;
    std::vector<std::uint8_t> codes;
};

StoreBuilder::StoreBuilder(const std::filesystem::path& file, StoreInfo info, StoreOptions options)
    : state_(std::make_unique<State>(file, std::move(info), options)) {}

StoreBuilder::~StoreBuilder() = default;

void StoreBuilder::add(const PointBlock& block) {
    State& s = *state_;
    const Columns& has = s.info.has;
    const std::size_t size = block.size();
    if ((has.intensity && block.intensity.size() != size) || (has.colour && block.colour.size() != size) ||
        (has.grid && (block.row.size() != size || block.column.size() != size))) {
        throw Error(ErrorCode::Usage, "a block of points lacks columns that the store was told to expect");
    }
    for (std::size_t i = 0; i < size; ++i) {
        if (block.validity[i] != Validity::Valid) continue;
        const std::array<double, 3> x = {block.x[i], block.y[i], block.z[i]};
        if (!s.has_origin) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                s.header.origin[axis] = std::floor(x[axis] / kRootEdge) * kRootEdge;
            s.has_origin = true;
        }
        PackedPoint point;
        Cell cell{};
        bool near = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double along = (x[axis] - s.header.origin[axis]) / kRootEdge;
            const double whole = std::floor(along);
            near = near && std::abs(whole) < kFarthestRoot;
            if (!near) break;
            cell[axis] = static_cast<std::int32_t>(whole);
            // Just below the next cube rounding may give 1.0 exactly.
            point.place[axis] = static_cast<std::uint32_t>(std::min((along - whole) * 4294967296.0, 4294967295.0));
        }
        if (!near) {
            ++s.too_far;
            continue;
        }
        if (has.intensity) point.intensity = block.intensity[i];
        if (has.colour) point.colour = block.colour[i];
        if (has.grid) {
            point.row = static_cast<std::uint16_t>(block.row[i]);
            point.column = static_cast<std::uint16_t>(block.column[i]);
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            s.bounds.minimum[axis] = std::min(s.bounds.minimum[axis], x[axis]);
            s.bounds.maximum[axis] = std::max(s.bounds.maximum[axis], x[axis]);
        }
        s.add_point(point, s.root_of(cell));
        ++s.header.points;
    }
    if (s.in_memory > s.options.memory_bytes) s.spill_all();
}

// Blocks are columns: all x, all y, all z, intensities, rows, columns, colours.
void StoreBuilder::State::write_block(StoreNodeRecord& node, std::span<const PackedPoint> unordered) {
    const std::span<const PackedPoint> points = coarse_to_fine.order(unordered, node.depth);
    const std::size_t count = points.size();
    const auto bytes = static_cast<std::size_t>(stored_bytes(header.flags)) * count;
    block.resize((bytes + 7) / 8 * 8);
    std::fill(block.begin() + static_cast<std::ptrdiff_t>(bytes), block.end(), '\0');
    char* at = block.data();
    const auto put = [&](auto value_of) {
        for (const PackedPoint& point : points) {
            const std::uint16_t value = value_of(point);
            std::memcpy(at, &value, sizeof value);
            at += sizeof value;
        }
    };
    const unsigned depth = node.depth;
    for (std::size_t axis = 0; axis < 3; ++axis) put([&](const PackedPoint& p) { return p.step(axis, depth); });
    if ((header.flags & kStoreIntensity) != 0) put([](const PackedPoint& p) { return p.intensity; });
    if ((header.flags & kStoreGrid) != 0) {
        put([](const PackedPoint& p) { return p.row; });
        put([](const PackedPoint& p) { return p.column; });
    }
    if ((header.flags & kStoreColour) != 0) {
        for (const PackedPoint& point : points) {
            *at++ = static_cast<char>(point.colour.red);
            *at++ = static_cast<char>(point.colour.green);
            *at++ = static_cast<char>(point.colour.blue);
        }
    }
    node.block_at = file.size();
    node.points = static_cast<std::uint32_t>(count);
    node.checksum = crc32c(block);
    file.append(block);
    written += count;
}

std::int64_t StoreBuilder::State::build_in_memory(std::span<PackedPoint> points, std::span<PackedPoint> scratch,
                                                  const Cell& cell, unsigned depth) {
    const auto index = static_cast<std::int64_t>(nodes.size());
    nodes.emplace_back();
    StoreNodeRecord node = empty_node(cell, depth);
    node.subtree_points = points.size();
    for (const PackedPoint& point : points) widen(node, point);
    if (points.size() <= kLeafPoints || depth == kDeepest) {
        write_block(node, points);
        nodes[static_cast<std::size_t>(index)].record = node;
        return index;
    }
    // One pass says where each point goes, one moves it; both keep the order in which they came.
    constexpr std::size_t kKept = 8;
    std::array<std::size_t, 9> counts{};
    codes.resize(points.size());
    const auto sampler = std::make_unique<Sampler>(depth);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t code = sampler->keeps(points[i]) ? kKept : points[i].octant(depth);
        codes[i] = static_cast<std::uint8_t>(code);
        ++counts[code];
    }
    std::array<std::size_t, 9> from{};
    for (std::size_t code = 1; code < 9; ++code) from[code] = from[code - 1] + counts[code - 1];
    std::array<std::size_t, 9> to = from;
    for (std::size_t i = 0; i < points.size(); ++i) scratch[to[codes[i]]++] = points[i];
    write_block(node, scratch.subspan(from[kKept], counts[kKept]));
    for (unsigned octant = 0; octant < 8; ++octant) {
        if (counts[octant] == 0) continue;
        node.child_mask = static_cast<std::uint8_t>(node.child_mask | 1U << octant);
        const std::int64_t child =
            build_in_memory(scratch.subspan(from[octant], counts[octant]), points.subspan(from[octant], counts[octant]),
                            child_cell(cell, octant), depth + 1);
        nodes[static_cast<std::size_t>(index)].children[octant] = child;
    }
    nodes[static_cast<std::size_t>(index)].record = node;
    return index;
}

// A cube with more points than fit: the sample stays in memory, the rest goes to eight buckets.
std::int64_t StoreBuilder::State::divide_on_disk(PointBucket& bucket, const Cell& cell, unsigned depth, Meter& meter) {
    const auto index = static_cast<std::int64_t>(nodes.size());
    nodes.emplace_back();
    StoreNodeRecord node = empty_node(cell, depth);
    node.subtree_points = bucket.count();
    std::array<PointBucket, 8> parts;
    std::vector<PackedPoint> sample;
    const auto sampler = std::make_unique<Sampler>(depth);
    bucket.for_each_piece(spill, [&](std::span<const PackedPoint> piece) {
        for (const PackedPoint& point : piece) {
            widen(node, point);
            if (sampler->keeps(point))
                sample.push_back(point);
            else
                add_point(point, parts[point.octant(depth)]);
        }
        if (in_memory <= options.memory_bytes) return;
        for (PointBucket& part : parts) {
            in_memory -= part.memory();
            part.spill(spill);
        }
        meter.at(written);
    });
    in_memory -= bucket.memory();
    bucket.clear();
    write_block(node, sample);
    for (unsigned octant = 0; octant < 8; ++octant) {
        if (parts[octant].count() == 0) continue;
        node.child_mask = static_cast<std::uint8_t>(node.child_mask | 1U << octant);
        const std::int64_t child = build_bucket(parts[octant], child_cell(cell, octant), depth + 1, meter);
        nodes[static_cast<std::size_t>(index)].children[octant] = child;
    }
    nodes[static_cast<std::size_t>(index)].record = node;
    return index;
}

std::int64_t StoreBuilder::State::build_bucket(PointBucket& bucket, const Cell& cell, unsigned depth, Meter& meter) {
    meter.at(written);
    const bool fits = bucket.count() * 2 * sizeof(PackedPoint) <= options.memory_bytes;
    if (!fits && bucket.count() > kLeafPoints && depth < kDeepest) return divide_on_disk(bucket, cell, depth, meter);
    if (bucket.count() > 0xFFFFFFFFULL)
        throw Error(ErrorCode::BadInput, "over four thousand million points within a tenth of a millimetre");
    in_memory -= bucket.memory();
    std::vector<PackedPoint> points = bucket.take_all(spill);
    std::vector<PackedPoint> scratch(points.size() > kLeafPoints ? points.size() : 0);
    return build_in_memory(points, scratch, cell, depth);
}

// Level by level, so that the children of a node stand together behind it.
std::vector<StoreNodeRecord> StoreBuilder::State::ordered_nodes(const std::vector<std::int64_t>& root_nodes) const {
    std::vector<std::int64_t> order = root_nodes;
    std::vector<StoreNodeRecord> records;
    records.reserve(nodes.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const BuiltNode& node = nodes[static_cast<std::size_t>(order[i])];
        records.push_back(node.record);
        if (node.record.child_mask != 0) records.back().first_child = static_cast<std::uint32_t>(order.size());
        for (const std::int64_t child : node.children) {
            if (child >= 0) order.push_back(child);
        }
    }
    return records;
}

StoreSummary StoreBuilder::finish(Progress& progress) {
    State& s = *state_;
    Meter meter(progress, s.header.points);
    std::vector<std::int64_t> root_nodes;
    for (auto& [cell, bucket] : s.roots) root_nodes.push_back(s.build_bucket(bucket, cell, 0, meter));
    meter.at(s.header.points);
    const std::vector<StoreNodeRecord> records = s.ordered_nodes(root_nodes);
    const std::span<const char> node_bytes(reinterpret_cast<const char*>(records.data()),
                                           records.size() * sizeof(StoreNodeRecord));
    const std::string text = info_text(s.info);
    StoreHeaderRecord& header = s.header;
    header.minimum = s.bounds.minimum;
    header.maximum = s.bounds.maximum;
    header.nodes_at = s.file.size();
    header.nodes = records.size();
    header.roots = root_nodes.size();
    header.nodes_checksum = crc32c(node_bytes);
    s.file.append(node_bytes);
    header.text_at = s.file.size();
    header.text_bytes = text.size();
    header.text_checksum = crc32c(text);
    s.file.append(text);
    header.file_bytes = s.file.size();
    const std::span<const char> head(reinterpret_cast<const char*>(&header), sizeof header);
    header.header_checksum = crc32c(head.first(offsetof(StoreHeaderRecord, header_checksum)));
    s.file.commit(head);
    StoreSummary summary;
    summary.points = header.points;
    summary.too_far = s.too_far;
    summary.nodes = header.nodes;
    summary.file_bytes = header.file_bytes;
    s.roots.clear();
    summary.coordinate_bytes = 6 * header.points + node_bytes.size() + sizeof header;
    return summary;
}

StoreInfo store_info(const CloudHeader& header, std::string name, std::string source_sha256,
                     std::uint64_t source_cloud) {
    StoreInfo info;
    info.name = std::move(name);
    info.source_sha256 = std::move(source_sha256);
    info.source_cloud = source_cloud;
    info.has = header.has;
    info.has.time = false;
    info.has.grid = header.has.grid && header.rows <= kGridLimit && header.columns <= kGridLimit;
    info.intensity = header.intensity;
    info.rows = info.has.grid ? header.rows : 0;
    info.columns = info.has.grid ? header.columns : 0;
    info.attributes = header.attributes;
    return info;
}

StoreSummary build_store(ScanReader& reader, std::size_t cloud, const std::filesystem::path& file, StoreInfo info,
                         const StoreOptions& options, Progress& progress) {
    const std::string name = info.name;
    StoreBuilder builder(file, std::move(info), options);
    reader.read(
        cloud, [&](const PointBlock& block) { builder.add(block); }, {}, progress);
    progress.step("sorting the points of " + name);
    return builder.finish(progress);
}

} // namespace planum::scans
