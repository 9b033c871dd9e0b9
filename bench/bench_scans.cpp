// SPDX-License-Identifier: MIT
// bench_scans [formats] [peers] [store] [large] [panorama] [import]: reading speed per format on files made here, PCL
// on the same, store build and queries, panoramas, and `planum scan add` of a PTX with 20 million points. All on one
// thread.
#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <string>

#include <fmt/format.h>

#include "bench/bench_support.hpp"
#include "core/base/error.hpp"
#include "scans/cloud/point_store.hpp"
#include "scans/formats/scan_reader.hpp"
#include "scans/panorama/panorama.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/scan_samples.hpp"
#ifdef PLANUM_BENCH_PCL
#include "bench/pcl_peer.hpp"
#endif

using namespace planum;
using namespace planum::scans;

namespace {

/// Seconds of the processor, not of the clock on the wall: everything here runs on one thread, and other
/// programs may be running beside it.
double seconds_of(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

using bench::Scratch;

void write(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream out(file, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!out) throw Error(ErrorCode::Io, file.string() + ": cannot be written");
}

/// A wall of points as a scanner sees it, in the order of its columns, from column `from` of `columns`.
std::string text_points(std::size_t rows, std::size_t columns, bool with_colour, std::size_t from = 0,
                        std::size_t to = SIZE_MAX) {
    std::mt19937 random(static_cast<unsigned>(1 + from));
    to = std::min(to, columns);
    std::string out;
    out.reserve(rows * (to - from) * 48);
    for (std::size_t c = from; c < to; ++c) {
        for (std::size_t r = 0; r < rows; ++r) {
            const double az = 6.28 * static_cast<double>(c) / static_cast<double>(columns);
            const double el = 1.5 * static_cast<double>(r) / static_cast<double>(rows) - 0.9;
            const double range = 8.0 + 1e-3 * static_cast<double>(random() % 4000);
            fmt::format_to(std::back_inserter(out), "{:.6f} {:.6f} {:.6f} {:.6f}", range * std::cos(el) * std::cos(az),
                           range * std::cos(el) * std::sin(az), range * std::sin(el),
                           static_cast<double>(random() % 4096) / 4096.0);
            if (with_colour)
                fmt::format_to(std::back_inserter(out), " {} {} {}", random() % 256, random() % 256, random() % 256);
            out.push_back('\n');
        }
    }
    return out;
}

std::string binary_points(const std::string& header, std::size_t count) {
    std::mt19937 random(1);
    std::string out = header;
    for (std::size_t i = 0; i < count; ++i) {
        for (int k = 0; k < 3; ++k) test::put_value(out, static_cast<float>(random() % 100000) / 1000.0F);
        test::put_value(out, static_cast<float>(random() % 4096) / 4096.0F);
    }
    return out;
}

void measure(const std::string& name, const std::filesystem::path& file) {
    const double megabytes = static_cast<double>(std::filesystem::file_size(file)) / 1e6;
    double open = 1e9;
    double read = 1e9;
    std::uint64_t points = 0;
    double sum = 0.0; // so that nothing is optimised away
    for (int run = 0; run < 3; ++run) {
        std::unique_ptr<ScanReader> reader;
        open = std::min(open, seconds_of([&] { reader = open_scan(file, {}, Progress::none()); }));
        read = std::min(read, seconds_of([&] {
                            points =
                                reader
                                    ->read(
                                        0, [&](const PointBlock& block) { sum += block.x[0]; }, {}, Progress::none())
                                    .records;
                        }));
    }
    fmt::print("{:<22} {:>8.1f} MB {:>9} points  open {:>6.3f} s  read {:>6.3f} s  {:>7.0f} MB/s {:>6.1f} M "
               "points/s\n",
               name, megabytes, points, open, read, megabytes / read, static_cast<double>(points) / read / 1e6);
    if (sum == 12345.0) fmt::print(" ");
}

void bench_formats(const Scratch& folder) {
    constexpr std::size_t kRows = 1000;
    constexpr std::size_t kColumns = 2000;
    constexpr std::size_t kPoints = kRows * kColumns;
    const std::string plain = text_points(kRows, kColumns, false);
    const std::string coloured = text_points(kRows, kColumns, true);
    write(folder / "plain.ptx", test::ptx_header(kColumns, kRows) + plain);
    write(folder / "colour.ptx", test::ptx_header(kColumns, kRows) + coloured);
    write(folder / "colour.pts", fmt::format("{}\n", kPoints) + coloured);
    write(folder / "plain.xyz", plain);
    write(folder / "plain.3d", plain);
    write(folder / "five.e57", test::sample_e57(5000000));
    write(folder / "colour.las", test::sample_las({3, 2, kPoints, false}));
    const std::string ply =
        fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
                    "property float z\nproperty float intensity\nend_header\n",
                    kPoints);
    write(folder / "binary.ply", binary_points(ply, kPoints));
    const std::string pcd =
        fmt::format("VERSION 0.7\nFIELDS x y z intensity\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH {}\n"
                    "HEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA binary\n",
                    kPoints, kPoints);
    write(folder / "binary.pcd", binary_points(pcd, kPoints));
    for (const char* name : {"plain.ptx", "colour.ptx", "colour.pts", "plain.xyz", "plain.3d", "five.e57", "colour.las",
                             "binary.ply", "binary.pcd"}) {
        measure(name, folder / name);
    }
}

PointBlock bench_cloud() {
    test::CloudOptions options;
    options.points = 5000000;
    options.extent = 40.0;
    return test::surface_cloud(options);
}

void bench_build(const Scratch& folder) {
    const PointBlock cloud = bench_cloud();
    StoreSummary summary;
    double time = 1e9;
    for (int run = 0; run < 3; ++run) {
        time = std::min(time,
                        seconds_of([&] { summary = test::store_cloud(cloud, folder / "store.pts", {2ULL << 30U}); }));
    }
    const auto points = static_cast<double>(summary.points);
    fmt::print("store build from memory: {:.0f} points, {:.2f} s: {:.1f} M points/s; {:.3f} bytes a point for "
               "coordinates, {:.3f} in all, {} nodes\n",
               points, time, points / time / 1e6, static_cast<double>(summary.coordinate_bytes) / points,
               static_cast<double>(summary.file_bytes) / points, summary.nodes);
}

/// `file` holds a cloud of `extent` metres around the centre of test::surface_cloud.
void bench_queries(const std::filesystem::path& file) {
    const double open = seconds_of([&] { static_cast<void>(PointStore::open(file)); });
    const PointStore store = PointStore::open(file);
    Frustum frustum;
    frustum.eye = {0.0, 0.0, 5.0};
    frustum.planes = {{1.0, 0.0, 0.0, 0.0}, {0.0, 1.0, 0.0, 10.0}};
    std::uint64_t given = 0;
    const auto look = [&] { given = store.in_frustum(frustum, 1000000, [](const FoundPoints&) {}); };
    const double cold = seconds_of(look);
    const double warm = std::min(seconds_of(look), seconds_of(look));
    std::size_t found = 0;
    const double box = seconds_of([&] {
        store.in_box({{-2, -2, -5}, {2, 2, 5}}, [&](const FoundPoints& f) { found += f.points.size(); });
    });
    double sum = 0.0;
    const double nearest = seconds_of([&] {
        for (int i = 0; i < 1000; ++i) {
            const auto hit = store.nearest({0.01 * i - 5.0, 0.003 * i, 1.0}, 10.0);
            sum += hit ? hit->distance : 0.0;
        }
    });
    const double verify = seconds_of([&] { static_cast<void>(store.verify(Progress::none())); });
    fmt::print("store of {} points: open {:.2f} ms; frustum {} points first {:.0f} ms, warm {:.0f} ms; box {} points "
               "{:.1f} ms; nearest {:.0f} us a query; verify {:.0f} ms\n",
               store.points(), open * 1e3, given, cold * 1e3, warm * 1e3, found, box * 1e3, nearest * 1e3,
               verify * 1e3);
    if (sum == 12345.0) fmt::print(" ");
}

/// 100 million points, out of core: twenty parts of one ground.
void bench_large_store(const Scratch& folder) {
    const std::filesystem::path file = folder / "large_store.pts";
    StoreSummary summary;
    const double time = seconds_of([&] {
        StoreBuilder builder(file, test::full_info());
        for (std::uint32_t part = 0; part < 20; ++part) {
            test::CloudOptions options;
            options.points = 5000000;
            options.extent = 100.0;
            options.seed = part + 1;
            builder.add(test::surface_cloud(options));
        }
        summary = builder.finish(Progress::none());
    });
    fmt::print("store build out of core, points made on the way: {} points, {:.1f} s; {:.3f} bytes a point for "
               "coordinates\n",
               summary.points, time,
               static_cast<double>(summary.coordinate_bytes) / static_cast<double>(summary.points));
    bench_queries(file);
}

#ifdef PLANUM_BENCH_PCL
void bench_peers(const Scratch& folder) {
    for (const char* name : {"binary.ply", "binary.pcd"}) {
        std::size_t points = 0;
        double best = 1e9;
        for (int run = 0; run < 3; ++run) {
            best = std::min(best, seconds_of([&] {
                                points = name == std::string("binary.ply") ? bench::pcl_read_ply(folder / name)
                                                                           : bench::pcl_read_pcd(folder / name);
                            }));
        }
        fmt::print("PCL {:<18} {} points  read {:.3f} s  {:.1f} M points/s\n", name, points, best,
                   static_cast<double>(points) / best / 1e6);
    }
    const PointBlock cloud = bench_cloud();
    const bench::PclOctree pcl = bench::pcl_octree(cloud);
    const auto points = static_cast<double>(cloud.size());
    fmt::print("PCL octree: {:.0f} points, build {:.2f} s: {:.1f} M points/s; {:.1f} bytes a point in memory; box {} "
               "points {:.1f} ms; nearest {:.0f} us a query\n",
               points, pcl.build, points / pcl.build / 1e6, pcl.megabytes * 1e6 / points, pcl.in_box, pcl.box * 1e3,
               pcl.nearest * 1e3);
}
#else
void bench_peers(const Scratch& /*folder*/) {
    fmt::print("PCL: not built in; install libpcl-dev and configure anew\n");
}
#endif

void bench_panorama(const Scratch& folder) {
    PointBlock cloud;
    write(folder / "wall.ptx", test::ptx_header(2000, 1000) + text_points(1000, 2000, false));
    const auto reader = open_scan(folder / "wall.ptx", {}, Progress::none());
    reader->read(
        0,
        [&](const PointBlock& block) {
            cloud.x.insert(cloud.x.end(), block.x.begin(), block.x.end());
            cloud.y.insert(cloud.y.end(), block.y.begin(), block.y.end());
            cloud.z.insert(cloud.z.end(), block.z.begin(), block.z.end());
            cloud.validity.insert(cloud.validity.end(), block.validity.begin(), block.validity.end());
            cloud.intensity.insert(cloud.intensity.end(), block.intensity.begin(), block.intensity.end());
        },
        {}, Progress::none());
    for (const ProjectionKind kind :
         {ProjectionKind::Equirectangular, ProjectionKind::Cylindrical, ProjectionKind::Mercator,
          ProjectionKind::Miller, ProjectionKind::EqualArea, ProjectionKind::Rectilinear, ProjectionKind::Pannini,
          ProjectionKind::Stereographic}) {
        PanoramaOptions options;
        options.projection.kind = kind;
        options.gaps.most_pixels = 0;
        std::uint64_t bytes = 0;
        std::uint64_t points = 0;
        double best = 1e9;
        for (int run = 0; run < 3; ++run) {
            best = std::min(best, seconds_of([&] {
                                PanoramaBuilder builder(options, {true, false, false, false});
                                builder.expect(cloud.size());
                                builder.add(cloud);
                                const Panorama panorama = builder.finish(Progress::none());
                                bytes = panorama.list_bytes();
                                points = panorama.points();
                            }));
        }
        fmt::print("panorama {:<16} {} points in the picture, {:.3f} s: {:.1f} M points/s; lists {:.2f} "
                   "bytes a point\n",
                   projection_name(kind), points, best, static_cast<double>(cloud.size()) / best / 1e6,
                   static_cast<double>(bytes) / static_cast<double>(points));
    }
}

/// `planum scan add` of one PTX with 20 million points, the program as a user runs it.
void bench_import(const Scratch& folder) {
    constexpr std::size_t kColumns = 20000;
    std::filesystem::create_directories(folder / "2025-06-01");
    const std::filesystem::path ptx = folder / "2025-06-01/large.ptx";
    std::ofstream out(ptx, std::ios::binary);
    out << test::ptx_header(kColumns, 1000);
    for (std::size_t c = 0; c < kColumns; c += 500) out << text_points(1000, kColumns, false, c, c + 500);
    out.close();
    if (!out) throw Error(ErrorCode::Io, ptx.string() + ": cannot be written");
    const std::string planum = bench::program_folder() / "planum";
    const std::string site = folder / "site.gpkg";
    bench::run_child({planum, "new", site}, 10.0);
    const bench::Measured import = bench::run_child({planum, "scan", "add", site, ptx.string()}, 300.0);
    if (import.status != 0)
        throw Error(ErrorCode::Internal, fmt::format("planum scan add ended with {}", import.status));
    fmt::print(
        "planum scan add of a PTX with {} M points, {:.0f} MB: {:.1f} s, {:.1f} s of the processor, {:.0f} MB of "
        "memory\n",
        kColumns / 1000, static_cast<double>(std::filesystem::file_size(ptx)) / 1e6, import.wall, import.cpu,
        import.peak_mb);
}

} // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> asked(argv + 1, argv + argc);
    const auto wanted = [&](const char* section) {
        return asked.empty() || std::find(asked.begin(), asked.end(), section) != asked.end();
    };
    try {
        const Scratch folder;
        fmt::print("{}\n", bench::machine());
        if (wanted("formats") || wanted("peers")) bench_formats(folder);
        if (wanted("peers")) bench_peers(folder);
        if (wanted("store")) {
            bench_build(folder);
            bench_queries(folder / "store.pts");
        }
        if (wanted("large")) bench_large_store(folder);
        if (wanted("panorama")) bench_panorama(folder);
        if (wanted("import")) bench_import(folder);
    } catch (const Error& e) {
        fmt::print(stderr, "bench_scans: {}\n", e.what());
        return exit_status(e.code());
    }
    return 0;
}
