// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scans/formats/cloud_header.hpp"
#include "scans/formats/e57_fields.hpp"

namespace planum::scans {

/// One scan as the XML part describes it.
struct E57Cloud {
    CloudHeader header;
    std::vector<E57Field> fields;    ///< in the order of the byte streams
    std::uint64_t points_offset = 0; ///< physical
    std::int64_t first_row = 0;      ///< rowIndex of our row 0
    std::int64_t first_column = 0;
    bool grid_stated = false; ///< the XML says how many rows and columns there are
    Limits colour;            ///< what becomes 0 … 255
    bool cartesian = false;   ///< else spherical, or nothing at all
};

struct E57Image {
    ImageHeader header;
    std::uint64_t offset = 0; ///< physical, of the blob section
};

struct E57Metadata {
    std::string guid;
    std::string software;
    std::string created_at;
    std::string coordinate_system;
    std::vector<E57Cloud> clouds;
    std::vector<E57Image> images;
    std::vector<std::string> notes;
};

/// Reads the XML part. Throws BadInput that names the element.
[[nodiscard]] E57Metadata parse_e57_xml(std::string_view xml);

} // namespace planum::scans
