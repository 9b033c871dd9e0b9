// SPDX-License-Identifier: MIT
// Every query of a point store gives what a loop over all its points gives.
#include <algorithm>
#include <set>

#include <rapidcheck.h>

#include "scans/cloud/point_store.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;
using namespace planum::scans;
using namespace planum::test;

namespace {

struct Stored {
    PointRef ref;
    Eigen::Vector3d x;
};

/// A store and all of its points, in the order of their refs.
struct Bench {
    TemporaryFolder folder;
    PointBlock cloud;
    std::optional<PointStore> store;
    std::vector<Stored> all;

    explicit Bench(const CloudOptions& options) : cloud(surface_cloud(options)) {
        store_cloud(cloud, folder / "a.pts");
        store = PointStore::open(folder / "a.pts");
        store->for_each(
            [&](const FoundPoints& found) {
                for (std::size_t i = 0; i < found.points.size(); ++i) {
                    all.push_back(
                        {{found.node, found.index[i]}, {found.points.x[i], found.points.y[i], found.points.z[i]}});
                }
            },
            Progress::none());
    }
};

const Bench& bench() {
    static const Bench one({120000, 7, 18.0, 1.5, {-3.0, 5.0, 1.0}, 0.01});
    return one;
}

template<class Query>
std::vector<PointRef> refs_of(Query query) {
    std::vector<PointRef> refs;
    query([&](const FoundPoints& found) {
        for (const std::uint32_t index : found.index) refs.push_back({found.node, index});
    });
    std::sort(refs.begin(), refs.end());
    return refs;
}

template<class Contains>
std::vector<PointRef> by_loop(Contains contains) {
    std::vector<PointRef> refs;
    for (const Stored& point : bench().all) {
        if (contains(point.x)) refs.push_back(point.ref);
    }
    return refs;
}

/// In millimetres, so that rapidcheck has integers to shrink.
double metres(int low, int high) { return 0.001 * *rc::gen::inRange(1000 * low, 1000 * high); }

Eigen::Vector3d anywhere() { return {metres(-15, 12), metres(-6, 16), metres(-3, 5)}; }

Eigen::Vector3d direction() {
    const Eigen::Vector3d d(metres(-1, 1), metres(-1, 1), metres(-1, 1));
    RC_PRE(d.norm() > 0.1);
    return d.normalized();
}

} // namespace

TEST_CASE("A box holds what a loop finds in it") {
    CHECK(rc::check([] {
        Box box;
        const Eigen::Vector3d a = anywhere();
        const Eigen::Vector3d b = anywhere();
        box.minimum = a.cwiseMin(b);
        box.maximum = a.cwiseMax(b);
        RC_ASSERT(refs_of([&](const FoundSink& sink) { bench().store->in_box(box, sink); }) ==
                  by_loop([&](const Eigen::Vector3d& x) { return box.contains(x); }));
    }));
}

TEST_CASE("A prism in any frame holds what a loop finds in it") {
    CHECK(rc::check([] {
        Prism prism;
        prism.prism_from_scan = Eigen::Translation3d(anywhere()) * Eigen::AngleAxisd(metres(-3, 3), direction());
        const int corners = *rc::gen::inRange(3, 9);
        for (int i = 0; i < corners; ++i) prism.corners.emplace_back(metres(-12, 12), metres(-12, 12));
        const double a = metres(-5, 5);
        const double b = metres(-5, 5);
        prism.z_minimum = std::min(a, b);
        prism.z_maximum = std::max(a, b);
        RC_ASSERT(refs_of([&](const FoundSink& sink) { bench().store->in_prism(prism, sink); }) ==
                  by_loop([&](const Eigen::Vector3d& x) { return prism.contains(x); }));
    }));
}

TEST_CASE("A frustum without a limit holds what a loop finds, with one a part of it") {
    CHECK(rc::check([] {
        Frustum frustum;
        frustum.eye = anywhere();
        const int planes = *rc::gen::inRange(1, 7);
        for (int i = 0; i < planes; ++i) {
            const Eigen::Vector3d normal = direction();
            frustum.planes.emplace_back(normal.x(), normal.y(), normal.z(), metres(-2, 8) - normal.dot(frustum.eye));
        }
        const auto expected = by_loop([&](const Eigen::Vector3d& x) { return frustum.contains(x); });
        RC_ASSERT(refs_of([&](const FoundSink& sink) {
                      bench().store->in_frustum(frustum, bench().all.size(), sink);
                  }) == expected);
        const auto budget = static_cast<std::uint64_t>(*rc::gen::inRange(0, 60000));
        const auto some = refs_of([&](const FoundSink& sink) { bench().store->in_frustum(frustum, budget, sink); });
        RC_ASSERT(some.size() <= budget);
        RC_ASSERT(std::includes(expected.begin(), expected.end(), some.begin(), some.end()));
    }));
}

TEST_CASE("The nearest point is the one a loop finds") {
    CHECK(rc::check([] {
        const Eigen::Vector3d x = anywhere();
        const double most = metres(0, 5);
        const Stored* best = nullptr;
        for (const Stored& point : bench().all) {
            if ((point.x - x).squaredNorm() > most * most) continue;
            if (best == nullptr || (point.x - x).squaredNorm() < (best->x - x).squaredNorm()) best = &point;
        }
        const auto found = bench().store->nearest(x, most);
        RC_ASSERT(found.has_value() == (best != nullptr));
        if (best != nullptr) RC_ASSERT(found->ref == best->ref);
    }));
}

TEST_CASE("A ray picks, and a brush touches, what a loop finds") {
    CHECK(rc::check([] {
        Ray ray;
        ray.origin = anywhere();
        ray.direction = direction();
        ray.radius = metres(0, 1) * 0.3;
        ray.spread = 0.02 * metres(0, 1);
        const Stored* first = nullptr;
        for (const Stored& point : bench().all) {
            const double along = ray.hit(point.x);
            if (along >= 0.0 && (first == nullptr || along < ray.hit(first->x))) first = &point;
        }
        const auto picked = bench().store->pick(ray);
        RC_ASSERT(picked.has_value() == (first != nullptr));
        if (first == nullptr) return;
        RC_ASSERT(picked->ref == first->ref);
        const double depth = metres(0, 3);
        RC_ASSERT(refs_of([&](const FoundSink& sink) { bench().store->brush(ray, depth, sink); }) ==
                  by_loop([&](const Eigen::Vector3d& x) {
                      return ray.hit(x) >= 0.0 && ray.hit(x) <= picked->distance + depth;
                  }));
    }));
}

TEST_CASE("No point moves by more than a tenth of a millimetre, wherever it is") {
    CHECK(rc::check([] {
        CloudOptions options;
        options.points = static_cast<std::size_t>(*rc::gen::inRange(1, 3000));
        options.seed = static_cast<std::uint32_t>(*rc::gen::inRange(0, 1000000));
        options.extent = metres(0, 60);
        options.centre = {metres(-900, 900) * 1000.0, metres(-900, 900), metres(-90, 90)};
        const TemporaryFolder folder;
        const PointBlock cloud = surface_cloud(options);
        store_cloud(cloud, folder / "a.pts");
        std::size_t count = 0;
        PointStore::open(folder / "a.pts")
            .for_each(
                [&](const FoundPoints& found) {
                    for (std::size_t i = 0; i < found.points.size(); ++i, ++count) {
                        const std::size_t n = number_of(found.points, i);
                        RC_ASSERT(std::abs(found.points.x[i] - cloud.x[n]) <= 1e-4);
                        RC_ASSERT(std::abs(found.points.y[i] - cloud.y[n]) <= 1e-4);
                        RC_ASSERT(std::abs(found.points.z[i] - cloud.z[n]) <= 1e-4);
                        RC_ASSERT(found.points.intensity[i] == cloud.intensity[n]);
                    }
                },
                Progress::none());
        RC_ASSERT(count == cloud.size());
    }));
}
