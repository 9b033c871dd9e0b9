// SPDX-License-Identifier: MIT
// Reading speed per format on files made here, then store build and queries, on one core. Prints a table.
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <string>

#include <fmt/format.h>
#include <sys/resource.h>

#include "core/base/error.hpp"
#include "scans/cloud/point_store.hpp"
#include "scans/formats/scan_reader.hpp"
#include "scans/panorama/panorama.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/scan_samples.hpp"

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

double peak_memory_mb() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

struct Folder {
    std::filesystem::path path = std::filesystem::temp_directory_path() / fmt::format("planum-bench-{}", ::getpid());

    Folder() { std::filesystem::create_directories(path); }

    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
};

void write(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream out(file, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!out) throw Error(ErrorCode::Io, file.string() + ": cannot be written");
}

/// A wall of points as a scanner sees it, in the order of its columns.
std::string text_points(std::size_t rows, std::size_t columns, bool with_colour) {
    std::mt19937 random(1);
    std::string out;
    out.reserve(rows * columns * 48);
    for (std::size_t c = 0; c < columns; ++c) {
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

void bench_formats(const Folder& folder) {
    constexpr std::size_t kRows = 1000;
    constexpr std::size_t kColumns = 2000;
    constexpr std::size_t kPoints = kRows * kColumns;
    const std::string plain = text_points(kRows, kColumns, false);
    const std::string coloured = text_points(kRows, kColumns, true);
    write(folder.path / "plain.ptx", test::ptx_header(kColumns, kRows) + plain);
    write(folder.path / "colour.ptx", test::ptx_header(kColumns, kRows) + coloured);
    write(folder.path / "colour.pts", fmt::format("{}\n", kPoints) + coloured);
    write(folder.path / "plain.xyz", plain);
    write(folder.path / "plain.3d", plain);
    write(folder.path / "five.e57", test::sample_e57(5000000));
    write(folder.path / "colour.las", test::sample_las({3, 2, kPoints, false}));
    const std::string ply =
        fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
                    "property float z\nproperty float intensity\nend_header\n",
                    kPoints);
    write(folder.path / "binary.ply", binary_points(ply, kPoints));
    const std::string pcd =
        fmt::format("VERSION 0.7\nFIELDS x y z intensity\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH {}\n"
                    "HEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA binary\n",
                    kPoints, kPoints);
    write(folder.path / "binary.pcd", binary_points(pcd, kPoints));
    for (const char* name : {"plain.ptx", "colour.ptx", "colour.pts", "plain.xyz", "plain.3d", "five.e57", "colour.las",
                             "binary.ply", "binary.pcd"}) {
        measure(name, folder.path / name);
    }
}

void bench_build(const Folder& folder) {
    test::CloudOptions options;
    options.points = 5000000;
    options.extent = 40.0;
    const PointBlock cloud = test::surface_cloud(options);
    StoreSummary summary;
    const double time =
        seconds_of([&] { summary = test::store_cloud(cloud, folder.path / "store.pts", {2ULL << 30U}); });
    const auto points = static_cast<double>(summary.points);
    fmt::print("store build from memory: {:.0f} points, {:.2f} s: {:.1f} M points/s; {:.3f} bytes a point for "
               "coordinates, {:.3f} in all, {} nodes\n",
               points, time, points / time / 1e6, static_cast<double>(summary.coordinate_bytes) / points,
               static_cast<double>(summary.file_bytes) / points, summary.nodes);
}

void bench_queries(const Folder& folder) {
    const double open = seconds_of([&] { static_cast<void>(PointStore::open(folder.path / "store.pts")); });
    const PointStore store = PointStore::open(folder.path / "store.pts");
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
    fmt::print("store: open {:.2f} ms; frustum {} points first {:.0f} ms, warm {:.0f} ms; box {} points "
               "{:.1f} ms; nearest {:.0f} us a query; "
               "verify {:.0f} ms\n",
               open * 1e3, given, cold * 1e3, warm * 1e3, found, box * 1e3, nearest * 1e3,
               1e3 * seconds_of([&] { static_cast<void>(store.verify(Progress::none())); }));
    if (sum == 12345.0) fmt::print(" ");
}

void bench_panorama(const Folder& folder) {
    PointBlock cloud;
    const auto reader = open_scan(folder.path / "plain.ptx", {}, Progress::none());
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

/// From a PTX with `columns` × 1000 points into its store, as `planum scan add` does it.
void bench_import(const Folder& folder, std::size_t columns) {
    write(folder.path / "large.ptx",
          test::ptx_header(static_cast<std::int64_t>(columns), 1000) + text_points(1000, columns, false));
    StoreSummary summary;
    const double time = seconds_of([&] {
        const auto reader = open_scan(folder.path / "large.ptx", {}, Progress::none());
        summary = build_store(*reader, 0, folder.path / "large.pts", store_info(reader->clouds()[0], "large", "", 0),
                              {}, Progress::none());
    });
    fmt::print("import of a PTX with {} points: {:.2f} s, {:.1f} M points/s\n", summary.points, time,
               static_cast<double>(summary.points) / time / 1e6);
}

} // namespace

int main() {
    try {
        const Folder folder;
        bench_formats(folder);
        bench_build(folder);
        bench_queries(folder);
        bench_panorama(folder);
        bench_import(folder, 5000);
        fmt::print("peak memory {:.0f} MB (the generated files included)\n", peak_memory_mb());
    } catch (const Error& e) {
        fmt::print(stderr, "bench_scans: {}\n", e.what());
        return exit_status(e.code());
    }
    return 0;
}
