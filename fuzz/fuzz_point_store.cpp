// SPDX-License-Identifier: MIT
// A store whose checksums fit but whose numbers may be anything.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include "core/base/error.hpp"
#include "scans/cloud/point_store.hpp"
#include "scans/formats/crc32c.hpp"

using namespace planum;
using namespace planum::scans;

namespace {

bool lies_within(std::uint64_t at, std::uint64_t count, std::size_t size) { return at <= size && count <= size - at; }

void mend_checksums(std::string& bytes) {
    StoreHeaderRecord header;
    if (bytes.size() < sizeof header) return;
    std::memcpy(&header, bytes.data(), sizeof header);
    header.file_bytes = bytes.size();
    const std::uint64_t node_bytes = header.nodes * sizeof(StoreNodeRecord);
    if (header.nodes < 100000 && lies_within(header.nodes_at, node_bytes, bytes.size())) {
        const auto count = static_cast<std::size_t>(header.nodes);
        std::uint64_t points = 0;
        for (std::size_t i = 0; i < count; ++i) {
            char* at = bytes.data() + header.nodes_at + i * sizeof(StoreNodeRecord);
            StoreNodeRecord node;
            std::memcpy(&node, at, sizeof node);
            points += node.points;
            const std::uint64_t size = (stored_bytes(header.flags) * node.points + 7) / 8 * 8;
            if (!lies_within(node.block_at, size, bytes.size())) continue;
            node.checksum = crc32c({bytes.data() + node.block_at, static_cast<std::size_t>(size)});
            std::memcpy(at, &node, sizeof node);
        }
        header.points = points;
        header.nodes_checksum = crc32c({bytes.data() + header.nodes_at, static_cast<std::size_t>(node_bytes)});
    }
    if (lies_within(header.text_at, header.text_bytes, bytes.size())) {
        header.text_checksum = crc32c({bytes.data() + header.text_at, static_cast<std::size_t>(header.text_bytes)});
    }
    const char* raw = reinterpret_cast<const char*>(&header);
    header.header_checksum = crc32c({raw, offsetof(StoreHeaderRecord, header_checksum)});
    std::memcpy(bytes.data(), &header, sizeof header);
}

void use(const std::string& bytes) {
    const int descriptor = ::memfd_create("store", 0);
    if (descriptor < 0 || ::write(descriptor, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) return;
    try {
        const PointStore store = PointStore::open(fmt::format("/proc/self/fd/{}", descriptor));
        const FoundSink nowhere = [](const FoundPoints&) {};
        static_cast<void>(store.verify(Progress::none()));
        static_cast<void>(store.nearest({0, 0, 0}, 1e6));
        static_cast<void>(store.pick({{0, 0, 0}, {0, 0, 1}, 1.0, 0.1}));
        store.in_box({{-10, -10, -10}, {10, 10, 10}}, nowhere);
        Frustum frustum;
        store.in_frustum(frustum, 1000, nowhere);
        store.for_each(nowhere, Progress::none());
    } catch (const Error&) {
    }
    ::close(descriptor);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string bytes(reinterpret_cast<const char*>(data), size);
    mend_checksums(bytes);
    use(bytes);
    return 0;
}
