// SPDX-License-Identifier: MIT
#include <algorithm>
#include <fstream>
#include <iterator>

#include "core/base/error.hpp"
#include "scans/cloud/point_store.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/read_scan.hpp"
#include "tests/support/scan_samples.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;
using namespace planum::scans;
using namespace planum::test;

namespace {

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::size_t files_in(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}

std::string why_refused(const std::filesystem::path& file) {
    try {
        static_cast<void>(PointStore::open(file));
    } catch (const Error& e) {
        CHECK(e.code() == ErrorCode::BadInput);
        return e.what();
    }
    return {};
}

} // namespace

TEST_CASE("Every point is stored once, with its attributes, within a tenth of a millimetre") {
    const TemporaryFolder folder;
    const PointBlock cloud = surface_cloud();
    store_cloud(cloud, folder / "a.pts");
    const PointStore store = PointStore::open(folder / "a.pts");
    CHECK(store.points() == cloud.size());
    std::vector<int> seen(cloud.size());
    double worst = 0.0;
    bool same = true;
    store.for_each(
        [&](const FoundPoints& found) {
            const PointBlock& p = found.points;
            for (std::size_t i = 0; i < p.size(); ++i) {
                const std::size_t n = number_of(p, i);
                ++seen.at(n);
                worst = std::max({worst, std::abs(p.x[i] - cloud.x[n]), std::abs(p.y[i] - cloud.y[n]),
                                  std::abs(p.z[i] - cloud.z[n])});
                same = same && p.intensity[i] == cloud.intensity[n] && p.colour[i] == cloud.colour[n];
            }
        },
        Progress::none());
    CHECK(std::all_of(seen.begin(), seen.end(), [](int count) { return count == 1; }));
    CHECK(worst <= 1e-4);
    CHECK(same);
}

TEST_CASE("A store remembers what it was made from") {
    const TemporaryFolder folder;
    store_cloud(surface_cloud({1000}), folder / "a.pts");
    const PointStore store = PointStore::open(folder / "a.pts");
    CHECK(store.info() == full_info());
    CHECK(store.verify(Progress::none()).empty());
}

TEST_CASE("Coordinates take hardly more than six bytes a point, node table included") {
    const TemporaryFolder folder;
    CloudOptions options;
    options.points = 1000000;
    options.outliers = 0.0;
    const StoreSummary summary = store_cloud(surface_cloud(options), folder / "a.pts");
    CHECK(static_cast<double>(summary.coordinate_bytes) / 1e6 <= 6.1);
    CHECK(summary.file_bytes <= summary.coordinate_bytes + 9 * summary.points + 8 * summary.nodes + 1000);
}

TEST_CASE("Upper nodes hold a thinned sample, so that a small budget covers the whole surface") {
    const TemporaryFolder folder;
    const PointBlock cloud = surface_cloud({400000, 1, 20.0, 1.0, {0, 0, 0}, 0.0});
    store_cloud(cloud, folder / "a.pts");
    const PointStore store = PointStore::open(folder / "a.pts");
    Frustum everything;
    everything.eye = {0, 0, 100};
    std::vector<int> squares(100); // 2 m each
    const std::uint64_t given = store.in_frustum(everything, 60000, [&](const FoundPoints& found) {
        for (std::size_t i = 0; i < found.points.size(); ++i) {
            const auto cell = [](double v) { return std::clamp(static_cast<int>((v + 10.0) / 2.0), 0, 9); };
            ++squares[static_cast<std::size_t>(cell(found.points.x[i]) * 10 + cell(found.points.y[i]))];
        }
    });
    CHECK(given <= 60000);
    CHECK(given > 20000);
    CHECK(*std::min_element(squares.begin(), squares.end()) > 50);
}

TEST_CASE("A store made out of core has the same bytes, and leaves nothing beside it") {
    const TemporaryFolder folder;
    const PointBlock cloud = surface_cloud({150000, 3, 6.0});
    store_cloud(cloud, folder / "memory.pts");
    StoreOptions little;
    little.memory_bytes = 500000;
    store_cloud(cloud, folder / "disk.pts", little);
    CHECK(bytes_of(folder / "memory.pts") == bytes_of(folder / "disk.pts"));
    CHECK(files_in(folder.path()) == 2);
}

TEST_CASE("Blocks of any size give the same store") {
    const TemporaryFolder folder;
    const PointBlock cloud = surface_cloud({30000});
    store_cloud(cloud, folder / "one.pts");
    StoreBuilder builder(folder / "many.pts", full_info());
    const std::size_t piece = 777;
    for (std::size_t at = 0; at < cloud.size(); at += piece) {
        PointBlock block;
        block.resize(std::min(piece, cloud.size() - at), {true, true, true, false});
        for (std::size_t i = 0; i < block.size(); ++i) {
            block.x[i] = cloud.x[at + i];
            block.y[i] = cloud.y[at + i];
            block.z[i] = cloud.z[at + i];
            block.intensity[i] = cloud.intensity[at + i];
            block.colour[i] = cloud.colour[at + i];
            block.row[i] = cloud.row[at + i];
            block.column[i] = cloud.column[at + i];
        }
        builder.add(block);
    }
    builder.finish(Progress::none());
    CHECK(bytes_of(folder / "one.pts") == bytes_of(folder / "many.pts"));
}

TEST_CASE("A thousand points in one place, or none at all, are a store, too") {
    const TemporaryFolder folder;
    PointBlock same = surface_cloud({50000});
    std::fill(same.x.begin(), same.x.end(), 1.0);
    std::fill(same.y.begin(), same.y.end(), -2.0);
    std::fill(same.z.begin(), same.z.end(), 8.0);
    store_cloud(same, folder / "same.pts");
    const PointStore store = PointStore::open(folder / "same.pts");
    CHECK(store.points() == 50000);
    CHECK(store.nearest({1, -2, 8}, 0.001).has_value());
    store_cloud({}, folder / "none.pts");
    const PointStore none = PointStore::open(folder / "none.pts");
    CHECK(none.points() == 0);
    CHECK_FALSE(none.nearest({0, 0, 0}, 1e9));
}

TEST_CASE("Far coordinates keep their precision, and points beyond 131 km are left out and counted") {
    const TemporaryFolder folder;
    PointBlock cloud = surface_cloud({1000, 1, 20.0, 1.0, {637012.24, 5849028.31, 431.66}, 0.0});
    cloud.x[999] = -1e12;
    const StoreSummary summary = store_cloud(cloud, folder / "utm.pts");
    CHECK(summary.too_far == 1);
    const PointStore store = PointStore::open(folder / "utm.pts");
    CHECK(store.points() == 999);
    const auto hit = store.nearest({cloud.x[0], cloud.y[0], cloud.z[0]}, 1.0);
    REQUIRE(hit);
    CHECK(hit->distance < 1.8e-4);
}

TEST_CASE("A builder that is dropped or stopped leaves neither file nor temporary files") {
    const TemporaryFolder folder;
    {
        StoreBuilder builder(folder / "a.pts", full_info(), {1000});
        builder.add(surface_cloud({50000}));
    }
    CHECK(files_in(folder.path()) == 0);
    std::stop_source stop;
    stop.request_stop();
    Progress progress(stop.get_token());
    {
        StoreBuilder builder(folder / "a.pts", full_info());
        builder.add(surface_cloud({1000}));
        CHECK_THROWS_AS(builder.finish(progress), Error);
    }
    CHECK(files_in(folder.path()) == 0);
    CHECK_THROWS_WITH(StoreBuilder(folder / "no" / "a.pts", full_info()), Catch::Contains("cannot be written"));
}

TEST_CASE("A store that exists is only replaced by a complete one") {
    const TemporaryFolder folder;
    store_cloud(surface_cloud({1000}), folder / "a.pts");
    const std::string before = bytes_of(folder / "a.pts");
    {
        StoreBuilder builder(folder / "a.pts", full_info());
        builder.add(surface_cloud({2000}));
    }
    CHECK(bytes_of(folder / "a.pts") == before);
}

TEST_CASE("A damaged block is found by verify, named on reading, and mended by making the store anew") {
    const TemporaryFolder folder;
    const PointBlock cloud = surface_cloud();
    store_cloud(cloud, folder / "a.pts");
    std::string bytes = bytes_of(folder / "a.pts");
    const std::uint64_t at = PointStore::open(folder / "a.pts").nodes()[2].block_at;
    bytes[at + 5] = static_cast<char>(bytes[at + 5] ^ 4);
    folder.write("a.pts", bytes);
    const PointStore store = PointStore::open(folder / "a.pts");
    const std::vector<DamagedBlock> damaged = store.verify(Progress::none());
    REQUIRE(damaged.size() == 1);
    CHECK(damaged[0].node == 2);
    CHECK(damaged[0].at == at);
    CHECK_NOTHROW(store.read_node(1));
    CHECK_THROWS_WITH(store.read_node(2),
                      Catch::Contains("a.pts") && Catch::Contains("block 2") && Catch::Contains("makes it again"));
    store_cloud(cloud, folder / "a.pts");
    CHECK(PointStore::open(folder / "a.pts").verify(Progress::none()).empty());
}

TEST_CASE("A store that is cut, changed in its tables or something else is refused") {
    const TemporaryFolder folder;
    store_cloud(surface_cloud({30000}), folder / "a.pts");
    const std::string good = bytes_of(folder / "a.pts");
    const auto changed = [&](std::size_t at) {
        std::string bytes = good;
        bytes[at] = static_cast<char>(bytes[at] ^ 1);
        return folder.write("b.pts", bytes);
    };
    CHECK_THAT(why_refused(folder.write("b.pts", good.substr(0, good.size() - 1))),
               Catch::Contains("bytes instead of"));
    CHECK_THAT(why_refused(folder.write("b.pts", good.substr(0, 100))), Catch::Contains("100 bytes"));
    CHECK_THAT(why_refused(folder.write("b.pts", "")), Catch::Contains("no point store"));
    CHECK_THAT(why_refused(changed(0)), Catch::Contains("does not start as one"));
    CHECK_THAT(why_refused(changed(8)), Catch::Contains("version 0"));
    CHECK_THAT(why_refused(changed(40)), Catch::Contains("header is damaged"));
    const std::size_t nodes_at = static_cast<std::size_t>(PointStore::open(folder / "a.pts").nodes()[0].block_at);
    CHECK(nodes_at == sizeof(StoreHeaderRecord));
    CHECK_THAT(why_refused(changed(good.size() - 1)), Catch::Contains("description is damaged"));
}

TEST_CASE("A scan goes from its file into a store with everything it has") {
    const TemporaryFolder folder;
    const auto reader = open_bytes(sample_e57(3000), ScanFormat::E57);
    const StoreInfo info = store_info(reader->clouds()[0], "2025-06-01/helix", "abc", 0);
    const StoreSummary summary = build_store(*reader, 0, folder / "helix.pts", info, {}, Progress::none());
    CHECK(summary.points == 2700);
    const PointStore store = PointStore::open(folder / "helix.pts");
    CHECK(store.info().has == Columns{true, true, true, false});
    CHECK(store.info().rows == 20);
    CHECK(store.info().intensity.scale == reader->clouds()[0].intensity.scale);
    CHECK(store.info().attributes.size() == 10);
    const WholeCloud original = read_whole(*reader);
    CHECK(store.bounds() == original.summary.bounds);
    std::size_t found = 0;
    store.in_box({{-2, -2, -2}, {2, 2, 2}}, [&](const FoundPoints& f) { found += f.points.size(); });
    CHECK(found == 2700);
}

TEST_CASE("Rays pick the first point, brushes what is near it") {
    const TemporaryFolder folder;
    const PointBlock cloud = surface_cloud({200000, 5, 10.0, 0.0, {0, 0, 0}, 0.0});
    store_cloud(cloud, folder / "a.pts");
    const PointStore store = PointStore::open(folder / "a.pts");
    Ray ray{{0.5, 0.5, 10.0}, {0, 0, -1}, 0.05, 0.0};
    const auto hit = store.pick(ray);
    REQUIRE(hit);
    CHECK(hit->distance == Approx(10.0).margin(0.03));
    CHECK(store.place(hit->ref) == hit->x_in_scan);
    std::size_t touched = 0;
    store.brush(ray, 1.0, [&](const FoundPoints& found) { touched += found.points.size(); });
    CHECK(touched > 5);
    ray.direction = {0, 0, 1};
    CHECK_FALSE(store.pick(ray));
}
