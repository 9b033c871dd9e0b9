// SPDX-License-Identifier: MIT
// A geometry blob: refused with an Error, or read; what was read is written and read again the same.
#include <cstdlib>
#include <span>

#include "core/base/error.hpp"
#include "core/geometry/gpb.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span<const std::byte> blob{reinterpret_cast<const std::byte*>(data), size};
    try {
        const planum::geometry::Geometry geometry = planum::geometry::decode_gpb(blob);
        const auto again = planum::geometry::decode_gpb(planum::geometry::encode_gpb(geometry));
        if (again.srs_id != geometry.srs_id) std::abort();
    } catch (const planum::Error&) {
        // Refused in a sentence, which is what is wanted.
    }
    return 0;
}
