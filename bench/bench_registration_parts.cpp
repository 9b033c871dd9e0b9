// SPDX-License-Identifier: MIT
#include "bench/bench_registration_parts.hpp"

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <sys/resource.h>

#include "app/demo/simulator.hpp"
#include "app/registration/scan_shelf.hpp"
#include "bench/bench_support.hpp"
#ifdef PLANUM_BENCH_PCL
#include "bench/pcl_registration_peer.hpp"
#endif
#include "core/base/error.hpp"
#include "scans/cloud/store_builder.hpp"
#include "scans/formats/scan_reader.hpp"
#include "scans/registration/coarse_alignment.hpp"
#include "scans/registration/fine_alignment.hpp"
#include "scans/registration/scan_network.hpp"
#include "tests/unit/scans_registration/g2o_file.hpp"
#include "tests/unit/scans_registration/scan_files.hpp"

namespace planum::bench {

namespace fs = std::filesystem;
using geometry::Rigid3;
using geometry::Vector6;

namespace {

constexpr double kDegrees = 57.29577951308232;
using Points = std::vector<Eigen::Vector3d>;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double peak_mb() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

std::string apart(const Rigid3& from, const Rigid3& to) {
    const Vector6 error = geometry::step_between(from, to);
    return fmt::format("{:8.2f} mm {:7.4f}°", 1e3 * error.tail<3>().norm(), kDegrees * error.head<3>().norm());
}

void print_pcl([[maybe_unused]] const Points& target, [[maybe_unused]] const Points& source,
               [[maybe_unused]] const Rigid3& start, [[maybe_unused]] const Rigid3& reference,
               [[maybe_unused]] const std::vector<double>& voxels, [[maybe_unused]] double max_distance) {
#ifdef PLANUM_BENCH_PCL
    for (const double voxel : voxels) {
        for (const PclMethod method : {PclMethod::Gicp, PclMethod::Icp}) {
            const PclAlignment pcl = pcl_align(method, target, source, start, voxel, max_distance);
            fmt::print("  {:<44} {:>8.0f} ms  {}  {} points, grew by {:.0f} MB\n",
                       fmt::format("PCL {}, {}", method == PclMethod::Gicp ? "GICP" : "ICP",
                                   voxel > 0.0 ? fmt::format("thinned to {} m", voxel) : "all points"),
                       1e3 * pcl.seconds, apart(reference, pcl.target_from_source), pcl.points, pcl.megabytes);
            std::fflush(stdout);
        }
    }
#else
    fmt::print("  (PCL was not there when this was built)\n");
#endif
}

/// A street or a hall from a scanner that moved.
scans::FineOptions driving_options() {
    scans::FineOptions options;
    options.levels = {{1.0, 2.0, 0.5, 20}, {0.3, 0.6, 0.2, 15}};
    options.neighbours = 10;
    options.patch = 2.0;
    return options;
}

// Forward, left, up [mm] and the turns about them [°], as other programs' poses are compared in docs/benchmarks.md.
void print_place(const char* whose, const Rigid3& pose) {
    const Eigen::Vector3d at = 1e3 * pose.translation;
    const Eigen::Matrix3d& r = pose.rotation;
    fmt::print("  {:<46} x {:.0f} y {:.0f} height {:.0f} mm, roll {:.2f} pitch {:.2f} yaw {:.2f}°\n", whose, at.x(),
               at.y(), at.z(), kDegrees * std::atan2(r(2, 1), r(2, 2)), kDegrees * -std::asin(r(2, 0)),
               kDegrees * std::atan2(r(1, 0), r(0, 0)));
}

} // namespace

void bench_pair(const fs::path& folder) {
    const Points target = test::read_ply_points(folder / "small_gicp_target.ply");
    const Points source = test::read_ply_points(folder / "small_gicp_source.ply");
    const Rigid3 reference = test::read_matrix(folder / "small_gicp_T_target_source.txt");
    scans::FineOptions options = driving_options();
    fmt::print("real pair, {} and {} points; time with thinning and planes, start: none; {}\n", target.size(),
               source.size(), machine());
    for (const int threads : {2, 1}) {
        options.threads = threads;
        scans::FineResult found;
        const double seconds = median_seconds(7, [&] {
            const auto prepared_target = scans::prepare_scan(target, options);
            found = scans::align_scans(prepared_target, scans::prepare_scan(source, options), {}, options);
        });
        fmt::print("  {:<44} {:>8.0f} ms  {}  {}\n", fmt::format("planum, {} threads, median of 7", threads),
                   1e3 * seconds, apart(reference, found.target_from_source), found.verdict);
    }
    print_pcl(target, source, {}, reference, {0.0, 0.25}, 1.0);
}

void bench_sequence(const fs::path& folder) {
    std::vector<Points> all;
    std::vector<Rigid3> odometry;
    for (int i = 0; i < 3; ++i) {
        const auto reader = scans::open_scan(folder / fmt::format("scan{:03}.3d", i), {}, Progress::none());
        Points points;
        (void)reader->read(
            0,
            [&](const scans::PointBlock& block) {
                for (std::size_t k = 0; k < block.size(); ++k) points.emplace_back(block.x[k], block.y[k], block.z[k]);
            },
            {}, Progress::none());
        all.push_back(std::move(points));
        const Eigen::Isometry3d& pose = reader->clouds().front().site_from_scan;
        odometry.push_back({pose.linear(), pose.translation()});
    }
    const scans::FineOptions options; // as planum register uses them
    std::vector<scans::PreparedScan> prepared;
    for (const auto& points : all) prepared.push_back(scans::prepare_scan(points, options));
    fmt::print("3DTK sequence, {} points a scan; each pair from its odometry\n", all[0].size());
    std::vector<scans::NetworkLink> links;
    std::vector<Rigid3> chain{odometry[0]};
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = a + 1; b < 3; ++b) {
            const Rigid3 start = odometry[a].inverse() * odometry[b];
            const auto found = scans::align_scans(prepared[a], prepared[b], start, options);
            fmt::print("scan {} to {}: moved {} from the odometry; {}\n", b, a, apart(start, found.target_from_source),
                       found.verdict);
            print_place("odometry", start);
            print_place("planum", found.target_from_source);
            print_pcl(all[a], all[b], start, found.target_from_source, {0.1}, 0.5);
            if (!found.is_accepted) continue;
            links.push_back({a, b, found.target_from_source, found.covariance});
            if (b == a + 1 && chain.size() == b) chain.push_back(chain.back() * found.target_from_source);
        }
    }
    const scans::NetworkAnchor first{0, odometry[0], geometry::Matrix6::Zero(), true};
    const auto network = scans::solve_network(3, links, {&first, 1});
    for (std::size_t i = 0; i < links.size(); ++i) {
        fmt::print("link {} to {}: error {:.2f} before, {:.2f} σ after; {}\n", links[i].source, links[i].target,
                   network.links[i].before, network.links[i].after,
                   network.links[i].is_used ? "used" : network.links[i].reason);
    }
    fmt::print("cost {:.3f} before, {:.3f} after\n", network.cost_before, network.cost_after);
    for (std::size_t i = 1; i < 3; ++i) {
        if (!network.poses[i]) fmt::print("scan {}: no pose\n", i);
        if (!network.poses[i]) continue;
        const Rigid3& pose = network.poses[i]->site_from_scan;
        fmt::print("scan {}: relaxed, {} from its odometry", i, apart(odometry[i], pose));
        if (chain.size() > i) fmt::print(", {} from the chain of neighbours", apart(chain[i], pose));
        fmt::print("\n");
    }
}

void bench_graphs(const fs::path& folder) {
    for (const char* name : {"smallGrid3D.g2o", "sphere2500.g2o"}) {
        const auto graph = test::read_g2o(folder / name);
        scans::PoseGraphOptions options;
        options.with_covariances = false;
        const auto relax = [&](const char* from, const std::vector<scans::PoseNode>& nodes) {
            const double began = now();
            const auto result = scans::relax_poses(nodes, graph.links, options);
            fmt::print("{:<18} from {:<22} cost {:>14.3f} -> {:>10.4f} in {:>2} steps, {:>6.0f} ms{}\n", name, from,
                       result.cost_before, result.cost_after, result.iterations, 1e3 * (now() - began),
                       result.has_converged ? "" : ", not converged");
        };
        relax("the file's poses", graph.nodes);
        relax("a tree of the links", scans::spread_from_fixed(graph.nodes, graph.links));
    }
}

namespace {

/// A simulated scan as a store, as `planum scan add` would make it.
fs::path store_of(const app::demo::SimulatedScan& scan, const fs::path& file) {
    const app::demo::ScanImage& image = scan.image;
    scans::StoreInfo info;
    info.name = scan.station.name;
    info.has = {true, false, true, false};
    info.rows = static_cast<std::uint64_t>(image.rows);
    info.columns = static_cast<std::uint64_t>(image.columns);
    scans::StoreBuilder builder(file, info);
    for (int column = 0; column < image.columns; ++column) {
        scans::PointBlock block;
        for (int row = 0; row < image.rows; ++row) {
            const auto& back = image.returns[static_cast<std::size_t>(column) * static_cast<std::size_t>(image.rows) +
                                             static_cast<std::size_t>(row)];
            if (back.range <= 0.0F) continue;
            const app::demo::Vec3 ray = image.direction_in_scan(column, row);
            const auto range = static_cast<double>(back.range);
            block.x.push_back(range * ray.x);
            block.y.push_back(range * ray.y);
            block.z.push_back(range * ray.z);
            block.intensity.push_back(static_cast<std::uint16_t>(65535.0F * std::clamp(back.intensity, 0.0F, 1.0F)));
            block.row.push_back(static_cast<std::uint32_t>(row));
            block.column.push_back(static_cast<std::uint32_t>(column));
            block.validity.push_back(scans::Validity::Valid);
        }
        builder.add(block);
    }
    (void)builder.finish(Progress::none());
    return file;
}

Rigid3 pose_of(const app::demo::ScannerPose& pose) {
    Rigid3 rigid;
    for (Eigen::Index i = 0; i < 9; ++i) rigid.rotation(i / 3, i % 3) = pose.rotation[static_cast<std::size_t>(i)];
    rigid.translation = {pose.origin.x, pose.origin.y, pose.origin.z};
    return rigid;
}

/// Seconds of the parts of a fine alignment.
struct FineTimes {
    double reading = 0.0;
    double thinning = 0.0;
    double aligning = 0.0;
};

scans::FineResult align_stores(const scans::PointStore& target, const scans::PointStore& source, const Rigid3& start,
                               const scans::FineOptions& options, FineTimes& times) {
    // Both scans at once, each on a thread of its own.
    scans::FineOptions each = options;
    each.threads = 1;
    const auto how = options.threads > 1 ? std::launch::async : std::launch::deferred;
    double began = now();
    auto other = std::async(how, [&] { return app::points_of(source); });
    const Points target_points = app::points_of(target);
    const Points source_points = other.get();
    times.reading = now() - began;
    began = now();
    auto others = std::async(how, [&] { return scans::prepare_scan(source_points, each); });
    const auto prepared_target = scans::prepare_scan(target_points, each);
    const auto prepared_source = others.get();
    times.thinning = now() - began;
    began = now();
    auto result = scans::align_scans(prepared_target, prepared_source, start, options);
    times.aligning = now() - began;
    return result;
}

} // namespace

void bench_large_pair() {
    const Scratch scratch;
    app::demo::SimulationOptions simulation;
    simulation.size = app::demo::DemoSize::Medium;
    app::demo::DemoDig dig = app::demo::simulate(simulation, Progress::none());
    dig.site.scan_columns = 3600; // as in a large dig
    dig.site.scan_rows = 900;
    dig.plan.site.scan_columns = dig.site.scan_columns;
    dig.plan.site.scan_rows = dig.site.scan_rows;
    const auto simulated = app::demo::scan_surface(dig, 1, Progress::none());
    const auto target = scans::PointStore::open(store_of(simulated.at(0), scratch / "a.points"));
    const auto source = scans::PointStore::open(store_of(simulated.at(1), scratch / "b.points"));
    const Rigid3 right = pose_of(simulated[0].station.pose).inverse() * pose_of(simulated[1].station.pose);
    fmt::print("a pair of {} and {} points, stores open, two threads; {}\n", target.points(), source.points(),
               machine());
    scans::CoarseResult coarse;
    const double coarse_seconds = median_seconds(3, [&] {
        const app::FeatureView looks{scans::ProjectionKind::Equirectangular, true, false};
        auto other = std::async(std::launch::async, [&] { return app::features_of(source, looks); });
        const auto features = app::features_of(target, looks);
        coarse = scans::align_coarsely(features, other.get());
    });
    fmt::print("  {:<44} {:>8.2f} s  {}  {}\n", "coarse, one channel", coarse_seconds,
               apart(right, coarse.target_from_source), coarse.verdict);
    const Rigid3 start = coarse.is_accepted ? coarse.target_from_source : right;
    scans::FineOptions options;
    scans::FineResult fine;
    FineTimes times;
    const double fine_seconds = median_seconds(3, [&] { fine = align_stores(target, source, start, options, times); });
    fmt::print("  {:<44} {:>8.2f} s  {}  {}\n", "fine, reading and thinning included", fine_seconds,
               apart(right, fine.target_from_source), fine.verdict);
    fmt::print("    the last time {:.2f} s reading, {:.2f} s thinning and planes, {:.2f} s aligning in {} steps\n",
               times.reading, times.thinning, times.aligning, fine.iterations);
    std::fflush(stdout);
    options.threads = 1;
    const double began = now();
    const auto one = align_stores(target, source, start, options, times);
    fmt::print("  {:<44} {:>8.2f} s  {}\n", "the same with one thread", now() - began,
               one.target_from_source == fine.target_from_source && one.covariance == fine.covariance ? "the same bits"
                                                                                                      : "OTHER BITS");
    fmt::print("  peak {:.0f} MB\n", peak_mb());
    print_pcl(app::points_of(target), app::points_of(source), start, right, {0.0}, 0.25);
}

} // namespace planum::bench
