// SPDX-License-Identifier: MIT
#include "scans/formats/e57_metadata.hpp"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "scans/formats/gps_time.hpp"
#include "scans/formats/rigid_pose.hpp"

namespace planum::scans {

namespace {

constexpr std::size_t kMostFields = 256;

[[noreturn]] void bad(const pugi::xml_node& node, std::string_view message) {
    throw Error(ErrorCode::BadInput, fmt::format("xml element {}: {}", node.path(), message));
}

std::string clean(const char* bytes) { return text::clean_utf8(text::trim(bytes)).text; }

std::string string_of(const pugi::xml_node& parent, const char* name) { return clean(parent.child(name).text().get()); }

// Text of an integer or attribute; empty is `fallback`.
std::int64_t integer_of(const pugi::xml_node& node, std::string_view digits, std::int64_t fallback) {
    digits = text::trim(digits);
    if (digits.empty()) return fallback;
    const std::optional<long long> value = text::parse_integer(digits);
    if (!value) bad(node, fmt::format("'{}' is no integer", digits.substr(0, 40)));
    return *value;
}

double real_of(const pugi::xml_node& node, std::string_view digits, double fallback) {
    digits = text::trim(digits);
    if (digits.empty()) return fallback;
    if (digits.front() == '+') digits.remove_prefix(1);
    double value = 0.0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool read = end == digits.data() + digits.size();
    if (problem == std::errc::result_out_of_range && read) return fallback; // 1e-400 is as good as nothing
    if (problem != std::errc{} || !read) bad(node, fmt::format("'{}' is no number", digits.substr(0, 40)));
    return value;
}

// A number of any of the three types; an empty element is 0.
double number_of(const pugi::xml_node& node) {
    const double raw = real_of(node, node.text().get(), 0.0);
    if (std::strcmp(node.attribute("type").value(), "ScaledInteger") != 0) return raw;
    return raw * real_of(node, node.attribute("scale").value(), 1.0) +
           real_of(node, node.attribute("offset").value(), 0.0);
}

std::uint64_t natural_of(const pugi::xml_node& node, const char* attribute) {
    const std::int64_t value = integer_of(node, node.attribute(attribute).value(), 0);
    if (value < 0) bad(node, fmt::format("{} is negative", attribute));
    return static_cast<std::uint64_t>(value);
}

std::optional<Limits> limits_of(const pugi::xml_node& parent, const char* minimum, const char* maximum) {
    const pugi::xml_node low = parent.child(minimum);
    const pugi::xml_node high = parent.child(maximum);
    if (!low || !high) return std::nullopt;
    const Limits limits{number_of(low), number_of(high)};
    if (!std::isfinite(limits.minimum) || !std::isfinite(limits.maximum)) return std::nullopt;
    return limits;
}

std::string time_of(const pugi::xml_node& parent, const char* name) {
    return iso_time_of_gps(number_of(parent.child(name).child("dateTimeValue")));
}

Eigen::Isometry3d pose_of(const pugi::xml_node& pose, std::vector<std::string>& notes) {
    const pugi::xml_node r = pose.child("rotation");
    const pugi::xml_node t = pose.child("translation");
    const auto part = [](const pugi::xml_node& parent, const char* name) { return number_of(parent.child(name)); };
    const Eigen::Vector3d translation(part(t, "x"), part(t, "y"), part(t, "z"));
    double w = part(r, "w");
    if (w == 0.0 && part(r, "x") == 0.0 && part(r, "y") == 0.0 && part(r, "z") == 0.0) {
        if (r) notes.emplace_back("the pose's quaternion is zero; taken as no rotation");
        w = 1.0;
    }
    return pose_from_quaternion(w, part(r, "x"), part(r, "y"), part(r, "z"), translation);
}

E57Field field_of(const pugi::xml_node& node) {
    E57Field field;
    field.name = clean(node.name());
    const std::string_view type = node.attribute("type").value();
    if (type == "Integer" || type == "ScaledInteger") {
        field.kind = type == "Integer" ? E57Kind::Integer : E57Kind::ScaledInteger;
        field.minimum = integer_of(node, node.attribute("minimum").value(), INT64_MIN);
        field.maximum = integer_of(node, node.attribute("maximum").value(), INT64_MAX);
        if (field.maximum < field.minimum) bad(node, "maximum below minimum");
        field.bits = static_cast<unsigned>(
            std::bit_width(static_cast<std::uint64_t>(field.maximum) - static_cast<std::uint64_t>(field.minimum)));
        if (field.kind == E57Kind::ScaledInteger) {
            field.scale = real_of(node, node.attribute("scale").value(), 1.0);
            field.offset = real_of(node, node.attribute("offset").value(), 0.0);
        }
    } else if (type == "Float") {
        const bool single = std::strcmp(node.attribute("precision").value(), "single") == 0;
        field.kind = single ? E57Kind::Float : E57Kind::Double;
        field.bits = single ? 32 : 64;
    } else if (type == "String") {
        field.kind = E57Kind::String;
    } else {
        bad(node, fmt::format("values of type '{}' in a table of points", type));
    }
    return field;
}

const E57Field* find_field(const E57Cloud& cloud, std::string_view name) {
    for (const E57Field& field : cloud.fields) {
        if (field.name == name) return &field;
    }
    return nullptr;
}

// What a stored step of intensity means: whole numbers of up to 16 bits are kept as they are, the rest
// is spread over 16 bits between the limits that are stated.
IntensityCoding coding_of(const pugi::xml_node& prototype, const E57Field& field, const std::optional<Limits>& stated) {
    const bool whole = field.kind == E57Kind::Integer || field.kind == E57Kind::ScaledInteger;
    if (whole && field.bits <= 16 && std::isfinite(field.scale) && field.scale > 0.0) {
        const bool as_is = field.minimum >= 0 && field.maximum <= 65535;
        return {as_is ? field.offset : field.scaled(field.minimum), field.scale};
    }
    if (stated && stated->maximum > stated->minimum)
        return {stated->minimum, (stated->maximum - stated->minimum) / 65535.0};
    const pugi::xml_node node = prototype.child("intensity");
    const double low = real_of(node, node.attribute("minimum").value(), 0.0);
    const double high = real_of(node, node.attribute("maximum").value(), 1.0);
    const bool usable = !whole && high > low && std::isfinite(high - low) && high - low < 1e30;
    return usable ? IntensityCoding{low, (high - low) / 65535.0} : IntensityCoding{0.0, 1.0 / 65535.0};
}

void read_grid(const pugi::xml_node& scan, E57Cloud& cloud) {
    cloud.header.has.grid = find_field(cloud, "rowIndex") != nullptr && find_field(cloud, "columnIndex") != nullptr;
    const pugi::xml_node bounds = scan.child("indexBounds");
    if (!cloud.header.has.grid || !bounds.child("rowMaximum") || !bounds.child("columnMaximum")) return;
    const auto bound = [&](const char* name) {
        const pugi::xml_node node = bounds.child(name);
        return integer_of(node, node.text().get(), 0);
    };
    cloud.first_row = bound("rowMinimum");
    cloud.first_column = bound("columnMinimum");
    const std::uint64_t rows =
        static_cast<std::uint64_t>(bound("rowMaximum")) - static_cast<std::uint64_t>(cloud.first_row);
    const std::uint64_t columns =
        static_cast<std::uint64_t>(bound("columnMaximum")) - static_cast<std::uint64_t>(cloud.first_column);
    if (rows >= 0xFFFFFFFFULL || columns >= 0xFFFFFFFFULL) bad(bounds, "no sensible range of rows and columns");
    cloud.grid_stated = true;
    cloud.header.rows = rows + 1;
    cloud.header.columns = columns + 1;
    if (rows == 0 && columns == 0 && cloud.header.records > 1) {
        cloud.header.has.grid = false;
        cloud.header.rows = cloud.header.columns = 0;
        cloud.header.notes.emplace_back("all points are said to stand in one row and column; taken as no grid");
    }
}

void read_limits(const pugi::xml_node& scan, const pugi::xml_node& prototype, E57Cloud& cloud) {
    CloudHeader& header = cloud.header;
    const pugi::xml_node intensity = scan.child("intensityLimits");
    header.intensity_limits = limits_of(intensity, "intensityMinimum", "intensityMaximum");
    if (const E57Field* field = find_field(cloud, "intensity")) {
        header.has.intensity = true;
        header.intensity = coding_of(prototype, *field, header.intensity_limits);
    }
    header.colour_limits = limits_of(scan.child("colorLimits"), "colorRedMinimum", "colorRedMaximum");
    const E57Field* red = find_field(cloud, "colorRed");
    header.has.colour =
        red != nullptr && find_field(cloud, "colorGreen") != nullptr && find_field(cloud, "colorBlue") != nullptr;
    if (!header.has.colour) return;
    const bool whole = red->kind == E57Kind::Integer || red->kind == E57Kind::ScaledInteger;
    cloud.colour = {0.0, 255.0};
    if (header.colour_limits && header.colour_limits->maximum > header.colour_limits->minimum) {
        cloud.colour = *header.colour_limits;
    } else if (whole && red->bits > 0 && red->bits <= 16) {
        cloud.colour = {red->scaled(red->minimum), red->scaled(red->maximum)};
    }
}

std::optional<Bounds> bounds_of(const pugi::xml_node& scan) {
    const pugi::xml_node bounds = scan.child("cartesianBounds");
    const auto x = limits_of(bounds, "xMinimum", "xMaximum");
    const auto y = limits_of(bounds, "yMinimum", "yMaximum");
    const auto z = limits_of(bounds, "zMinimum", "zMaximum");
    if (!x || !y || !z) return std::nullopt;
    return Bounds{{x->minimum, y->minimum, z->minimum}, {x->maximum, y->maximum, z->maximum}};
}

std::string sensor_of(const pugi::xml_node& scan) {
    std::string sensor;
    for (const char* name : {"sensorVendor", "sensorModel", "sensorSerialNumber"}) {
        const std::string part = string_of(scan, name);
        if (part.empty()) continue;
        if (!sensor.empty()) sensor += ' ';
        sensor += part;
    }
    return sensor;
}

E57Cloud cloud_of(const pugi::xml_node& scan) {
    E57Cloud cloud;
    CloudHeader& header = cloud.header;
    header.name = string_of(scan, "name");
    header.guid = string_of(scan, "guid");
    header.description = string_of(scan, "description");
    header.sensor = sensor_of(scan);
    header.acquired_from = time_of(scan, "acquisitionStart");
    header.acquired_to = time_of(scan, "acquisitionEnd");
    header.time_zero = "seconds since acquisitionStart";
    const pugi::xml_node points = scan.child("points");
    const pugi::xml_node prototype = points.child("prototype");
    if (!points || !prototype) bad(scan, "no table of points");
    header.records = natural_of(points, "recordCount");
    cloud.points_offset = natural_of(points, "fileOffset");
    for (const pugi::xml_node& node : prototype.children()) {
        if (node.type() != pugi::node_element) continue;
        if (cloud.fields.size() == kMostFields) bad(prototype, fmt::format("more than {} fields", kMostFields));
        cloud.fields.push_back(field_of(node));
        header.attributes.push_back(cloud.fields.back().name);
    }
    if (points.child("codecs").first_child()) {
        for (const pugi::xml_node& codec : points.child("codecs").children()) {
            if (codec.type() == pugi::node_element) bad(codec, "a codec other than bit packing is not known here");
        }
    }
    const auto has_three = [&](const char* a, const char* b, const char* c) {
        return find_field(cloud, a) != nullptr && find_field(cloud, b) != nullptr && find_field(cloud, c) != nullptr;
    };
    cloud.cartesian = has_three("cartesianX", "cartesianY", "cartesianZ");
    if (!cloud.cartesian && !has_three("sphericalRange", "sphericalAzimuth", "sphericalElevation")) {
        bad(prototype, "neither cartesian nor spherical coordinates");
    }
    read_grid(scan, cloud);
    read_limits(scan, prototype, cloud);
    header.stated_bounds = bounds_of(scan);
    header.has.time = find_field(cloud, "timeStamp") != nullptr;
    if (const pugi::xml_node pose = scan.child("pose")) {
        header.site_from_scan = pose_of(pose, header.notes);
        header.has_pose = true;
    }
    return cloud;
}

// An image2D element; without a readable picture in it (only a mask) it is left out.
std::optional<E57Image> image_of(const pugi::xml_node& node, std::vector<std::string>& notes) {
    E57Image image;
    image.header.name = string_of(node, "name");
    image.header.guid = string_of(node, "guid");
    image.header.scan_guid = string_of(node, "associatedData3DGuid");
    if (const pugi::xml_node pose = node.child("pose")) {
        image.header.site_from_camera = pose_of(pose, notes);
        image.header.has_pose = true;
    }
    for (const char* kind : {"visualReference", "pinhole", "spherical", "cylindrical"}) {
        const pugi::xml_node shown = node.child((std::string(kind) + "Representation").c_str());
        for (const char* type : {"jpeg", "png"}) {
            const pugi::xml_node blob = shown.child((std::string(type) + "Image").c_str());
            if (!blob) continue;
            image.header.representation = kind;
            image.header.type = type;
            image.header.bytes = natural_of(blob, "length");
            image.offset = natural_of(blob, "fileOffset");
            const auto size = [&](const char* name) {
                const double pixels = number_of(shown.child(name));
                return pixels > 0.0 && pixels < 1e9 ? static_cast<std::uint64_t>(pixels) : 0;
            };
            image.header.width = size("imageWidth");
            image.header.height = size("imageHeight");
            if (const pugi::xml_node focal = shown.child("focalLength")) image.header.focal_length = number_of(focal);
            return image;
        }
    }
    notes.push_back("image '" + image.header.name + "' has no JPEG or PNG in it");
    return std::nullopt;
}

} // namespace

E57Metadata parse_e57_xml(std::string_view xml) {
    pugi::xml_document document;
    const pugi::xml_parse_result result =
        document.load_buffer(xml.data(), xml.size(), pugi::parse_default | pugi::parse_doctype, pugi::encoding_utf8);
    if (!result) {
        throw Error(ErrorCode::BadInput, fmt::format("xml part, byte {}: {}", result.offset, result.description()));
    }
    for (const pugi::xml_node& node : document.children()) {
        if (node.type() == pugi::node_doctype)
            throw Error(ErrorCode::BadInput, "xml part: a DOCTYPE has no place in E57");
    }
    const pugi::xml_node root = document.child("e57Root");
    if (!root) throw Error(ErrorCode::BadInput, "xml part: no element e57Root");
    E57Metadata metadata;
    metadata.guid = string_of(root, "guid");
    metadata.software = string_of(root, "e57LibraryVersion");
    metadata.created_at = time_of(root, "creationDateTime");
    metadata.coordinate_system = string_of(root, "coordinateMetadata");
    for (const pugi::xml_node& node : root.child("data3D").children()) {
        if (node.type() == pugi::node_element) metadata.clouds.push_back(cloud_of(node));
    }
    for (const pugi::xml_node& node : root.child("images2D").children()) {
        if (node.type() != pugi::node_element) continue;
        if (std::optional<E57Image> image = image_of(node, metadata.notes))
            metadata.images.push_back(std::move(*image));
    }
    return metadata;
}

} // namespace planum::scans
