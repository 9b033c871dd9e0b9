// SPDX-License-Identifier: MIT
#include "scans/cloud/mapped_store.hpp"

#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "scans/formats/crc32c.hpp"

namespace planum::scans {

namespace {

[[noreturn]] void unsound(const std::string& what) {
    throw Error(ErrorCode::BadInput, "no sound point store: " + what + "; make it anew from the original scan");
}

// Wide enough that no sum of two of them overflows.
constexpr std::uint64_t kLargestFile = 1ULL << 60U;

Eigen::Vector3d vector_of(const std::array<double, 3>& a) noexcept { return {a[0], a[1], a[2]}; }

} // namespace

FileMap::FileMap(const std::filesystem::path& file) {
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) {
        const ErrorCode code = errno == ENOENT ? ErrorCode::NotFound : ErrorCode::Io;
        throw Error(code, std::string("cannot be opened: ") + std::strerror(errno));
    }

    struct stat status {};

    void* mapped = MAP_FAILED;
    if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0) {
        size_ = static_cast<std::size_t>(status.st_size);
        mapped = ::mmap(nullptr, size_, PROT_READ, MAP_SHARED, descriptor, 0);
    }
    ::close(descriptor);
    if (mapped == MAP_FAILED) throw Error(ErrorCode::BadInput, "no point store: empty, or no ordinary file");
    data_ = static_cast<const char*>(mapped);
}

FileMap::~FileMap() {
    if (data_ != nullptr) ::munmap(const_cast<char*>(data_), size_);
}

PointStore::State::State(const std::filesystem::path& path) : file(path), map(path) {
    check_header();
    nodes = {reinterpret_cast<const StoreNodeRecord*>(map.bytes().data() + header.nodes_at),
             static_cast<std::size_t>(header.nodes)};
    check_nodes();
    read_text();
    checked = std::vector<std::atomic<std::uint8_t>>(nodes.size());
}

void PointStore::State::check_header() {
    const std::span<const char> bytes = map.bytes();
    if (bytes.size() < sizeof header) unsound(fmt::format("{} bytes", bytes.size()));
    std::memcpy(&header, bytes.data(), sizeof header);
    if (header.magic != kStoreMagic) unsound("it does not start as one");
    if (header.version != kStoreVersion) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("point store of version {}, this program knows {}", header.version, kStoreVersion));
    }
    if (crc32c(bytes.first(offsetof(StoreHeaderRecord, header_checksum))) != header.header_checksum)
        unsound("its header is damaged");
    if (header.file_bytes != bytes.size() || header.file_bytes > kLargestFile) {
        unsound(fmt::format("{} bytes instead of {}", bytes.size(), header.file_bytes));
    }
    // No number is believed because a checksum fits: whoever writes the file can write that, too.
    const bool nodes_fit = header.nodes_at <= bytes.size() && header.nodes_at % alignof(StoreNodeRecord) == 0 &&
                           header.nodes <= (bytes.size() - header.nodes_at) / sizeof(StoreNodeRecord) &&
                           header.nodes < 0xFFFFFFFFULL && header.roots <= header.nodes;
    const bool text_fits = header.text_at <= bytes.size() && header.text_bytes <= bytes.size() - header.text_at;
    if (!nodes_fit || !text_fits) unsound("its tables lie outside of it");
    if (header.root_edge != kRootEdge || !vector_of(header.origin).allFinite()) unsound("its frame is impossible");
    if (crc32c(bytes.subspan(header.nodes_at, header.nodes * sizeof(StoreNodeRecord))) != header.nodes_checksum)
        unsound("its node table is damaged");
    if (crc32c(bytes.subspan(header.text_at, header.text_bytes)) != header.text_checksum)
        unsound("its description is damaged");
    bounds = {header.minimum, header.maximum};
}

void PointStore::State::check_children(std::size_t node) const {
    const StoreNodeRecord& n = nodes[node];
    const auto count = static_cast<std::size_t>(std::popcount(n.child_mask));
    if (count == 0) return;
    if (n.depth >= kDeepest || n.first_child <= node || n.first_child + count > nodes.size())
        unsound(fmt::format("children of node {}", node));
    std::size_t at = n.first_child;
    for (unsigned octant = 0; octant < 8; ++octant) {
        if ((n.child_mask >> octant & 1U) == 0) continue;
        const StoreNodeRecord& child = nodes[at++];
        bool fits = child.depth == n.depth + 1;
        // Its place in space says whose child it is: so no node has two parents, and walks end.
        for (std::size_t axis = 0; axis < 3 && fits; ++axis) {
            fits = child.cell[axis] == 2 * n.cell[axis] + static_cast<std::int32_t>(octant >> axis & 1U);
        }
        if (!fits) unsound(fmt::format("children of node {}", node));
    }
}

void PointStore::State::check_nodes() const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const StoreNodeRecord& n = nodes[i];
        const std::uint64_t bytes = (stored_bytes(header.flags) * n.points + 7) / 8 * 8;
        if (n.block_at % 8 != 0 || n.block_at > header.nodes_at || bytes > header.nodes_at - n.block_at ||
            n.depth > kDeepest) {
            unsound(fmt::format("the block of node {} lies outside of it", i));
        }
        const std::int64_t reach = static_cast<std::int64_t>(kFarthestRoot) << n.depth;
        for (const std::int32_t cell : n.cell) {
            if (cell < -reach || cell >= reach) unsound(fmt::format("the place of node {}", i));
        }
        if (i < header.roots && n.depth != 0) unsound(fmt::format("node {} is no root", i));
        check_children(i);
        sum += n.points;
    }
    if (sum != header.points) unsound(fmt::format("{} points instead of {}", sum, header.points));
}

void PointStore::State::read_text() {
    info.has.intensity = (header.flags & kStoreIntensity) != 0;
    info.has.grid = (header.flags & kStoreGrid) != 0;
    info.has.colour = (header.flags & kStoreColour) != 0;
    const auto number = [](std::string_view value) {
        return static_cast<std::uint64_t>(text::parse_integer(value).value_or(0));
    };
    for (const std::string_view line :
         text::split({map.bytes().data() + header.text_at, static_cast<std::size_t>(header.text_bytes)}, '\n')) {
        const std::size_t cut = line.find(' ');
        if (cut == std::string_view::npos) continue;
        const std::string_view key = line.substr(0, cut);
        const std::string_view value = line.substr(cut + 1);
        if (key == "name") info.name = std::string(value);
        if (key == "sha256") info.source_sha256 = std::string(value);
        if (key == "cloud") info.source_cloud = number(value);
        if (key == "intensity_offset") info.intensity.offset = text::parse_double(value).value_or(0.0);
        if (key == "intensity_scale") info.intensity.scale = text::parse_double(value).value_or(1.0);
        if (key == "rows") info.rows = number(value);
        if (key == "columns") info.columns = number(value);
        if (key == "attribute") info.attributes.emplace_back(value);
    }
}

Box PointStore::State::box_of(std::uint32_t node) const noexcept {
    const StoreNodeRecord& n = nodes[node];
    const double edge = std::ldexp(kRootEdge, -n.depth);
    const double step = edge / 65536.0;
    Box box;
    for (int k = 0; k < 3; ++k) {
        const auto axis = static_cast<std::size_t>(k);
        const double corner = header.origin[axis] + edge * n.cell[axis];
        // Points below stand in the middle of finer steps, so the whole step counts.
        box.minimum[k] = corner + step * n.low[axis];
        box.maximum[k] = corner + step * (n.high[axis] + 1.0);
    }
    return box;
}

std::span<const char> PointStore::State::block_of(std::uint32_t node) const noexcept {
    const StoreNodeRecord& n = nodes[node];
    const std::uint64_t bytes = (stored_bytes(header.flags) * n.points + 7) / 8 * 8;
    return map.bytes().subspan(static_cast<std::size_t>(n.block_at), static_cast<std::size_t>(bytes));
}

bool PointStore::State::is_sound(std::uint32_t node) const noexcept {
    return crc32c(block_of(node)) == nodes[node].checksum;
}

NodeView PointStore::State::view(std::uint32_t node) const {
    const StoreNodeRecord& n = nodes[node];
    if (checked[node].load(std::memory_order_relaxed) == 0) {
        if (!is_sound(node)) {
            throw Error(
                ErrorCode::BadInput,
                fmt::format(
                    "{}: block {} with {} points is damaged; planum verify makes it again from the original scan",
                    file.string(), node, n.points));
        }
        checked[node].store(1, std::memory_order_relaxed);
    }
    NodeView view;
    const double edge = std::ldexp(kRootEdge, -n.depth);
    view.step = edge / 65536.0;
    for (int k = 0; k < 3; ++k) {
        view.corner[k] = header.origin[static_cast<std::size_t>(k)] + edge * n.cell[static_cast<std::size_t>(k)];
    }
    view.count = n.points;
    const auto* at = reinterpret_cast<const std::uint16_t*>(block_of(node).data());
    const auto next = [&] {
        const std::uint16_t* here = at;
        at += n.points;
        return here;
    };
    for (const std::uint16_t*& axis : view.axis) axis = next();
    if (info.has.intensity) view.intensity = next();
    if (info.has.grid) {
        view.row = next();
        view.column = next();
    }
    if (info.has.colour) view.colour = reinterpret_cast<const Rgb*>(at);
    return view;
}

} // namespace planum::scans
