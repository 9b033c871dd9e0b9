// SPDX-License-Identifier: MIT
#include "core/geometry/gpb.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "core/base/error.hpp"

namespace planum::geometry {

namespace {

constexpr std::uint32_t kPoint = 1;
constexpr std::uint32_t kLineString = 2;
constexpr std::uint32_t kPolygon = 3;
constexpr std::uint32_t kMultiPolygon = 6;
constexpr std::uint32_t kWithZ = 1000; // ISO: type + 1000
constexpr std::byte kLittleEndianFlag{1};
constexpr std::byte kEnvelopeXyFlag{2}; // envelope code 1 in bits 1 to 3
constexpr std::byte kEmptyFlag{16};

class Writer {
  public:
    Writer(std::size_t expected, bool has_z) : has_z_(has_z) { bytes_.reserve(expected); }

    template<class Number>
    void put(Number value) {
        std::array<std::byte, sizeof(Number)> raw;
        std::memcpy(raw.data(), &value, sizeof(Number));
        if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
        bytes_.insert(bytes_.end(), raw.begin(), raw.end());
    }

    void put(const Point3& point) {
        for (std::size_t i = 0; i < (has_z_ ? 3U : 2U); ++i) {
            if (!std::isfinite(point[i])) throw Error(ErrorCode::BadInput, "a coordinate is not a finite number");
            put(point[i]);
        }
    }

    void header(std::uint32_t type) {
        put(std::byte{1});
        put(has_z_ ? type + kWithZ : type);
    }

    [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

  private:
    bool has_z_;
    std::vector<std::byte> bytes_;
};

struct Envelope {
    double min_x = std::numeric_limits<double>::infinity();
    double max_x = -std::numeric_limits<double>::infinity();
    double min_y = std::numeric_limits<double>::infinity();
    double max_y = -std::numeric_limits<double>::infinity();

    void add(const Line3& line) {
        for (const Point3& p : line) {
            min_x = std::min(min_x, p[0]);
            max_x = std::max(max_x, p[0]);
            min_y = std::min(min_y, p[1]);
            max_y = std::max(max_y, p[1]);
        }
    }
};

void put_line(Writer& out, const Line3& line) {
    out.header(kLineString);
    out.put(static_cast<std::uint32_t>(line.size()));
    for (const Point3& p : line) out.put(p);
}

void put_polygon(Writer& out, const Rings& rings) {
    out.header(kPolygon);
    out.put(static_cast<std::uint32_t>(rings.size()));
    for (const Line3& ring : rings) {
        // WKB closes rings, the model does not.
        out.put(static_cast<std::uint32_t>(ring.empty() ? 0 : ring.size() + 1));
        for (const Point3& p : ring) out.put(p);
        if (!ring.empty()) out.put(ring.front());
    }
}

void put_multipolygon(Writer& out, const MultiPolygon& polygons) {
    out.header(kMultiPolygon);
    out.put(static_cast<std::uint32_t>(polygons.size()));
    for (const Rings& rings : polygons) put_polygon(out, rings);
}

std::size_t count_points(const Geometry& geometry) {
    if (const auto* line = std::get_if<Line3>(&geometry.shape)) return line->size();
    std::size_t points = 1;
    if (const auto* polygons = std::get_if<MultiPolygon>(&geometry.shape)) {
        for (const Rings& rings : *polygons) {
            for (const Line3& ring : rings) points += ring.size() + 1;
        }
    }
    return points;
}

/// Reads numbers in whatever byte order the surrounding geometry said.
class Reader {
  public:
    explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}

    template<class Number>
    Number get() {
        std::array<std::byte, sizeof(Number)> raw;
        const auto taken = take(sizeof(Number));
        std::copy(taken.begin(), taken.end(), raw.begin());
        if (little_ != (std::endian::native == std::endian::little)) std::reverse(raw.begin(), raw.end());
        Number value;
        std::memcpy(&value, raw.data(), sizeof(Number));
        return value;
    }

    std::span<const std::byte> take(std::size_t count) {
        if (count > rest_.size()) throw Error(ErrorCode::BadInput, "the geometry is cut short");
        const auto taken = rest_.first(count);
        rest_ = rest_.subspan(count);
        return taken;
    }

    /// A number of parts of which each needs at least `size` bytes.
    std::size_t count(std::size_t size) {
        const auto n = static_cast<std::size_t>(get<std::uint32_t>());
        if (n > rest_.size() / size) throw Error(ErrorCode::BadInput, "the geometry is cut short");
        return n;
    }

    void byte_order(bool little) noexcept { little_ = little; }

  private:
    std::span<const std::byte> rest_;
    bool little_ = true;
};

struct WkbType {
    std::uint32_t base = 0;
    bool z = false;
    bool m = false;

    [[nodiscard]] std::size_t point_size() const noexcept { return 16U + (z ? 8U : 0U) + (m ? 8U : 0U); }
};

WkbType read_type(Reader& in) {
    const auto order = in.get<std::byte>();
    if (order > std::byte{1}) throw Error(ErrorCode::BadInput, "the geometry has no known byte order");
    in.byte_order(order == std::byte{1});
    const auto code = in.get<std::uint32_t>();
    WkbType type;
    // Extended WKB has flags in the highest bits, ISO WKB adds thousands.
    type.z = (code & 0x80000000U) != 0 || (code & 0xFFFFU) / 1000 == 1 || (code & 0xFFFFU) / 1000 == 3;
    type.m = (code & 0x40000000U) != 0 || (code & 0xFFFFU) / 1000 == 2 || (code & 0xFFFFU) / 1000 == 3;
    if ((code & 0x20000000U) != 0) (void)in.get<std::uint32_t>(); // an SRID of its own
    type.base = (code & 0xFFFFU) % 1000;
    return type;
}

double finite(double value) {
    if (!std::isfinite(value)) throw Error(ErrorCode::BadInput, "a coordinate is not a finite number");
    return value;
}

Point3 read_point(Reader& in, const WkbType& type) {
    Point3 point{};
    point[0] = finite(in.get<double>());
    point[1] = finite(in.get<double>());
    if (type.z) point[2] = finite(in.get<double>());
    if (type.m) (void)in.get<double>();
    return point;
}

Line3 read_line(Reader& in, const WkbType& type) {
    const std::size_t points = in.count(type.point_size());
    Line3 line;
    line.reserve(points);
    for (std::size_t i = 0; i < points; ++i) line.push_back(read_point(in, type));
    return line;
}

Rings read_rings(Reader& in, const WkbType& type) {
    const std::size_t count = in.count(sizeof(std::uint32_t));
    Rings rings;
    rings.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        rings.push_back(read_line(in, type));
        Line3& ring = rings.back();
        if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    }
    return rings;
}

MultiPolygon read_multipolygon(Reader& in, const WkbType& outer) {
    const std::size_t count = in.count(9);
    MultiPolygon polygons;
    polygons.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const WkbType type = read_type(in);
        if (type.base != kPolygon || type.z != outer.z) {
            throw Error(ErrorCode::BadInput, "a multipolygon holds something that is no polygon of its kind");
        }
        polygons.push_back(read_rings(in, type));
    }
    return polygons;
}

} // namespace

std::vector<std::byte> encode_gpb(const Geometry& geometry) {
    Writer out(64 + 24 * count_points(geometry), geometry.has_z);
    Envelope envelope;
    const auto* line = std::get_if<Line3>(&geometry.shape);
    const auto* polygons = std::get_if<MultiPolygon>(&geometry.shape);
    if (line != nullptr) envelope.add(*line);
    if (polygons != nullptr) {
        for (const Rings& rings : *polygons) {
            for (const Line3& ring : rings) envelope.add(ring);
        }
    }
    const auto* point = std::get_if<Point3>(&geometry.shape);
    const bool with_envelope = envelope.min_x <= envelope.max_x;
    const bool empty = point == nullptr && !with_envelope;
    out.put(std::byte{'G'});
    out.put(std::byte{'P'});
    out.put(std::byte{0});
    out.put(kLittleEndianFlag | (with_envelope ? kEnvelopeXyFlag : std::byte{0}) | (empty ? kEmptyFlag : std::byte{0}));
    out.put(geometry.srs_id);
    if (with_envelope) {
        for (const double bound : {envelope.min_x, envelope.max_x, envelope.min_y, envelope.max_y}) out.put(bound);
    }
    if (point != nullptr) {
        out.header(kPoint);
        out.put(*point);
    } else if (line != nullptr) {
        put_line(out, *line);
    } else if (polygons != nullptr) {
        put_multipolygon(out, *polygons);
    } else {
        put_multipolygon(out, {});
    }
    return out.take();
}

Geometry decode_gpb(std::span<const std::byte> blob) {
    Reader in(blob);
    if (in.get<std::byte>() != std::byte{'G'} || in.get<std::byte>() != std::byte{'P'}) {
        throw Error(ErrorCode::BadInput, "not a GeoPackage geometry");
    }
    (void)in.get<std::byte>(); // version: 0 so far
    const auto flags = std::to_integer<unsigned>(in.get<std::byte>());
    if ((flags & 0x20U) != 0) throw Error(ErrorCode::BadInput, "an extended geometry type is not supported");
    in.byte_order((flags & 1U) != 0);
    Geometry geometry;
    geometry.srs_id = in.get<std::int32_t>();
    constexpr std::array<std::size_t, 5> kEnvelopeBytes = {0, 32, 48, 48, 64};
    const std::size_t code = (flags >> 1U) & 7U;
    if (code >= kEnvelopeBytes.size()) throw Error(ErrorCode::BadInput, "the geometry has no known envelope");
    (void)in.take(kEnvelopeBytes[code]);
    if ((flags & 0x10U) != 0) return geometry;
    const WkbType type = read_type(in);
    geometry.has_z = type.z;
    switch (type.base) {
    case kPoint: geometry.shape = read_point(in, type); break;
    case kLineString: geometry.shape = read_line(in, type); break;
    case kPolygon: geometry.shape = MultiPolygon{read_rings(in, type)}; break;
    case kMultiPolygon: geometry.shape = read_multipolygon(in, type); break;
    default:
        throw Error(ErrorCode::BadInput,
                    "geometry type " + std::to_string(type.base) + " is not point, line or polygon");
    }
    return geometry;
}

} // namespace planum::geometry
