// SPDX-License-Identifier: MIT
#include "core/geometry/polygon_overlay.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <geos_c.h>

#include "core/base/error.hpp"
#include "core/geometry/polygons.hpp"

namespace planum::geometry {

namespace {

constexpr double kSamePoint = 1e-6;  ///< [m]
constexpr double kMendedGrid = 1e-5; ///< repaired outlines lie on it, so that no two points nearly meet [m]
constexpr double kFarthest = 1e8;    ///< [m]; no site grid reaches farther
constexpr double kUnclearShare = 0.02;
constexpr double kUnclearArea = 0.002; ///< [m²]

// One GEOS context with the last message it gave.
class Geos {
  public:
    Geos() : context_(GEOS_init_r()) {
        GEOSContext_setErrorMessageHandler_r(context_, &Geos::remember, this);
        GEOSContext_setNoticeMessageHandler_r(context_, &Geos::ignore, nullptr);
    }

    ~Geos() { GEOS_finish_r(context_); }

    Geos(const Geos&) = delete;
    Geos& operator=(const Geos&) = delete;

    [[nodiscard]] GEOSContextHandle_t handle() const noexcept { return context_; }

    [[noreturn]] void fail() const {
        throw Error(ErrorCode::BadInput,
                    "the outline cannot be used: " + (message_.empty() ? "unknown reason" : message_));
    }

  private:
    static void remember(const char* message, void* self) { static_cast<Geos*>(self)->message_ = message; }

    static void ignore(const char* /*message*/, void* /*unused*/) {}

    GEOSContextHandle_t context_;
    std::string message_;
};

struct Destroy {
    const Geos* geos;

    void operator()(GEOSGeometry* geometry) const noexcept { GEOSGeom_destroy_r(geos->handle(), geometry); }
};

using Owned = std::unique_ptr<GEOSGeometry, Destroy>;

Owned own(const Geos& geos, GEOSGeometry* geometry) {
    if (geometry == nullptr) geos.fail();
    return Owned(geometry, Destroy{&geos});
}

GEOSGeometry* ring_of(const Geos& geos, const Line3& ring) {
    const auto h = geos.handle();
    const auto size = static_cast<unsigned>(ring.size() + 1);
    GEOSCoordSequence* line = GEOSCoordSeq_create_r(h, size, 3);
    for (unsigned i = 0; i < size; ++i) {
        const Point3& p = ring[i < ring.size() ? i : 0];
        GEOSCoordSeq_setXYZ_r(h, line, i, p[0], p[1], p[2]);
    }
    return GEOSGeom_createLinearRing_r(h, line); // owns the line, also when it fails
}

Owned to_geos(const Geos& geos, const MultiPolygon& shape) {
    const auto h = geos.handle();
    std::vector<GEOSGeometry*> parts;
    for (const Rings& rings : shape) {
        if (rings.empty() || rings.front().empty()) continue;
        std::vector<GEOSGeometry*> made;
        for (const Line3& ring : rings) made.push_back(ring_of(geos, ring));
        parts.push_back(
            GEOSGeom_createPolygon_r(h, made.front(), made.data() + 1, static_cast<unsigned>(made.size() - 1)));
    }
    return own(geos,
               GEOSGeom_createCollection_r(h, GEOS_MULTIPOLYGON, parts.data(), static_cast<unsigned>(parts.size())));
}

// The ring, run the way it should.
Line3 ring_from(const Geos& geos, const GEOSGeometry* ring, bool counter_clockwise) {
    const auto h = geos.handle();
    const GEOSCoordSequence* line = GEOSGeom_getCoordSeq_r(h, ring);
    unsigned size = 0;
    GEOSCoordSeq_getSize_r(h, line, &size);
    Line3 points;
    for (unsigned i = 0; i + 1 < size; ++i) {
        Point3 p{};
        GEOSCoordSeq_getXYZ_r(h, line, i, &p[0], &p[1], &p[2]);
        points.push_back(p);
    }
    if ((signed_area(points) > 0.0) != counter_clockwise) std::reverse(points.begin(), points.end());
    return points;
}

MultiPolygon from_geos(const Geos& geos, const GEOSGeometry* geometry) {
    const auto h = geos.handle();
    MultiPolygon shape;
    for (int i = 0; i < GEOSGetNumGeometries_r(h, geometry); ++i) {
        const GEOSGeometry* part = GEOSGetGeometryN_r(h, geometry, i);
        const int type = GEOSGeomTypeId_r(h, part);
        if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
            for (Rings& rings : from_geos(geos, part)) shape.push_back(std::move(rings));
        }
        if (type != GEOS_POLYGON || GEOSisEmpty_r(h, part) == 1) continue;
        Rings rings = {ring_from(geos, GEOSGetExteriorRing_r(h, part), true)};
        for (int hole = 0; hole < GEOSGetNumInteriorRings_r(h, part); ++hole) {
            Line3 ring = ring_from(geos, GEOSGetInteriorRingN_r(h, part, hole), false);
            if (std::abs(signed_area(ring)) >= kLeastArea) rings.push_back(std::move(ring));
        }
        if (area({rings}) >= kLeastArea) shape.push_back(std::move(rings));
    }
    return shape;
}

void forget_heights(MultiPolygon& shape, const MultiPolygon& known) {
    std::vector<Point3> points;
    for (const Rings& rings : known) {
        for (const Line3& ring : rings) points.insert(points.end(), ring.begin(), ring.end());
    }
    std::sort(points.begin(), points.end());
    for (Rings& rings : shape) {
        for (Line3& ring : rings) {
            for (Point3& p : ring) {
                const auto at = std::lower_bound(points.begin(), points.end(), Point3{p[0], p[1], -kFarthest});
                const bool same = at != points.end() && (*at)[0] == p[0] && (*at)[1] == p[1];
                p[2] = same ? (*at)[2] : std::numeric_limits<double>::quiet_NaN();
            }
        }
    }
}

std::size_t drop_repeated(Line3& ring) {
    const auto same = [](const Point3& a, const Point3& b) {
        return std::abs(a[0] - b[0]) <= kSamePoint && std::abs(a[1] - b[1]) <= kSamePoint;
    };
    const std::size_t before = ring.size();
    ring.erase(std::unique(ring.begin(), ring.end(), same), ring.end());
    while (ring.size() > 1 && same(ring.front(), ring.back())) ring.pop_back();
    return before - ring.size();
}

// Rings of at least three points; what had to go is said.
MultiPolygon tidied(const MultiPolygon& drawn, std::vector<std::string>& repairs) {
    MultiPolygon shape;
    std::size_t repeated = 0;
    for (const Rings& rings : drawn) {
        Rings kept;
        for (std::size_t i = 0; i < rings.size(); ++i) {
            Line3 ring = rings[i];
            for (const Point3& p : ring) {
                const bool good = std::all_of(p.begin(), p.end(), [](double v) { return std::abs(v) <= kFarthest; });
                if (!good) throw Error(ErrorCode::BadInput, "a coordinate is no number of metres of a site grid");
            }
            repeated += drop_repeated(ring);
            const bool flat = ring.size() < 3 || (i > 0 && std::abs(signed_area(ring)) < kLeastArea);
            if (flat && i == 0) break;
            if (flat) {
                repairs.emplace_back("a hole without area was left out");
                continue;
            }
            kept.push_back(std::move(ring));
        }
        if (!kept.empty()) {
            shape.push_back(std::move(kept));
        } else if (drawn.size() > 1) {
            repairs.emplace_back("a part without area was left out");
        }
    }
    if (repeated > 0) repairs.push_back(fmt::format("{} repeated points were left out", repeated));
    return shape;
}

std::string place_text(double x, double y) { return fmt::format("{:.2f} {:.2f}", x, y); }

struct Fault {
    std::string what;
    double x = 0.0;
    double y = 0.0;
};

// What GEOS has against the shape; empty `what` when nothing.
Fault fault_of(const Geos& geos, const GEOSGeometry* shape) {
    const auto h = geos.handle();
    char* reason = nullptr;
    GEOSGeometry* place = nullptr;
    const char valid = GEOSisValidDetail_r(h, shape, 0, &reason, &place);
    Fault fault;
    if (place != nullptr) {
        const Owned owned = own(geos, place);
        if (GEOSisEmpty_r(h, place) == 0) {
            GEOSGeomGetX_r(h, place, &fault.x);
            GEOSGeomGetY_r(h, place, &fault.y);
        }
    }
    if (reason != nullptr) {
        fault.what = reason;
        GEOSFree_r(h, reason);
    }
    if (valid == 2) geos.fail();
    if (valid == 1) fault.what.clear();
    if (valid == 0 && fault.what.empty()) fault.what = "not valid";
    return fault;
}

std::string fault_in_words(const std::string& what) {
    if (what.find("Self-intersection") != std::string::npos) return "crosses itself";
    if (what.find("Hole lies outside") != std::string::npos) return "has a hole outside";
    if (what.find("Nested") != std::string::npos) return "has one part inside another";
    if (what.find("Duplicate Rings") != std::string::npos) return "has the same ring twice";
    if (what.find("Interior is disconnected") != std::string::npos) return "is parted by its holes";
    return "is not valid (" + what + ")";
}

Owned made_valid(const Geos& geos, const GEOSGeometry* shape) {
    const auto h = geos.handle();
    GEOSMakeValidParams* how = GEOSMakeValidParams_create_r(h);
    GEOSMakeValidParams_setMethod_r(h, how, GEOS_MAKE_VALID_STRUCTURE);
    GEOSMakeValidParams_setKeepCollapsed_r(h, how, 0);
    GEOSGeometry* valid = GEOSMakeValidWithParams_r(h, shape, how);
    GEOSMakeValidParams_destroy_r(h, how);
    return own(geos, valid);
}

using Operation = GEOSGeometry* (*)(GEOSContextHandle_t, const GEOSGeometry*, const GEOSGeometry*);

MultiPolygon overlay(Operation operation, const MultiPolygon& a, const MultiPolygon& b) {
    const Geos geos;
    const Owned left = to_geos(geos, a);
    const Owned right = to_geos(geos, b);
    const Owned made = own(geos, operation(geos.handle(), left.get(), right.get()));
    MultiPolygon shape = from_geos(geos, made.get());
    MultiPolygon known = a;
    known.insert(known.end(), b.begin(), b.end());
    forget_heights(shape, known);
    take_heights(shape, a.empty() ? b : known);
    return shape;
}

// What one ring encloses. Lobes that a line runs around the wrong way count against what it is meant to enclose.
MultiPolygon sound_ring(const Geos& geos, const Line3& ring, std::vector<std::string>& repairs) {
    const Owned shape = to_geos(geos, {{ring}});
    const Fault fault = fault_of(geos, shape.get());
    if (fault.what.empty()) return from_geos(geos, shape.get());
    MultiPolygon mended = from_geos(geos, made_valid(geos, shape.get()).get());
    const double kept = area(mended);
    const double unclear = std::abs(std::abs(signed_area(ring)) - kept);
    const std::string words = fault_in_words(fault.what);
    if (unclear > std::max(kUnclearShare * kept, kUnclearArea)) {
        throw Error(ErrorCode::BadInput, fmt::format("it {} at {}; it is not clear what it encloses: redraw it there",
                                                     words, place_text(fault.x, fault.y)));
    }
    repairs.push_back(
        fmt::format("it {} at {}; repaired, {:.0f} cm² differ", words, place_text(fault.x, fault.y), 1e4 * unclear));
    return mended;
}

} // namespace

SoundPolygon make_sound(const MultiPolygon& drawn) {
    SoundPolygon sound;
    const MultiPolygon tidy = tidied(drawn, sound.repairs);
    if (tidy.empty()) throw Error(ErrorCode::BadInput, "it has no area: fewer than three different points");
    const Geos geos;
    const Owned shape = to_geos(geos, tidy);
    const Fault fault = fault_of(geos, shape.get());
    if (fault.what.empty()) {
        sound.shape = from_geos(geos, shape.get());
    } else {
        const std::size_t before = sound.repairs.size();
        for (const Rings& rings : tidy) {
            MultiPolygon part = sound_ring(geos, rings.front(), sound.repairs);
            for (std::size_t i = 1; i < rings.size(); ++i) {
                part = difference(part, sound_ring(geos, rings[i], sound.repairs));
            }
            sound.shape = united(sound.shape, part);
        }
        if (sound.repairs.size() == before) {
            sound.repairs.push_back(
                fmt::format("it {} at {}; repaired", fault_in_words(fault.what), place_text(fault.x, fault.y)));
        }
        const Owned mended = to_geos(geos, sound.shape);
        sound.shape =
            from_geos(geos, own(geos, GEOSGeom_setPrecision_r(geos.handle(), mended.get(), kMendedGrid, 0)).get());
        forget_heights(sound.shape, tidy);
        take_heights(sound.shape, tidy);
    }
    if (area(sound.shape) < kLeastArea) {
        const Point3& p = tidy.front().front().front();
        throw Error(ErrorCode::BadInput, fmt::format("it has no area (below 1 cm²) at {}", place_text(p[0], p[1])));
    }
    return sound;
}

MultiPolygon difference(const MultiPolygon& a, const MultiPolygon& b) { return overlay(&GEOSDifference_r, a, b); }

MultiPolygon intersection(const MultiPolygon& a, const MultiPolygon& b) { return overlay(&GEOSIntersection_r, a, b); }

MultiPolygon united(const MultiPolygon& a, const MultiPolygon& b) { return overlay(&GEOSUnion_r, a, b); }

MultiPolygon offset(const MultiPolygon& shape, double distance) {
    if (shape.empty()) return {};
    const Geos geos;
    const Owned from = to_geos(geos, shape);
    constexpr int kSegmentsOfQuarter = 4;
    const Owned made = own(geos, GEOSBuffer_r(geos.handle(), from.get(), distance, kSegmentsOfQuarter));
    MultiPolygon moved = from_geos(geos, made.get());
    forget_heights(moved, shape);
    take_heights(moved, shape);
    return moved;
}

MultiPolygon simplified_apart(const MultiPolygon& shape, double tolerance) {
    if (shape.empty()) return {};
    const Geos geos;
    const Owned from = to_geos(geos, shape);
    const Owned made = own(geos, GEOSTopologyPreserveSimplify_r(geos.handle(), from.get(), tolerance));
    MultiPolygon simple = from_geos(geos, made.get());
    forget_heights(simple, shape);
    take_heights(simple, shape);
    return simple;
}

std::array<double, 2> inner_place(const MultiPolygon& shape) {
    const Geos geos;
    const auto h = geos.handle();
    const auto largest = std::max_element(shape.begin(), shape.end(),
                                          [](const Rings& a, const Rings& b) { return area({a}) < area({b}); });
    if (largest == shape.end()) throw Error(ErrorCode::BadInput, "an outline without parts has no inside");
    const Owned part = to_geos(geos, {*largest});
    const double tolerance = std::max(0.005, 0.02 * std::sqrt(area({*largest})));
    // The radius from the centre of the largest circle inside to the outline; its first point is the centre.
    const Owned radius = own(geos, GEOSMaximumInscribedCircle_r(h, part.get(), tolerance));
    const GEOSCoordSequence* line = GEOSGeom_getCoordSeq_r(h, radius.get());
    std::array<double, 2> place{};
    GEOSCoordSeq_getXY_r(h, line, 0, &place[0], &place[1]);
    return place;
}

} // namespace planum::geometry
